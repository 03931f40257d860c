#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_DEVICE_PARAMETERS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_DEVICE_PARAMETERS_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/angles.h>

#include <string>

namespace argos {

/*
 * Parameters of the devices that several types of robots have, from experiment files and
 * constructors.
 */

/** Range and bearing: `rab_range`, `rab_data_size`. */
struct SRABParameters {
  Real Range = 3.0;  // m, >= 0
  size_t DataSize = 10;  // bytes

  /** Reads the attributes that exist. @throws CARGoSException if one is out of range. */
  void Read(TConfigurationNode& robot);
  /** @param owner the robot, for messages. @throws CARGoSException if a value is out of range. */
  void Check(const std::string& owner) const;
  bool operator==(const SRABParameters&) const;
};

/** An omnidirectional camera: `omnidirectional_camera_aperture`. */
struct SOmnidirectionalCameraParameters {
  // half angle from the downward vertical, in (0, PI/2)
  CRadians Aperture = ToRadians(CDegrees(70.0));

  void Read(TConfigurationNode& robot);
  void Check(const std::string& owner) const;
  bool operator==(const SOmnidirectionalCameraParameters&) const;
};

/** A perspective camera: `<prefix>{front,aperture,focal_length,range}`. */
struct SPerspectiveCameraParameters {
  bool Front = true;  // true: looks ahead; false: looks up
  CRadians Aperture = ToRadians(CDegrees(30.0));  // half angle, in (0, PI/2)
  Real FocalLength = 0.035;  // m, > 0
  Real Range = 2.0;  // m, > 0

  /** @param prefix  of the attributes: "perspective_camera_", or "camera_" of an eye-bot. */
  void Read(TConfigurationNode& robot, const std::string& prefix = "perspective_camera_");
  void Check(const std::string& owner, const std::string& prefix = "perspective_camera_") const;
  bool operator==(const SPerspectiveCameraParameters&) const;
};

/** A battery, for robots without a child `<battery>`. */
struct SBatteryParameters {
  std::string Model;  // label of a discharge model; empty: the charge never falls

  /**
   * Checks the child `<battery>`, if it exists; MakeBattery() reads it later.
   * @throws CARGoSException if the model is unknown, or a value out of range.
   */
  void Read(TConfigurationNode& robot);
  /** @throws CARGoSException if the model is unknown. */
  void Check(const std::string& owner) const;
  bool operator==(const SBatteryParameters&) const;
};

/** Parameters of all devices of a robot; each type of robot uses those of its devices. */
struct SDeviceParameters {
  SRABParameters RAB;
  SOmnidirectionalCameraParameters OmnidirectionalCamera;
  SPerspectiveCameraParameters PerspectiveCamera;
  SBatteryParameters Battery;

  bool operator==(const SDeviceParameters&) const;
  bool operator!=(const SDeviceParameters& other) const { return !(*this == other); }
};

}  // namespace argos

#endif
