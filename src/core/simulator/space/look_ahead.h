#ifndef ARGOS3_CORE_SIMULATOR_SPACE_LOOK_AHEAD_H
#define ARGOS3_CORE_SIMULATOR_SPACE_LOOK_AHEAD_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <cstddef>
#include <vector>

namespace argos {

class CBodyIndex;
class CControllableEntity;
struct SAnchor;

/**
 * Prefetches the data of the robots that the loops of a tick will visit next.
 *
 * A loop over robots follows pointers from the robot to its devices, and sensing reads the solids
 * around each robot, which may be anywhere in the arena: the processor foresees neither. So while
 * the loop visits a robot, the cache lines that later ones need are prefetched, in stages: a stage
 * dereferences only what an earlier stage has prefetched. Nothing here changes a result. Private to
 * the tick; all prefetching of the program is in this class.
 */
class CLookAhead {
 public:
  /** Takes the robots of a space. To be called after robots, bodies or controllers have changed. */
  void SetRobots(const std::vector<CControllableEntity*>& robots);

  /** Prefetches an object: for other loops whose objects are in no order. */
  template <typename T>
  static void At(const T& object) {
    Prefetch(&object, sizeof(T));
  }

  /** To be called before robot @p number acts. */
  void BeforeAct(size_t number) const;
  /** To be called before robot @p number senses. */
  void BeforeSense(size_t number, const CBodyIndex& index) const;

 private:
  struct SRobot {
    const CControllableEntity* Robot;
    const SAnchor* Origin;  // of its body; null if it has none
  };
  static void Prefetch(const void* start, size_t bytes) {
    constexpr size_t kLine = 64;
    const char* const first = static_cast<const char*>(start);
    for (size_t offset = 0; offset < bytes; offset += kLine) {
      __builtin_prefetch(first + offset);
    }
    // the last byte of an unaligned range may be on one more line
    if (bytes > 1) {
      __builtin_prefetch(first + bytes - 1);
    }
  }
  static void PrefetchBetween(const void* begin, const void* end) {
    Prefetch(begin, static_cast<const char*>(end) - static_cast<const char*>(begin));
  }
  void PrefetchAround(const SRobot& robot, const CBodyIndex& index, bool lists) const;

  std::vector<SRobot> m_robots;  // in the order of the loops
};

}  // namespace argos

#endif
