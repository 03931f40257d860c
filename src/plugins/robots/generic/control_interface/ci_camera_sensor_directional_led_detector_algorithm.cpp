#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_directional_led_detector_algorithm.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

CCI_CameraSensorDirectionalLEDDetectorAlgorithm::SReading::SReading(const CColor& color,
                                                                    const CVector2& center)
    : Color(color), Center(center) {}

const std::vector<CCI_CameraSensorDirectionalLEDDetectorAlgorithm::SReading>&
CCI_CameraSensorDirectionalLEDDetectorAlgorithm::GetReadings() const {
  return m_tReadings;
}

void CCI_CameraSensorDirectionalLEDDetectorAlgorithm::WriteReadings(CLuaTable& table) const {
  table.SetNewRecords(m_tReadings, [](CLuaTable& record, const SReading& reading) {
    record.Set("color", reading.Color);
    record.Set("center", reading.Center);
  });
}

}  // namespace argos
