#include <argos3/plugins/robots/generic/simulator/device_parameters.h>

#include <argos3/plugins/simulator/entities/battery_equipped_entity.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>
#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/plugins/simulator/entities/warn_once.h>

namespace argos {

namespace {

// experiment files have degrees
void ReadAperture(TConfigurationNode& robot, const std::string& attribute, CRadians& aperture) {
  CDegrees degrees = ToDegrees(aperture);
  GetNodeAttributeOrDefault(robot, attribute, degrees, degrees);
  aperture = ToRadians(degrees);
}

}  // namespace

void SRABParameters::Read(TConfigurationNode& robot) {
  GetNodeAttributeOrDefault(robot, "rab_range", Range, Range);
  GetNodeAttributeOrDefault(robot, "rab_data_size", DataSize, DataSize);
  // the text is made for each robot only if it is needed
  if (!IsIn(kNotNegative, Range) || DataSize > CRABEquippedEntity::kMaxData) {
    Check(OwnerOf(robot));
  }
}

void SRABParameters::Check(const std::string& owner) const {
  RequireNotNegative(Range, owner, "rab_range (m)");
  RequireCount(DataSize, 0, CRABEquippedEntity::kMaxData, owner, "rab_data_size (bytes)");
}

void SOmnidirectionalCameraParameters::Read(TConfigurationNode& robot) {
  ReadAperture(robot, "omnidirectional_camera_aperture", Aperture);
  Check(OwnerOf(robot));
}

void SOmnidirectionalCameraParameters::Check(const std::string& owner) const {
  RequireAperture(Aperture, owner, "omnidirectional_camera_aperture");
}

void SPerspectiveCameraParameters::Read(TConfigurationNode& robot, const std::string& prefix) {
  GetNodeAttributeOrDefault(robot, prefix + "front", Front, Front);
  ReadAperture(robot, prefix + "aperture", Aperture);
  GetNodeAttributeOrDefault(robot, prefix + "focal_length", FocalLength, FocalLength);
  GetNodeAttributeOrDefault(robot, prefix + "range", Range, Range);
  Check(OwnerOf(robot), prefix);
}

void SPerspectiveCameraParameters::Check(const std::string& owner,
                                         const std::string& prefix) const {
  RequireAperture(Aperture, owner, prefix + "aperture");
  RequirePositive(FocalLength, owner, prefix + "focal_length (m)");
  RequirePositive(Range, owner, prefix + "range (m)");
}

void SBatteryParameters::Read(TConfigurationNode& robot) {
  if (!NodeExists(robot, "battery")) {
    return;
  }
  TConfigurationNode& battery = GetNode(robot, "battery");
  // documented by ARGoS 3, which does not read them either
  for (const auto& [attribute, right] :
       {std::pair<const char*, const char*>{"model", "\"discharge_model\""},
        {"factor", "an attribute of the model, such as \"delta\" of \"time\""}}) {
    if (NodeAttributeExists(battery, attribute)) {
      WarnOnce(OwnerOf(battery) + ": attribute \"" + attribute + "\" has no effect; use " + right);
    }
  }
  CBatteryEquippedEntity(nullptr).Configure(battery);
}

void SBatteryParameters::Check(const std::string& owner) const {
  if (Model.empty()) {
    return;
  }
  try {
    CBatteryEquippedEntity(nullptr).SetDischargeModel(Model);
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(owner << ": wrong battery", error);
  }
}

bool SRABParameters::operator==(const SRABParameters&) const = default;
bool SOmnidirectionalCameraParameters::operator==(const SOmnidirectionalCameraParameters&) const =
    default;
bool SPerspectiveCameraParameters::operator==(const SPerspectiveCameraParameters&) const = default;
bool SBatteryParameters::operator==(const SBatteryParameters&) const = default;
bool SDeviceParameters::operator==(const SDeviceParameters&) const = default;

}  // namespace argos
