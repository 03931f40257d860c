#ifndef ARGOS3_CORE_SIMULATOR_CONTEXT_ARENA_H
#define ARGOS3_CORE_SIMULATOR_CONTEXT_ARENA_H

#include <argos3/core/simulator/geometry/periodicity.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/** The extents of the arena, m, world frame. */
struct SArena {
  CVector3 Size;
  CVector3 Center;
  CRange<CVector3> Limits; /**< Center -+ Size / 2, as of loading */
  SPeriodicity Period; /**< which of its sides are joined */
};

}  // namespace argos

#endif
