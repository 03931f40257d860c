#include <argos3/plugins/robots/generic/simulator/placed_readings_sensor.h>

#include <argos3/core/simulator/entity/composable_entity.h>

namespace argos {

void RequireNumSensors(const CComposableEntity& robot, const char* device, const char* kind,
                       size_t needed, size_t num) {
  if (num != needed) {
    THROW_ARGOSEXCEPTION("sensor \"" << device << "\" needs a robot with " << needed << " " << kind
                                     << "; robot \"" << robot.GetId() << "\" has " << num);
  }
}

}  // namespace argos
