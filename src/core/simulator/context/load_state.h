#ifndef ARGOS3_CORE_SIMULATOR_CONTEXT_LOAD_STATE_H
#define ARGOS3_CORE_SIMULATOR_CONTEXT_LOAD_STATE_H

#include <argos3/core/control_interface/on_error.h>
#include <argos3/core/simulator/context/load_errors.h>
#include <argos3/core/utility/configuration/argos_configuration.h>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace argos {

/** A controller that an experiment declares. */
struct SControllerSetup {
  std::string Id;
  TConfigurationNode* Node = nullptr; /**< the child of `<controllers>` */
  std::optional<EOnError> OnError; /**< is that of this element, or else of `<experiment>` */
  mutable bool IsUsed = false; /**< a robot has it */
};

/** State of the loading of an experiment, and the controllers that the experiment declares. */
class CLoadState {
 public:
  /** Starts loading: clears the state of an earlier experiment. */
  void Begin();
  /** Ends loading. */
  void End() { m_loading = false; }
  bool IsLoading() const { return m_loading; }

  /** Of controllers that say nothing else. Before they are added. */
  void SetOnError(std::optional<EOnError> onError) { m_onError = onError; }
  /** Adds the child of `<controllers>` with that id. @throws CARGoSException if the id is taken. */
  void AddController(const std::string& id, TConfigurationNode& node);
  /**
   * That controller; valid as long as the experiment.
   * @throws CARGoSException with the nearest ids.
   */
  const SControllerSetup& GetSetup(const std::string& id) const;
  /** The controllers that no robot has had so far, in the order of their ids. */
  std::vector<const SControllerSetup*> ListUnusedControllers() const;
  /** The child of `<controllers>` with that id. @throws CARGoSException with the nearest ids. */
  TConfigurationNode& GetController(const std::string& id) const { return *GetSetup(id).Node; }

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
  std::optional<EOnError> m_onError;
  std::map<std::string, SControllerSetup> m_controllers;
  std::set<std::string> m_broken;  // ids of parts that failed
  std::vector<std::function<void()>> m_checks;
};

}  // namespace argos

#endif
