#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_omnidirectional_camera_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

namespace {

void Write(CLuaTable& camera, const CCI_ColoredBlobOmnidirectionalCameraSensor::TBlobList& blobs) {
  camera.SetNewRecords(
      blobs, [](CLuaTable& record, const CCI_ColoredBlobOmnidirectionalCameraSensor::SBlob* blob) {
        record.Set("distance", blob->Distance);
        record.Set("angle", blob->Angle);
        record.Set("color", blob->Color);
      });
}

}  // namespace

CCI_ColoredBlobOmnidirectionalCameraSensor::SBlob::SBlob() : SBlob(CColor(), CRadians(), 0.0) {}

CCI_ColoredBlobOmnidirectionalCameraSensor::SBlob::SBlob(const CColor& color, const CRadians& angle,
                                                         Real distance)
    : Color(color), Angle(angle), Distance(distance) {}

CCI_ColoredBlobOmnidirectionalCameraSensor::SReadings::SReadings() : Counter(0) {}

const CCI_ColoredBlobOmnidirectionalCameraSensor::SReadings&
CCI_ColoredBlobOmnidirectionalCameraSensor::GetReadings() const {
  return m_sReadings;
}

void CCI_ColoredBlobOmnidirectionalCameraSensor::CreateLuaState(lua_State* state) {
  CLuaTable camera(state, *this, "colored_blob_omnidirectional_camera");
  camera.AddMethod<&CCI_ColoredBlobOmnidirectionalCameraSensor::Enable>("enable", *this);
  camera.AddMethod<&CCI_ColoredBlobOmnidirectionalCameraSensor::Disable>("disable", *this);
  Write(camera, m_sReadings.BlobList);
}

void CCI_ColoredBlobOmnidirectionalCameraSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable camera(state, *this);
  Write(camera, m_sReadings.BlobList);
}

}  // namespace argos
