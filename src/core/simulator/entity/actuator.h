#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_ACTUATOR_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/memory/object_slabs.h>
#include <argos3/core/utility/plugins/factory.h>

namespace argos {

class CComposableEntity;

/**
 * Base class of simulated actuators; a concrete actuator also derives from its CCI_ class.
 *
 * Update() applies the controller's orders to components of its own robot: robots act in parallel,
 * without locks. It must not allocate in a settled tick.
 */
class CSimulatedActuator : public CSlabObject {
 public:
  virtual ~CSimulatedActuator() = default;
  /** Called once, before Init(): looks up the robot's components that the actuator needs. */
  virtual void SetRobot(CComposableEntity& robot) = 0;
  /** Called every tick before physics. */
  virtual void Update() = 0;
};

}  // namespace argos

#define REGISTER_ACTUATOR(CLASSNAME, LABEL, IMPLEMENTATION, AUTHOR, VERSION, BRIEF_DESCRIPTION,  \
                          LONG_DESCRIPTION, STATUS)                                              \
  REGISTER_SYMBOL(CSimulatedActuator, CLASSNAME, LABEL " (" IMPLEMENTATION ")", AUTHOR, VERSION, \
                  BRIEF_DESCRIPTION, LONG_DESCRIPTION, STATUS)

#endif
