#include <argos3/plugins/robots/generic/simulator/device_parameters.h>

#include <argos3/plugins/simulator/entities/value_checks.h>

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
  Check(OwnerOf(robot));
}

void SRABParameters::Check(const std::string& owner) const {
  RequireNotNegative(Range, owner, "rab_range (m)");
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
  const std::string owner = OwnerOf(battery);
  GetNodeAttributeOrDefault<std::string>(battery, "discharge_model", Model, "time");
  GetNodeAttributeOrDefault(battery, "start_charge", StartCharge, StartCharge);
  GetNodeAttributeOrDefault(battery, "full_charge", FullCharge, FullCharge);
  RequirePositive(FullCharge, owner, "full_charge");
  RequireNotNegative(StartCharge, owner, "start_charge");
  if (StartCharge > FullCharge) {
    THROW_ARGOSEXCEPTION(owner << ": start_charge must be at most full_charge (" << FullCharge
                               << "), got " << StartCharge);
  }
  // the model that uses both names its factors otherwise
  const bool both = Model == "time_motion";
  for (const auto& [attribute, value] :
       {std::pair<const char*, Real*>{both ? "time_factor" : "delta", &Delta},
        {both ? "pos_factor" : "pos_delta", &PositionDelta},
        {both ? "orient_factor" : "orient_delta", &OrientationDelta}}) {
    GetNodeAttributeOrDefault(battery, attribute, *value, *value);
    RequireNotNegative(*value, owner, attribute);
  }
}

bool SRABParameters::operator==(const SRABParameters&) const = default;
bool SOmnidirectionalCameraParameters::operator==(const SOmnidirectionalCameraParameters&) const =
    default;
bool SPerspectiveCameraParameters::operator==(const SPerspectiveCameraParameters&) const = default;
bool SBatteryParameters::operator==(const SBatteryParameters&) const = default;
bool SDeviceParameters::operator==(const SDeviceParameters&) const = default;

}  // namespace argos
