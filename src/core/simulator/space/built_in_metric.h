#ifndef ARGOS3_CORE_SIMULATOR_SPACE_BUILT_IN_METRIC_H
#define ARGOS3_CORE_SIMULATOR_SPACE_BUILT_IN_METRIC_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/plugins/factory.h>

#include <string>

namespace argos {

class CSpace;

/**
 * A metric that plug-ins compute without code of users. Its name is the label of the class; it is
 * computed only in experiments that ask for it (CMetrics::EnableBuiltIn()).
 */
class CBuiltInMetric {
 public:
  virtual ~CBuiltInMetric() = default;

  /**
   * Called once, when the arena is filled; the space outlives the metric.
   * @throws CARGoSException if the experiment has not what the metric is computed from.
   */
  virtual void Init(CSpace& space) = 0;
  /** The experiment was reset: Compute() will be called for its first state. */
  virtual void Reset() {}
  /**
   * Called on the main thread for the first state, and after each tick, when PostStep() is done and
   * entities are added and removed. Must not change the simulation; may use the thread pool. Not to
   * allocate memory in a settled tick.
   * @return the value; NaN: none.
   */
  virtual Real Compute() = 0;

  /** Such as "m"; empty for numbers without a unit. */
  virtual std::string GetUnit() const { return ""; }
  /** False if values differ between runs of the same experiment with the same seed. */
  virtual bool IsReproducible() const { return true; }
};

}  // namespace argos

/** Registers a built-in metric under its name; see REGISTER_SYMBOL. */
#define REGISTER_BUILT_IN_METRIC(CLASSNAME, NAME, AUTHOR, VERSION, BRIEF_DESCRIPTION,  \
                                 LONG_DESCRIPTION, STATUS)                             \
  REGISTER_SYMBOL(CBuiltInMetric, CLASSNAME, NAME, AUTHOR, VERSION, BRIEF_DESCRIPTION, \
                  LONG_DESCRIPTION, STATUS)

#endif
