#ifndef ARGOS3_CORE_SIMULATOR_CURRENT_H
#define ARGOS3_CORE_SIMULATOR_CURRENT_H

namespace argos {

class CSimulator;
class CSpace;

/**
 * The simulator that is being loaded or run by the calling thread.
 *
 * For what is made by zero-argument factories or by `new` in user code and needs its surroundings
 * while it initialises. Everything else is handed what it needs.
 */
CSimulator& CurrentSimulator();
/** The space of CurrentSimulator(). */
CSpace& CurrentSpace();

}  // namespace argos

#endif
