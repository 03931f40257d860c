#ifndef ARGOS3_CORE_SIMULATOR_CONTEXT_LOAD_STATE_H
#define ARGOS3_CORE_SIMULATOR_CONTEXT_LOAD_STATE_H

#include <argos3/core/simulator/context/load_errors.h>
#include <argos3/core/utility/configuration/argos_configuration.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace argos {

/** State of the loading of an experiment, and the controllers that the experiment declares. */
class CLoadState {
 public:
  /** Starts loading: clears the state of an earlier experiment. */
  void Begin();
  /** Ends loading. */
  void End() { m_loading = false; }
  bool IsLoading() const { return m_loading; }

  /** Adds the child of `<controllers>` with that id. @throws CARGoSException if the id is taken. */
  void AddController(const std::string& id, TConfigurationNode& node);
  /** The child of `<controllers>` with that id. @throws CARGoSException with the nearest ids. */
  TConfigurationNode& GetController(const std::string& id) const;

  /** See CSimulator::MarkBroken(). */
  void MarkBroken(const std::string& id);
  /** @throws CAlreadyReported if @p id is marked as failed. */
  void ThrowIfBroken(const std::string& id) const;

  /** See CSimulator::CheckWhenLoaded(). */
  void CheckWhenLoaded(std::function<void()> check);
  /** Calls the checks and removes them. */
  void RunChecks(CLoadErrors& errors);

  /** While probing, robots get no controller: the loader only needs their bodies. */
  bool IsProbing() const { return m_probing; }
  void SetProbing(bool probing) { m_probing = probing; }

 private:
  bool m_loading = false;
  bool m_probing = false;
  std::map<std::string, TConfigurationNode*> m_controllers;
  std::set<std::string> m_broken;  // ids of parts that failed
  std::vector<std::function<void()>> m_checks;
};

}  // namespace argos

#endif
