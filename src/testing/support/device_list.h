#ifndef ARGOS3_TESTING_SUPPORT_DEVICE_LIST_H
#define ARGOS3_TESTING_SUPPORT_DEVICE_LIST_H

#include <string>
#include <vector>

namespace argos {

/** A device as published with ARGoS 3, or one of this project's own. */
struct SListedDevice {
  std::string Section; /**< "actuators" or "sensors" */
  std::string Tag;
  std::string Implementation;
  /** Types of the robots that have it, separated by blanks. */
  std::string Robots;
  /** What else its element needs: attributes, and after a ">" children. */
  std::string More = "";

  /** In the factory. */
  std::string Label() const { return Tag + " (" + Implementation + ")"; }
  /** Has a robot of that type the device? */
  bool IsOf(const std::string& robot) const {
    return (" " + Robots + " ").find(" " + robot + " ") != std::string::npos;
  }
  /** Its element. */
  std::string ToXml() const;
};

/** Every device, with every robot that has it. */
const std::vector<SListedDevice>& ListedDevices();

/** The types of robots. */
const std::vector<std::string>& ListedRobots();

/**
 * XML of what the experiments of these devices need: the media "leds", "rab", "radios",
 * "directional_leds", "tags", "rfid" and "pheromone" with the layer "trail".
 */
std::string MediaForDevices();

/**
 * XML of a robot with the controller @p config that carries what devices of any robot need: a radio
 * "wifi", a magnet "front", two directional LEDs and two tags, which face back.
 */
std::string RobotForDevices(const std::string& type, const std::string& id,
                            const std::string& position, const std::string& config);

}  // namespace argos

#endif
