#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_PARAMETERS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_PARAMETERS_H

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
  Real Range = 0.0;  // m, >= 0
  size_t DataSize = 0;  // bytes

  /** Reads the attributes that are there. @throws CARGoSException if one is out of range. */
  void Read(TConfigurationNode& robot);
  /** @param owner whose they are, for messages. @throws CARGoSException if one is out of range. */
  void Check(const std::string& owner) const;
};

/** An omnidirectional camera: `omnidirectional_camera_aperture`. */
struct SOmnidirectionalCameraParameters {
  CRadians Aperture;  // half angle from the downward vertical, in (0, PI/2)

  void Read(TConfigurationNode& robot);
  void Check(const std::string& owner) const;
};

/** A perspective camera: `perspective_camera_{front,aperture,focal_length,range}`. */
struct SPerspectiveCameraParameters {
  bool Front = true;  // looks ahead, otherwise up
  CRadians Aperture;  // half angle, in (0, PI/2)
  Real FocalLength = 0.0;  // m, > 0
  Real Range = 0.0;  // m, > 0

  void Read(TConfigurationNode& robot);
  void Check(const std::string& owner) const;
};

}  // namespace argos

#endif
