#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_ODE_SESSION_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_ODE_SESSION_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/**
 * Prepares ODE for calls by this thread: once in the process, then once in each thread. Cheap when
 * done already. Never undone: other simulators of the process may be using ODE.
 */
void UseODEInThisThread();

/**
 * Sweeps of dWorldQuickStep for which ODE draws no random numbers: from the ninth on it shuffles
 * the constraints now and then.
 */
constexpr UInt32 kSweepsWithoutDrawing = 8;

/**
 * Does ODE draw from the generator of this library, which each thread has an own state of, in place
 * of its own, which all worlds of the process share? Where it does not, results would depend on
 * other threads beyond kSweepsWithoutDrawing. After UseODEInThisThread().
 */
bool HasOwnODERandom();

/**
 * Starts a sequence of random numbers that ODE draws in this thread: before every iterative step.
 * @param number  of the sequence.
 */
void SeedODE(UInt32 number);

/** What ODE has complained of in this thread first since the last call; null: of nothing. */
const char* TakeODEComplaint();

}  // namespace argos

#endif
