#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_ODE_SESSION_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_ODE_SESSION_H

namespace argos {

/**
 * Prepares ODE for calls by this thread: once in the process, then once in each thread. Cheap when
 * done already. Never undone: other simulators of the process may be using ODE.
 */
void UseODEInThisThread();

/** Has ODE complained in this thread since the last call? The text is that of the first time. */
const char* TakeODEComplaint();

}  // namespace argos

#endif
