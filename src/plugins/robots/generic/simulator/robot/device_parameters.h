#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_DEVICE_PARAMETERS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_DEVICE_PARAMETERS_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/angles.h>

#include <string>

namespace argos {

/*
 * What experiment files and constructors say of devices that several robots carry, for the sources
 * of robots.
 */

/** Range and bearing: `rab_range`, `rab_data_size`. */
struct SRABParameters {
  Real Range = 3.0;  // m, >= 0
  size_t DataSize = 10;  // bytes

  /** Reads the attributes that are there. @throws CARGoSException if one is out of range. */
  void Read(TConfigurationNode& robot);
  /** @param owner whose they are, for messages. @throws CARGoSException if one is out of range. */
  void Check(const std::string& owner) const;
  bool operator==(const SRABParameters&) const;
};

/** An omnidirectional camera: `omnidirectional_camera_aperture`. */
struct SOmnidirectionalCameraParameters {
  CRadians Aperture = ToRadians(CDegrees(70.0));  // half angle from the downward vertical,
                                                  // in (0, PI/2)

  void Read(TConfigurationNode& robot);
  void Check(const std::string& owner) const;
  bool operator==(const SOmnidirectionalCameraParameters&) const;
};

/** A perspective camera: `<prefix>{front,aperture,focal_length,range}`. */
struct SPerspectiveCameraParameters {
  bool Front = true;  // looks ahead, otherwise up
  CRadians Aperture = ToRadians(CDegrees(30.0));  // half angle, in (0, PI/2)
  Real FocalLength = 0.035;  // m, > 0
  Real Range = 2.0;  // m, > 0

  /** @param prefix  of the attributes: "perspective_camera_", or "camera_" of an eye-bot. */
  void Read(TConfigurationNode& robot, const std::string& prefix = "perspective_camera_");
  void Check(const std::string& owner, const std::string& prefix = "perspective_camera_") const;
  bool operator==(const SPerspectiveCameraParameters&) const;
};

/** A battery, of a robot without a child `<battery>`. */
struct SBatteryParameters {
  std::string Model;  // label of a discharge model; empty: the charge never falls

  /**
   * Checks the child `<battery>`, if it is there, from which the component is made later.
   * @throws CARGoSException if the model is unknown, or a value out of range.
   */
  void Read(TConfigurationNode& robot);
  /** @throws CARGoSException if there is no such model. */
  void Check(const std::string& owner) const;
  bool operator==(const SBatteryParameters&) const;
};

/** What the devices of a robot are like; each type of robot looks at its own. */
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
