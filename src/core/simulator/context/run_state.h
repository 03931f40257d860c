#ifndef ARGOS3_CORE_SIMULATOR_CONTEXT_RUN_STATE_H
#define ARGOS3_CORE_SIMULATOR_CONTEXT_RUN_STATE_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/non_copyable.h>

#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace argos {

/**
 * What a simulation is doing, and therefore what users' code may do meanwhile.
 *
 * - Nothing runs, between ticks: everything is possible, at once.
 * - A hook of the loop functions runs: entities are added and removed at once, and Reset() is
 *   possible; Destroy() etc. are errors.
 * - Robots act, sense or are controlled, or engines and media are updated: entities are added and
 *   removed at the end of the tick; Reset(), Destroy() etc. are errors.
 *   What robots change of their own components that other robots read is changed when all robots
 *   have been controlled; what they must not change is an error (CRobotsCode).
 * - Robots are reset, or an entity is removed: entities are added and removed when that is
 * complete; Reset(), Destroy() etc. are errors.
 * - The experiment is loaded: entities are added and removed at once; Reset(), Destroy() etc. are
 *   errors.
 *
 * "Destroy() etc." are also Execute(), UpdateSpace() and the loading of an experiment. Destroy() is
 * an error during Execute(), too.
 */
class CRunState : private CNonCopyable {
 public:
  enum class EActivity : UInt8 {
    None,
    Loading,
    Hook, /**< a hook of the loop functions runs in a tick */
    Phase, /**< a phase of a tick, or a loop over robots: several threads may run users' code */
    Changing, /**< entities are added and removed that were requested earlier */
    Resetting,
    Destroying
  };

  CRunState() = default;

  /** Sets the activity during its lifetime. Main thread, outside of phases. */
  class CScope : private CNonCopyable {
   public:
    CScope(CRunState& state, EActivity activity)
        : m_state(state), m_previous(std::exchange(state.m_activity, activity)) {}
    ~CScope() { m_state.m_activity = m_previous; }

   private:
    CRunState& m_state;
    EActivity m_previous;
  };

  /** The visualization runs during its lifetime. */
  class CExecution : private CNonCopyable {
   public:
    explicit CExecution(CRunState& state) : m_state(state) { state.m_isExecuting = true; }
    ~CExecution() { m_state.m_isExecuting = false; }

   private:
    CRunState& m_state;
  };

  bool IsInPhase() const { return m_activity == EActivity::Phase; }
  /** True if Defer() must be used: entities must be neither added nor removed now. */
  bool DefersChanges() const {
    return IsInPhase() || m_activity == EActivity::Changing || m_activity == EActivity::Destroying;
  }

  /** @throws CARGoSException unless nothing runs. @param call  as in "CSimulator::Destroy()". */
  void CheckIsIdle(const char* call) const;
  /** The same, and Execute() must not be running. */
  void CheckIsIdleAndNotExecuting(const char* call) const;
  /** @throws CARGoSException unless nothing or a hook of the loop functions runs. */
  void CheckAllowsReset() const;
  /** @throws CARGoSException if a phase runs. @param hint  what is possible instead. */
  void CheckIsNotInPhase(const char* call, const char* hint) const;

  /**
   * Notes a change for the end of the tick. Any thread. Changes are applied in the order of the
   * robots that request them, and those of one robot in the order of the requests: the order does
   * not depend on threads.
   */
  void Defer(std::function<void()> change);
  /**
   * The same for a change of the requesting robot's own components, which is applied when all
   * robots have been sensed and controlled, before PostStep().
   */
  void DeferComponentChange(std::function<void()> change);
  /**
   * The same as Defer() for the removal of @p entity, which is only compared.
   * @throws CARGoSException if the robot that runs now has already requested it in this tick: code
   *   that removes until nothing is left would never end.
   */
  void DeferRemoval(const void* entity, std::function<void()> change);
  /**
   * Applies the noted changes, and those that they cause. Main thread, outside of phases. Does
   * nothing if the changes are already being applied.
   * @throws the exception of the first change that fails, with the requester; later ones are
   *   dropped.
   */
  void ApplyChanges();
  /** The same for changes of components. Main thread, after a loop over robots. */
  void ApplyComponentChanges();
  /** Drops the noted changes: after an error, or when everything is destroyed. */
  void DiscardChanges();

 private:
  struct SChange {
    UInt64 Place;  // place of the robot in the order of the tick
    std::string Requester;
    std::function<void()> Apply;
  };

  [[noreturn]] void Refuse(const char* call, const char* hint) const;
  bool Take(std::vector<SChange>& noted, std::vector<SChange>& changes);
  void Apply(std::vector<SChange>& noted);

  EActivity m_activity = EActivity::None;
  bool m_isExecuting = false;
  std::mutex m_mutex;  // guards what follows; locked only by code that changes the space
  std::vector<SChange> m_changes;
  std::vector<SChange> m_componentChanges;
  std::set<std::pair<UInt64, const void*>> m_removals;  // hashes of requesters, and entities
};

}  // namespace argos

#endif
