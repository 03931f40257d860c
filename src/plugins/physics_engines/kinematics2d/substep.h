#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_SUBSTEP_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_SUBSTEP_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/** A part of a tick in which bodies move once. */
struct SSubstep {
  Real Duration;  // s
  Real LateShare;  // of the duration, in [0, 1]: robots still follow the commands of the last tick
  bool IsLast;  // of the tick
};

}  // namespace argos

#endif
