#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_POINT_MASS_HANDLE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_POINT_MASS_HANDLE_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/slot_generations.h>

#include <limits>

namespace argos {

/**
 * The place of a body in the arrays of its kind; the engine writes it whenever it changes. A copy
 * is stale from then on, which ARGOS_ASSERT notices.
 */
struct SPointMassHandle {
  static constexpr UInt32 kNowhere = std::numeric_limits<UInt32>::max();

  UInt32 Slot = kNowhere;
  UInt32 Generation = 0;  // which of the bodies that had the slot
};

/** Base of the arrays of bodies: their handles. */
class CPointMassHandles {
 public:
  SPointMassHandle GetHandle(UInt32 number) const { return {number, m_generations.Get(number)}; }
  /** The number of a body whose handle is not stale. */
  UInt32 GetNumber(const SPointMassHandle& handle) const {
    m_generations.Check(handle);
    return handle.Slot;
  }
  /** @return true if the body of the handle still has its number. */
  bool IsCurrent(const SPointMassHandle& handle) const {
    return m_generations.IsCurrent(handle.Slot, handle.Generation);
  }

 protected:
  ~CPointMassHandles() = default;

  CSlotGenerations m_generations;
};

}  // namespace argos

#endif
