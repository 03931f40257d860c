#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>

#include <argos3/plugins/robots/generic/control_interface/placed_readings.h>

namespace argos {

CRadians CCI_EPuckProximitySensor::GetAngle(UInt32 index) {
  // PI divided by these is the angle, in [0, 2 PI)
  constexpr Real kDivisors[kNumSensors] = {10.5884, 3.5999, 2.0,    1.2,
                                           0.8571,  0.6667, 0.5806, 0.5247};
  return CRadians(CRadians::PI / kDivisors[index]).SignedNormalize();
}

CCI_EPuckProximitySensor::CCI_EPuckProximitySensor() {
  m_tReadings = MakeReadings<SReading>(kNumSensors, GetAngle);
}

void CCI_EPuckProximitySensor::CreateLuaState(lua_State* state) {
  CLuaTable proximity(state, *this, "proximity");
  WriteAngularReadings(proximity, m_tReadings);
}

void CCI_EPuckProximitySensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable proximity(state, *this);
  WriteAngularReadings(proximity, m_tReadings);
}

}  // namespace argos
