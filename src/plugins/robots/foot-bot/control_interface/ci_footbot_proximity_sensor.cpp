#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>

#include <argos3/plugins/robots/generic/control_interface/placed_readings_impl.h>

namespace argos {

// ARGoS 3 has the same numbers
const SSensorPlaces<CRadians> CCI_FootBotProximitySensor::kPlaces = {
    "footbot_proximity", "proximity", 24, &GetAngleOnRing<24>};

template class CPlacedSensors<CAngularReadings<CCI_FootBotProximitySensor>>;

}  // namespace argos
