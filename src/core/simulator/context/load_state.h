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

/** What is known of an experiment while it is being loaded, and the controllers that it declares.
 */
class CLoadState {
 public:
  /** Loading begins; what was known of an earlier experiment is forgotten. */
  void Begin();
  /** Everything is loaded. */
  void End() { m_loading = false; }

  /** Takes the child of `<controllers>` with that id. @throws CARGoSException if the id is taken.
   */
  void AddController(const std::string& id, TConfigurationNode& node);
  /** The child of `<controllers>` with that id. @throws CARGoSException with the nearest ids. */
  TConfigurationNode& GetController(const std::string& id) const;

  /** See CSimulator::MarkBroken(). */
  void MarkBroken(const std::string& id);
  /** @throws CAlreadyReported if @p id is marked as failed. */
  void ThrowIfBroken(const std::string& id) const;

  /** See CSimulator::CheckWhenLoaded(). */
  void CheckWhenLoaded(std::function<void()> check);
  /** Calls and forgets the checks. */
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
