#ifndef ARGOS3_TESTING_SUPPORT_DEVICE_WORLD_H
#define ARGOS3_TESTING_SUPPORT_DEVICE_WORLD_H

#include <argos3/core/utility/math/vector3.h>
#include <argos3/testing/support/device_list.h>
#include <argos3/testing/support/experiment.h>

#include <string>
#include <vector>

/* Worlds of foot-bots, e-pucks and eye-bots that use their devices; see CDeviceUser. */

namespace argos {

/**
 * The devices of a robot. @param carries  includes those that need a child of the robot's element.
 */
std::vector<SListedDevice> DevicesOf(const std::string& robot, bool carries = true);

/** XML of a device with the media of MediaForDevices(). @param noisy  with all kinds of noise. */
std::string DeviceText(const std::string& robot, const SListedDevice& device, bool noisy);

/**
 * XML of the child of a robot's element that a device needs: "battery", "directional_leds",
 * "magnets", "rfid", "simple_radios" or "tags"; empty for all others.
 */
std::string CarriedText(const std::string& deviceTag);

/**
 * XML of a controller "device_user" for a robot with the given devices. Of devices that
 * exclude each other it has one: dead reckoning rather than the default drive, and position
 * orders rather than speed orders.
 * @param id          of the controller.
 * @param parameters  attributes of <params>.
 */
std::string DeviceUserText(const std::string& id, const std::string& robot,
                           const std::vector<SListedDevice>& devices, bool noisy,
                           const std::string& parameters = "");
/**
 * XML of a robot with all components that it can carry and the controller
 * "user_<robot>"; messages have 4 bytes.
 * @param position    m.
 * @param yaw         degrees.
 * @param attributes  of the robot's element.
 */
std::string DeviceUserRobotText(const std::string& robot, const std::string& id,
                                const CVector3& position, Real yaw,
                                const std::string& attributes = "rab_range='0.8'");

struct SDeviceWorld {
  UInt32 Robots = 90; /**< of alternating types: "fb0", "ep1", "eb2", "fb3", ... */
  bool IsNoisy = true;
  std::string Parameters = ""; /**< attributes of <params> */
  /**
   * Adds controllers "bare_<robot>" for robots without these components, such as programs create,
   * and one such robot of each type: "fb_bare", "ep_bare", "eb_bare".
   */
  bool HasBareControllers = false;

  /**
   * All three robots with all their devices in rows, eye-bots above the others; every third
   * foot-bot has a load in front of it. There are walls, lights, and a striped floor.
   */
  SExperiment ToExperiment() const;
};

}  // namespace argos

#endif
