#ifndef ARGOS3_CORE_SIMULATOR_TICK_LOOK_AHEAD_H
#define ARGOS3_CORE_SIMULATOR_TICK_LOOK_AHEAD_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/memory/load_ahead.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace argos {

class CBodyIndex;
class CControllableEntity;
struct SAnchor;

/** A robot in a loop of a tick. Loops are in the order of creation, which is that of memory. */
struct SRobotVisit {
  CControllableEntity* Robot;
  UInt32 Number; /**< index in CSpace::GetControllableEntities() */
};

/**
 * Prefetches the data of the robots that the loops of a tick will visit next.
 *
 * A loop over robots follows pointers from the robot to its devices, and sensing reads the solids
 * around each robot, which may be anywhere in the arena: hardware prefetchers predict neither. So
 * while the loop visits a robot, the cache lines that later robots need are prefetched in stages: a
 * stage dereferences only what an earlier stage has loaded. Has no effect on results.
 */
class CLookAhead {
 public:
  /**
   * Sets the loops. To be called after robots, bodies or controllers have changed.
   * @param visits  is read by the functions below.
   */
  void SetVisits(const std::vector<SRobotVisit>& visits);

  /** To be called before the robot of a visit acts. */
  void BeforeAct(size_t visit) const;
  /** To be called before the robot of a visit senses. */
  void BeforeSense(size_t visit, const CBodyIndex& index) const;

 private:
  struct SRobot {
    const SAnchor* Origin;  // origin anchor of its body; null if it has none
    UInt32 EndOfMemory;  // end in m_memory; it begins where that of the robot before ends
  };
  // SMemory in one word: there are several for each robot. A range that does not fit is not
  // prefetched correctly, which costs time only.
  class CPackedMemory {
   public:
    CPackedMemory(const SMemory& memory)
        : m_start(reinterpret_cast<UInt64>(memory.Start)),
          m_bytes(std::min<size_t>(memory.Bytes, (1U << 16) - 1)) {}
    void Load() const {
      LoadAhead(reinterpret_cast<const void*>(static_cast<UInt64>(m_start)), m_bytes);
    }

   private:
    UInt64 m_start : 48;
    UInt64 m_bytes : 16;
  };
  static_assert(sizeof(CPackedMemory) == sizeof(void*) && sizeof(void*) == sizeof(UInt64));

  const CControllableEntity& GetRobot(size_t visit) const { return *(*m_visits)[visit].Robot; }

  const std::vector<SRobotVisit>* m_visits = nullptr;
  std::vector<SRobot> m_robots;  // has the same order; empty if there are few
  std::vector<CPackedMemory> m_memory;  // memory that only the robot's sensors use
};

}  // namespace argos

#endif
