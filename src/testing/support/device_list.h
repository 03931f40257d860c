#ifndef ARGOS3_TESTING_SUPPORT_DEVICE_LIST_H
#define ARGOS3_TESTING_SUPPORT_DEVICE_LIST_H

#include <string>
#include <vector>

namespace argos {

/** A device as published with ARGoS 3, or of this project. */
struct SListedDevice {
  std::string Section; /**< "actuators" or "sensors" */
  std::string Tag;
  std::string Implementation;
  /** Types of the robots that support it, separated by blanks. */
  std::string Robots;
  /** Further attributes that its element needs, and after a ">" its children. */
  std::string More = "";

  /** Label in the factory. */
  std::string Label() const { return Tag + " (" + Implementation + ")"; }
  /** @return true if robots of that type support the device. */
  bool IsOf(const std::string& robot) const {
    return (" " + Robots + " ").find(" " + robot + " ") != std::string::npos;
  }
  /** XML of its element. */
  std::string ToXml() const;
};

/** All devices with the robots that support them. */
const std::vector<SListedDevice>& ListedDevices();

/** All types of robots of the loaded plug-ins, but for robots as data. */
const std::vector<std::string>& ListedRobots();

/**
 * XML of the media that experiments with these devices need: "leds", "rab", "radios",
 * "directional_leds", "tags", "rfid" and "pheromone" with the layer "trail".
 */
std::string MediaForDevices();

/**
 * XML of a robot with the controller @p config and the components that devices of any robot need: a
 * radio "wifi", a magnet "front", two directional LEDs and two tags, which face back.
 */
std::string RobotForDevices(const std::string& type, const std::string& id,
                            const std::string& position, const std::string& config);

}  // namespace argos

#endif
