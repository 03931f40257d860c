#include <argos3/plugins/robots/generic/simulator/device_parameters.h>

#include <argos3/plugins/simulator/entities/value_checks.h>

namespace argos {

namespace {

void RequireAperture(const CRadians& aperture, const std::string& owner, const std::string& what) {
  const CDegrees degrees = ToDegrees(aperture);
  if (!(degrees > CDegrees(0.0) && degrees < CDegrees(90.0))) {
    THROW_ARGOSEXCEPTION(owner << ": " << what << " must be between 0 and 90 degrees, got "
                               << degrees.GetValue());
  }
}

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

void SPerspectiveCameraParameters::Read(TConfigurationNode& robot) {
  GetNodeAttributeOrDefault(robot, "perspective_camera_front", Front, Front);
  ReadAperture(robot, "perspective_camera_aperture", Aperture);
  GetNodeAttributeOrDefault(robot, "perspective_camera_focal_length", FocalLength, FocalLength);
  GetNodeAttributeOrDefault(robot, "perspective_camera_range", Range, Range);
  Check(OwnerOf(robot));
}

void SPerspectiveCameraParameters::Check(const std::string& owner) const {
  RequireAperture(Aperture, owner, "perspective_camera_aperture");
  RequirePositive(FocalLength, owner, "perspective_camera_focal_length (m)");
  RequirePositive(Range, owner, "perspective_camera_range (m)");
}

}  // namespace argos
