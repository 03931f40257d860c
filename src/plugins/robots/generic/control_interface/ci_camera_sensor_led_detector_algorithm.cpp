#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_led_detector_algorithm.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

CCI_CameraSensorLEDDetectorAlgorithm::SReading::SReading(const CColor& color,
                                                         const CVector2& center)
    : Color(color), Center(center) {}

const std::vector<CCI_CameraSensorLEDDetectorAlgorithm::SReading>&
CCI_CameraSensorLEDDetectorAlgorithm::GetReadings() const {
  return m_tReadings;
}

void CCI_CameraSensorLEDDetectorAlgorithm::WriteReadings(CLuaTable& table) const {
  table.SetNewRecords(m_tReadings, [](CLuaTable& record, const SReading& reading) {
    record.Set("color", reading.Color);
    record.Set("center", reading.Center);
  });
}

}  // namespace argos
