#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_SENSOR_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/memory/load_ahead.h>
#include <argos3/core/utility/memory/object_slabs.h>
#include <argos3/core/utility/plugins/factory.h>

#include <vector>

namespace argos {

class CComposableEntity;

/**
 * Base class of simulated sensors; a concrete sensor also derives from its CCI_ class.
 *
 * Update() may read the space, but write only to its own robot: robots sense in parallel, without
 * locks. It must not allocate in a settled tick.
 */
class CSimulatedSensor : public CSlabObject {
 public:
  virtual ~CSimulatedSensor() = default;
  /** Called once, before Init(): looks up the robot's components that the sensor needs. */
  virtual void SetRobot(CComposableEntity& robot) = 0;
  /** Called every tick after physics and media, unless the sensor was disabled. */
  virtual void Update() = 0;
  /**
   * Not in ARGoS 3. Appends memory apart from the sensor that Update() uses for this robot only,
   * such as an array of readings, which the tick then prefetches. Called when the robots of the
   * space have changed: what is reallocated later is not prefetched.
   */
  virtual void ListMemory(std::vector<SMemory>& /*memory*/) const {}
};

}  // namespace argos

#define REGISTER_SENSOR(CLASSNAME, LABEL, IMPLEMENTATION, AUTHOR, VERSION, BRIEF_DESCRIPTION,  \
                        LONG_DESCRIPTION, STATUS)                                              \
  REGISTER_SYMBOL(CSimulatedSensor, CLASSNAME, LABEL " (" IMPLEMENTATION ")", AUTHOR, VERSION, \
                  BRIEF_DESCRIPTION, LONG_DESCRIPTION, STATUS)

#endif
