#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_HALF_PLANES_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_HALF_PLANES_H

#include <argos3/plugins/simulator/physics_engines/planar/separation.h>

#include <array>

namespace argos {

/** The steps s with Normal * s <= Limit. */
struct SHalfPlane {
  SPlanarVector Normal;  // of unit length
  Real Limit;  // m, >= 0: a step of length 0 is always allowed
  UInt32 Id;  // determines the order of processing
  // m; requested step against the normal, because of an overlap; without a default, so that an
  // array of half planes costs nothing until they are added
  Real Push;
};

/** The steps that several half planes allow. */
class CHalfPlanes {
 public:
  void Clear() { m_size = 0; }
  /** @return false if the capacity is exhausted. */
  bool Add(const SHalfPlane& plane) {
    if (m_size == m_planes.size()) {
      return false;
    }
    m_planes[m_size++] = plane;
    return true;
  }
  bool IsEmpty() const { return m_size == 0; }
  /** Sorts the planes by id, so that the result does not depend on the order of Add() calls. */
  void Sort();
  /** The sum of the steps that overlaps request, in the order of the planes. */
  SPlanarVector SumPushes() const;
  /**
   * The allowed step that is nearest to @p target.
   *
   * Source: M. de Berg et al., Computational Geometry (2008), ch. 4.4, incremental linear
   * programming, with the distance as the goal, as in J. van den Berg et al., Reciprocal n-Body
   * Collision Avoidance (2011).
   */
  SPlanarVector FindNearest(const SPlanarVector& target) const;

 private:
  bool FindOnLine(size_t number, const SPlanarVector& target, SPlanarVector& step) const;

  std::array<SHalfPlane, 64> m_planes;
  size_t m_size = 0;
};

}  // namespace argos

#endif
