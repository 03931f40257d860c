#ifndef ARGOS3_TESTING_SUPPORT_FITTING_DEVICES_H
#define ARGOS3_TESTING_SUPPORT_FITTING_DEVICES_H

#include <string>
#include <vector>

namespace argos {

/** A device that a robot supports, with its description. */
struct SFittingDevice {
  std::string Label; /**< "tag (implementation)" */
  std::string Kind; /**< "actuator" or "sensor" */
  std::string Brief, Long;
};

/**
 * The devices of this project that accept a robot in SetRobot(): actuators, then sensors, each
 * sorted by label. Devices that need an optional component of the robot's element are not included.
 * @param robot  label of a robot. A simulator must be current.
 */
std::vector<SFittingDevice> FittingDevices(const std::string& robot);

}  // namespace argos

#endif
