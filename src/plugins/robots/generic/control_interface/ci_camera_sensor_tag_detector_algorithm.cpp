#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_tag_detector_algorithm.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

CCI_CameraSensorTagDetectorAlgorithm::SReading::SReading() = default;

CCI_CameraSensorTagDetectorAlgorithm::SReading::SReading(const std::string& payload,
                                                         const CVector2& center,
                                                         const std::array<CVector2, 4>& corners)
    : Payload(payload), Center(center), Corners(corners) {}

const std::vector<CCI_CameraSensorTagDetectorAlgorithm::SReading>&
CCI_CameraSensorTagDetectorAlgorithm::GetReadings() const {
  return m_tReadings;
}

void CCI_CameraSensorTagDetectorAlgorithm::WriteReadings(CLuaTable& table) const {
  table.SetNewRecords(m_tReadings, [](CLuaTable& record, const SReading& reading) {
    record.Set("payload", reading.Payload);
    record.Set("center", reading.Center);
    CLuaTable corners = record.GetTable("corners");
    for (size_t i = 0; i < reading.Corners.size(); ++i) {
      corners.Set(i + 1, reading.Corners[i]);
    }
  });
}

}  // namespace argos
