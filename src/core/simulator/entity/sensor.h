#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_SENSOR_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/memory/object_slabs.h>
#include <argos3/core/utility/plugins/factory.h>

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
};

}  // namespace argos

#define REGISTER_SENSOR(CLASSNAME, LABEL, IMPLEMENTATION, AUTHOR, VERSION, BRIEF_DESCRIPTION,  \
                        LONG_DESCRIPTION, STATUS)                                              \
  REGISTER_SYMBOL(CSimulatedSensor, CLASSNAME, LABEL " (" IMPLEMENTATION ")", AUTHOR, VERSION, \
                  BRIEF_DESCRIPTION, LONG_DESCRIPTION, STATUS)

#endif
