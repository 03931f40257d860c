#ifndef ARGOS3_CORE_SIMULATOR_CURRENT_H
#define ARGOS3_CORE_SIMULATOR_CURRENT_H

namespace argos {

class CSimulator;
class CSpace;

/**
 * Returns the simulator that the calling thread is loading or running.
 *
 * For objects created by zero-argument factories or by `new` in user code, which need it during
 * initialisation. All other code gets its dependencies as arguments.
 */
CSimulator& CurrentSimulator();
/** The space of CurrentSimulator(). */
CSpace& CurrentSpace();

}  // namespace argos

#endif
