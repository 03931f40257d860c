#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>

#include <argos3/plugins/robots/generic/control_interface/placed_readings_impl.h>

namespace argos {

CRadians CCI_EPuckProximitySensor::GetAngle(UInt32 index) {
  // PI divided by these is the angle, in [0, 2 PI)
  constexpr Real kDivisors[kNumSensors] = {10.5884, 3.5999, 2.0,    1.2,
                                           0.8571,  0.6667, 0.5806, 0.5247};
  return CRadians(CRadians::PI / kDivisors[index]).SignedNormalize();
}

const SSensorPlaces<CRadians> CCI_EPuckProximitySensor::kPlaces = {"epuck_proximity", "proximity",
                                                                   kNumSensors, &GetAngle};

template class CPlacedSensors<CAngularReadings<CCI_EPuckProximitySensor>>;

}  // namespace argos
