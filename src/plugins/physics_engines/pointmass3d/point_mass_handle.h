#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_POINT_MASS_HANDLE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_POINT_MASS_HANDLE_H

#include <argos3/plugins/simulator/physics_engines/robot_bodies/slot_generations.h>

namespace argos {

/** The kind of a body, which is not in the handle, is known by its model. */
using SPointMassHandle = SSlotHandle;

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
