#ifndef ARGOS3_CORE_SIMULATOR_ACTUATOR_H
#define ARGOS3_CORE_SIMULATOR_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/memory/object_slabs.h>
#include <argos3/core/utility/plugins/factory.h>

namespace argos {

class CComposableEntity;

/**
 * The simulated side of an actuator; a concrete actuator also derives from its CCI_ class.
 *
 * Update() writes what the controller ordered into the robot's own components: robots act in
 * parallel, without locks. It must not allocate once settled.
 */
class CSimulatedActuator : public CSlabObject {
 public:
  virtual ~CSimulatedActuator() = default;
  /** Called once, before Init(): fetches what the actuator needs of the robot's components. */
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
