#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_omnidirectional_camera_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_ColoredBlobOmnidirectionalCameraSensor::WriteReadings(CLuaTable& table) const {
  table.SetNewRecords(m_sReadings.BlobList, [](CLuaTable& record, const SBlob* blob) {
    record.Set("distance", blob->Distance);
    record.Set("angle", blob->Angle);
    record.Set("color", blob->Color);
  });
}

}  // namespace argos
