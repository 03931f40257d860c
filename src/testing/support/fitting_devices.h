#ifndef ARGOS3_TESTING_SUPPORT_FITTING_DEVICES_H
#define ARGOS3_TESTING_SUPPORT_FITTING_DEVICES_H

#include <string>
#include <vector>

namespace argos {

/** A device of a robot, and what it says of itself. */
struct SFittingDevice {
  std::string Label; /**< "tag (implementation)" */
  std::string Kind; /**< "actuator" or "sensor" */
  std::string Brief, Long;
};

/**
 * The devices of this project that accept a robot in SetRobot(): actuators, then sensors, each by
 * label. A device that needs what a robot only has if its element says so does not.
 * @param robot  label of a robot. A simulator must be current.
 */
std::vector<SFittingDevice> FittingDevices(const std::string& robot);

}  // namespace argos

#endif
