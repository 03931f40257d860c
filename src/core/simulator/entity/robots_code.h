#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_ROBOTS_CODE_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_ROBOTS_CODE_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/non_copyable.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <utility>

namespace argos {

class CEntity;

/**
 * Guard of what robots share.
 *
 * Sensors and controllers, and callbacks of IterateOverControllableEntities(), run for several
 * robots at the same time and in no order. So they must not change what other robots read: a public
 * function that changes such data begins with one of these checks. They apply for any number of
 * threads, so that no result depends on it.
 *
 * - What no other robot reads meanwhile, such as wheel speeds: the robot that owns the entity may
 *   change it at once; CheckOwn().
 * - What devices of other robots read, such as colours: the same, but it takes effect when all
 *   robots have been controlled, before PostStep(); ChangesLater().
 * - Anything else, such as poses: no robot may change it; CheckShared().
 * What a robot may not change is an error.
 *
 * An entity that is not in the space yet is not shared: everything is possible. Errors are
 * CARGoSExceptions with the caller, the function and what to do instead.
 */
class CRobotsCode {
 public:
  /** A loop over robots, in any simulation of the process. */
  class CLoop : private CNonCopyable {
   public:
    CLoop() { s_numLoops.fetch_add(1, std::memory_order_relaxed); }
    ~CLoop() { s_numLoops.fetch_sub(1, std::memory_order_relaxed); }
  };

  /**
   * @return false if no loop runs in the process: the checks would then do nothing. One load; for
   *   functions that engines, media and actuators call often.
   */
  static bool MayRun() { return s_numLoops.load(std::memory_order_relaxed) != 0; }

  /** @return true if the calling thread runs robots' code. */
  static bool IsRunning();

  /**
   * @param call  as in "CSpace::SetArenaSize()".
   * @param hint  what to do instead; null: it is possible in hooks of the loop functions.
   */
  static void CheckShared(const char* call, const char* hint = nullptr);
  static void CheckShared(const CEntity& entity, const char* call);
  static void CheckOwn(const CEntity& entity, const char* call);

  /**
   * In code of the robot that owns the entity, notes a change for the time when all robots have
   * been controlled, before PostStep().
   * @return false if the caller must make the change now.
   */
  template <typename CHANGE>
  [[nodiscard]] static bool ChangesLater(const CEntity& entity, const char* call, CHANGE&& change) {
    if (!MayRun() || !IsOwner(entity, call)) {
      return false;
    }
    ChangeLater(std::function<void()>(std::forward<CHANGE>(change)));
    return true;
  }

  /**
   * In robots' code, locks what is created at its first request, such as components, during the
   * lifetime of the result: several robots may request it of the same entity.
   */
  static std::unique_lock<std::recursive_mutex> LockLazy();

 private:
  static bool IsOwner(const CEntity& entity, const char* call);
  static void ChangeLater(std::function<void()> change);

  static std::atomic<UInt32> s_numLoops;
};

/**
 * CRobotsCode::ChangesLater() for SetEnabled() of entities in media.
 * @return false if the caller must enable or disable the entity now.
 */
[[nodiscard]] bool EnablesLater(CEntity& entity, bool enabled);

}  // namespace argos

#endif
