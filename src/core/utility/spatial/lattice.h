#ifndef ARGOS3_CORE_UTILITY_SPATIAL_LATTICE_H
#define ARGOS3_CORE_UTILITY_SPATIAL_LATTICE_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/ray3.h>
#include <argos3/core/utility/spatial/grid_axis.h>

#include <cmath>

namespace argos {

/** Numbers of a cell along the three axes. */
struct SCellNumber {
  SInt32 Axis[3];

  bool operator==(const SCellNumber& other) const {
    return Axis[0] == other.Axis[0] && Axis[1] == other.Axis[1] && Axis[2] == other.Axis[2];
  }
  void Get(SInt32& i, SInt32& j, SInt32& k) const {
    i = Axis[0];
    j = Axis[1];
    k = Axis[2];
  }
};

/**
 * Space divided into equal cells along each axis; those at the ends of the range of numbers reach
 * to infinity.
 */
struct SLattice {
  Real Origin[3]; /**< corner of cell (0,0,0), m */
  Real CellSize[3]; /**< m, > 0 */
  SCellNumber MinCell; /**< lowest numbers */
  SCellNumber MaxCell; /**< highest numbers */

  /** Number along one axis of the cell that holds a coordinate, m; see ClampToCells(). */
  SInt32 NumberOf(Real coordinate, UInt32 axis) const {
    return ClampToCells((coordinate - Origin[axis]) / CellSize[axis], MinCell.Axis[axis],
                        MaxCell.Axis[axis]);
  }

  SCellNumber CellOf(const CVector3& position) const {
    return {
        {NumberOf(position.GetX(), 0), NumberOf(position.GetY(), 1), NumberOf(position.GetZ(), 2)}};
  }
};

/**
 * Calls visit(SInt32 i, SInt32 j, SInt32 k) for each cell of a box until that returns false.
 * @param min, max  corners of the box; the first number runs fastest, then the second.
 */
template <typename VISIT>
void ForCellsInBox(const SCellNumber& min, const SCellNumber& max, VISIT&& visit) {
  for (SInt32 k = min.Axis[2]; k <= max.Axis[2]; ++k) {
    for (SInt32 j = min.Axis[1]; j <= max.Axis[1]; ++j) {
      for (SInt32 i = min.Axis[0]; i <= max.Axis[0]; ++i) {
        if (!visit(i, j, k)) {
          return;
        }
      }
    }
  }
}

/**
 * Calls visit(const SCellNumber&) for each cell that a ray crosses, from its start to its end,
 * until that returns false.
 *
 * Source: J. Amanatides and A. Woo, "A fast voxel traversal algorithm for ray tracing",
 * Eurographics 1987; each crossing is computed from its plane instead of summed up, so that errors
 * do not grow.
 */
template <typename VISIT>
void WalkLattice(const SLattice& lattice, const CRay3& ray, VISIT&& visit) {
  SCellNumber cell = lattice.CellOf(ray.GetStart());
  const CVector3 direction = ray.GetEnd() - ray.GetStart();
  // fraction of the ray at which it leaves the cell through the next plane along an axis
  const auto crossing = [&](UInt32 axis) -> Real {
    const Real d = direction[axis];
    const SInt32 number = cell.Axis[axis];
    if (d > 0.0 && number < lattice.MaxCell.Axis[axis]) {
      const Real plane = lattice.Origin[axis] + (number + 1.0) * lattice.CellSize[axis];
      return (plane - ray.GetStart()[axis]) / d;
    }
    if (d < 0.0 && number > lattice.MinCell.Axis[axis]) {
      const Real plane = lattice.Origin[axis] + number * lattice.CellSize[axis];
      return (plane - ray.GetStart()[axis]) / d;
    }
    return HUGE_VAL;
  };
  Real next[3] = {crossing(0), crossing(1), crossing(2)};
  while (visit(static_cast<const SCellNumber&>(cell))) {
    UInt32 axis = next[1] < next[0] ? 1 : 0;
    axis = next[2] < next[axis] ? 2 : axis;
    if (!(next[axis] <= 1.0)) {
      return;
    }
    cell.Axis[axis] += direction[axis] > 0.0 ? 1 : -1;
    next[axis] = crossing(axis);
  }
}

}  // namespace argos

#endif
