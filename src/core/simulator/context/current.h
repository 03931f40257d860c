#ifndef ARGOS3_CORE_SIMULATOR_CONTEXT_CURRENT_H
#define ARGOS3_CORE_SIMULATOR_CONTEXT_CURRENT_H

namespace argos {

class CSimulator;
class CSpace;
struct SSimulationContext;

/**
 * Returns the simulator that the calling thread is loading or running.
 *
 * For objects created by zero-argument factories or by `new` in user code, which need it during
 * initialisation. All other code gets its dependencies as arguments.
 *
 * All three are defined beside CSimulator, which alone depends on all of them.
 */
CSimulator& CurrentSimulator();
/** The space of CurrentSimulator(). */
CSpace& CurrentSpace();
/** What the parts of CurrentSimulator() share. */
SSimulationContext& CurrentContext();

}  // namespace argos

#endif
