#ifndef ARGOS3_CORE_SIMULATOR_LOADED_SIMULATORS_H
#define ARGOS3_CORE_SIMULATOR_LOADED_SIMULATORS_H

// private: which simulator a thread outside of any CSimulator::CScope means

#include <argos3/core/utility/math/rng.h>

namespace argos {

class CSimulator;

/**
 * The simulators of this process that have an experiment, from the start of its loading to the end
 * of its destruction. All functions may be called by any thread.
 */
class CLoadedSimulators {
 public:
  /**
   * Adds a simulator, which the calling thread loads.
   * @param registry  of its random categories; shared with other threads while it is the only one.
   */
  static void Add(CSimulator& simulator, CRandom::CRegistry& registry);
  /** Removes it, if it was added. */
  static void Remove(const CSimulator& simulator);

  /**
   * The only simulator with an experiment; of several, the one that the calling thread has loaded
   * last. Takes no lock unless there are several.
   * @return null if none has an experiment.
   * @throws CARGoSException if the calling thread has loaded none of several.
   */
  static CSimulator* FindForThisThread();
};

}  // namespace argos

#endif
