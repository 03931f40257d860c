#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_front_camera_sensor.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/wrappers/lua/lua_table.h>
#include <argos3/plugins/robots/pi-puck/control_interface/pipuck_transform.h>

#include <string>

namespace argos {

namespace {

void RequirePositive(const CVector2& value, const char* attribute, TConfigurationNode& tree) {
  if (!(value.GetX() > 0.0 && value.GetY() > 0.0)) {
    THROW_ARGOSEXCEPTION(tree.GetLocation()
                         << ": <" << tree.Value() << ">: attribute \"" << attribute
                         << "\" must be two numbers > 0, got " << value);
  }
}

}  // namespace

const CVector3 CCI_PiPuckFrontCameraSensor::POSITION_OFFSET(0.0363, 0.0, 0.0275);
const Real CCI_PiPuckFrontCameraSensor::DEFAULT_ROTATION = 0.0;
const CVector2 CCI_PiPuckFrontCameraSensor::DEFAULT_RESOLUTION(640.0, 480.0);
const CVector2 CCI_PiPuckFrontCameraSensor::DEFAULT_FOCAL_LENGTH(1000.0, 1000.0);

CCI_PiPuckFrontCameraSensor::STag::STag(UInt32 id, const CVector3& position,
                                        const CQuaternion& orientation, const CVector2& center,
                                        const std::array<CVector2, 4>& corners)
    : Id(id), Position(position), Orientation(orientation), Center(center), Corners(corners) {}

void CCI_PiPuckFrontCameraSensor::Init(TConfigurationNode& tree) {
  CCI_Sensor::Init(tree);
  CDegrees rotation(DEFAULT_ROTATION);
  GetNodeAttributeOrDefault(tree, "rotation", rotation, rotation);
  m_cOrientationOffset = CQuaternion(CRadians::PI_OVER_TWO, CVector3::Y) *
                         CQuaternion(ToRadians(rotation), CVector3::Z);
  GetNodeAttributeOrDefault(tree, "resolution", m_cResolution, DEFAULT_RESOLUTION);
  GetNodeAttributeOrDefault(tree, "principal_point", m_cPrincipalPoint, m_cResolution * 0.5);
  GetNodeAttributeOrDefault(tree, "focal_length", m_cFocalLength, DEFAULT_FOCAL_LENGTH);
  RequirePositive(m_cResolution, "resolution", tree);
  RequirePositive(m_cFocalLength, "focal_length", tree);
}

void CCI_PiPuckFrontCameraSensor::WriteConstants(CLuaTable& table) {
  table.AddMethod<&CCI_Sensor::Enable>("enable", static_cast<CCI_Sensor&>(*this));
  table.AddMethod<&CCI_Sensor::Disable>("disable", static_cast<CCI_Sensor&>(*this));
  table.AddFunction("detect_led", *this,
                    [](CCI_PiPuckFrontCameraSensor& self, const CVector3& position) {
                      return SLuaInteger{static_cast<SInt64>(self.DetectLed(position))};
                    });
  table.Set("resolution", m_cResolution);
  WriteTransform(table, POSITION_OFFSET, m_cOrientationOffset, "origin");
}

void CCI_PiPuckFrontCameraSensor::WriteReadings(CLuaTable& table) const {
  table.Set("timestamp", GetTimestamp());
  CLuaTable tags = table.GetTable("tags");
  tags.SetNewRecords(GetTags(), [](CLuaTable& record, const STag& tag) {
    record.Set("id", SLuaInteger{tag.Id});
    record.Set("position", tag.Position);
    record.Set("orientation", tag.Orientation);
    record.Set("center", tag.Center);
    CLuaTable corners = record.GetTable("corners");
    for (std::size_t i = 0; i < tag.Corners.size(); ++i) {
      corners.Set(i + 1, tag.Corners[i]);
    }
  });
}

void CCI_PiPuckFrontCameraSensor::ListNumbers(CNumberList& list) const {
  list.Add("count", "", static_cast<Real>(GetTags().size()));
}

}  // namespace argos
