#include <argos3/plugins/simulator/visualizations/live/run/device_marks.h>

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/outputs/root_components.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_omnidirectional_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>
#include <argos3/plugins/simulator/visualizations/live/run/entity_values.h>

namespace argos {

namespace {

constexpr size_t kMaxMarks = 200;
constexpr Real kMetresPerCm = 0.01;

TJson MakeMark(const char* kind, const std::string& label, Real range, const CRadians& bearing,
               const CRadians& elevation) {
  return {{"kind", kind},
          {"sensor", label},
          {"range", kMetresPerCm * range},
          {"bearing", bearing.GetValue()},
          {"elevation", elevation.GetValue()}};
}

void AddBlobs(const std::string& label, const CCI_ColoredBlobOmnidirectionalCameraSensor& camera,
              TJson& marks) {
  for (const SOmnidirectionalBlob* const blob : camera.GetReadings().BlobList) {
    if (marks.size() >= kMaxMarks) {
      return;
    }
    TJson mark = MakeMark("blob", label, blob->Distance, blob->Angle, CRadians::ZERO);
    mark["color"] = {blob->Color.GetRed(), blob->Color.GetGreen(), blob->Color.GetBlue()};
    marks.push_back(std::move(mark));
  }
}

void AddMessages(const std::string& label, const CCI_RangeAndBearingSensor& sensor, TJson& marks) {
  for (const CCI_RangeAndBearingSensor::SPacket& packet : sensor.GetReadings()) {
    if (marks.size() >= kMaxMarks) {
      return;
    }
    marks.push_back(
        MakeMark("message", label, packet.Range, packet.HorizontalBearing, packet.VerticalBearing));
  }
}

}  // namespace

TJson ReadDeviceMarks(CEntity& root) {
  TJson marks = TJson::array();
  auto* const robot = FindExisting<CControllableEntity>(root);
  if (robot == nullptr || !robot->HasController()) {
    return marks;
  }
  for (const auto& [label, sensor] : robot->GetController().GetAllSensors()) {
    if (const auto* const camera =
            dynamic_cast<const CCI_ColoredBlobOmnidirectionalCameraSensor*>(sensor)) {
      AddBlobs(label, *camera, marks);
    } else if (const auto* const messages =
                   dynamic_cast<const CCI_RangeAndBearingSensor*>(sensor)) {
      AddMessages(label, *messages, marks);
    }
  }
  return marks;
}

TJson ReadLight(CEntity& root) {
  const auto* const robot = FindExisting<CControllableEntity>(root);
  if (robot == nullptr || !robot->HasController() ||
      !robot->GetController().HasSensor("footbot_light")) {
    return nullptr;
  }
  return ReadField(root, "readings:footbot_light");
}

}  // namespace argos
