#ifndef ARGOS3_TESTING_SUPPORT_DEVICE_WORLD_H
#define ARGOS3_TESTING_SUPPORT_DEVICE_WORLD_H

#include <argos3/core/utility/math/vector3.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/device_list.h>

#include <string>
#include <vector>

/*
 * Worlds of foot-bots, e-pucks and eye-bots that use their devices; see CDeviceUser.
 */

namespace argos {

/** The devices that a robot has. @param carries  also those of what its element makes it carry. */
std::vector<SListedDevice> DevicesOf(const std::string& robot, bool carries = true);

/** The element of a device, with media as in MediaForDevices(). @param noisy  with all its noise.
 */
std::string DeviceText(const std::string& robot, const SListedDevice& device, bool noisy);

/**
 * The child of a robot's element that makes it carry what a device is about: "battery",
 * "directional_leds", "magnets", "rfid", "simple_radios" or "tags"; empty for all others.
 */
std::string CarriedText(const std::string& deviceTag);

/**
 * A controller "device_user" for a robot with the given devices. Of those that exclude each other
 * it has one: drift is preferred to an exact drive, and positions in the air to speeds.
 * @param id          of the controller.
 * @param parameters  attributes of <params>.
 */
std::string DeviceUserText(const std::string& id, const std::string& robot,
                           const std::vector<SListedDevice>& devices, bool noisy,
                           const std::string& parameters = "");
/**
 * A robot that carries all that it can and has the controller "user_<robot>"; messages are of 4
 * bytes.
 * @param position    m.
 * @param yaw         degrees.
 * @param attributes  of the robot's element.
 */
std::string DeviceUserRobotText(const std::string& robot, const std::string& id,
                                const CVector3& position, Real yaw,
                                const std::string& attributes = "rab_range='0.8'");

struct SDeviceWorld {
  UInt32 Robots = 90; /**< taking turns: "fb0", "ep1", "eb2", "fb3", ... */
  bool IsNoisy = true;
  std::string Parameters = ""; /**< attributes of <params> */
  /**
   * Also controllers "bare_<robot>" for robots that carry nothing, such as programs make, and one
   * such robot of each type: "fb_bare", "ep_bare", "eb_bare".
   */
  bool HasBareControllers = false;

  /**
   * All three robots with all their devices in rows, eye-bots above the others; every third
   * foot-bot has something to grip in front of it. There are walls, lights, and a striped floor.
   */
  SExperiment ToExperiment() const;
};

}  // namespace argos

#endif
