#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_perspective_camera_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

namespace {

void Write(CLuaTable& camera, const CCI_ColoredBlobPerspectiveCameraSensor::TBlobList& blobs) {
  camera.SetNewRecords(
      blobs, [](CLuaTable& record, const CCI_ColoredBlobPerspectiveCameraSensor::SBlob* blob) {
        record.Set("x", blob->X);
        record.Set("y", blob->Y);
        record.Set("color", blob->Color);
      });
}

}  // namespace

CCI_ColoredBlobPerspectiveCameraSensor::SBlob::SBlob() : SBlob(CColor(), 0, 0) {}

CCI_ColoredBlobPerspectiveCameraSensor::SBlob::SBlob(const CColor& color, SInt32 x, SInt32 y)
    : Color(color), X(x), Y(y) {}

CCI_ColoredBlobPerspectiveCameraSensor::SReadings::SReadings() : Counter(0) {}

const CCI_ColoredBlobPerspectiveCameraSensor::SReadings&
CCI_ColoredBlobPerspectiveCameraSensor::GetReadings() const {
  return m_sReadings;
}

void CCI_ColoredBlobPerspectiveCameraSensor::CreateLuaState(lua_State* state) {
  CLuaTable camera(state, *this, "colored_blob_perspective_camera");
  camera.AddMethod<&CCI_ColoredBlobPerspectiveCameraSensor::Enable>("enable", *this);
  camera.AddMethod<&CCI_ColoredBlobPerspectiveCameraSensor::Disable>("disable", *this);
  Write(camera, m_sReadings.BlobList);
}

void CCI_ColoredBlobPerspectiveCameraSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable camera(state, *this);
  Write(camera, m_sReadings.BlobList);
}

}  // namespace argos
