#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_proximity_sensor.h>

#include <argos3/plugins/robots/generic/control_interface/placed_readings_impl.h>

namespace argos {

// ARGoS 3 has the same numbers
const SSensorPlaces<CRadians> CCI_EyeBotProximitySensor::kPlaces = {"eyebot_proximity", "proximity",
                                                                    24, &GetAngleOnRing<24>};

template class CPlacedSensors<CAngularReadings<CCI_EyeBotProximitySensor>>;

}  // namespace argos
