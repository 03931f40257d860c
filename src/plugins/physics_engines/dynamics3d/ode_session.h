#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_ODE_SESSION_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_ODE_SESSION_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/**
 * Prepares ODE for calls by this thread: once in the process, then once in each thread. Cheap if
 * already done. Never undone, because other simulators of the process may use ODE.
 */
void UseODEInThisThread();

/**
 * Sweeps of dWorldQuickStep in which ODE draws no random numbers: from the ninth on it sometimes
 * shuffles the constraints.
 */
constexpr UInt32 kSweepsWithoutDrawing = 8;

/**
 * @return true if ODE draws from the generator of this library, which has a state per thread,
 * instead of its own, which all worlds of the process share. If false, results would depend on
 * other threads beyond kSweepsWithoutDrawing. To be called after UseODEInThisThread().
 */
bool HasOwnODERandom();

/**
 * Seeds the random numbers that ODE draws in this thread; called before every iterative step.
 * @param number  of the sequence.
 */
void SeedODE(UInt32 number);

/** The first error message of ODE in this thread since the last call; null if there is none. */
const char* TakeODEError();

}  // namespace argos

#endif
