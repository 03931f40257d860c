#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_ODE_SESSION_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_ODE_SESSION_H

#include <argos3/core/utility/datatypes/datatypes.h>

struct dxWorld;

namespace argos {

/**
 * Prepares ODE for calls by this thread: once in the process, then once in each thread. Cheap if
 * already done. Never undone, because other simulators of the process may use ODE.
 */
void UseODEInThisThread();

/**
 * Calls dWorldQuickStep(). The random numbers that it draws are those of a sequence: the same in
 * every thread, whatever other worlds draw at the same time, and in whatever order the libraries of
 * the process were loaded.
 *
 * Safe in several threads, each with a world of its own. They run at the same time if ODE's calls
 * of dRand() bind to the function of this library, and one after the other if they do not.
 * @param duration  of the step, s.
 * @param sequence  number of the random sequence.
 */
void StepODEIteratively(dxWorld* world, Real duration, UInt32 sequence);

/**
 * True if ODE's calls of dRand() bind to the function of this library, whose state belongs to the
 * calling thread; false if they bind to ODE's own, whose state belongs to the process. After
 * UseODEInThisThread().
 */
bool IsODERandomReplaced();

/** The first error message of ODE in this thread since the last call; null if there is none. */
const char* TakeODEError();

}  // namespace argos

#endif
