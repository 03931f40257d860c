#include <argos3/testing/support/device_world.h>

#include <argos3/core/utility/math/angles.h>
#include <argos3/testing/support/arena_text.h>
#include <argos3/testing/support/robot_sizes.h>
#include <argos3/testing/support/robot_world.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace argos {

namespace {

constexpr Real kSpacing = 0.35;  // m, between robots on the ground
constexpr Real kFlightSpacing = 0.6;  // m, between robots in the air
constexpr Real kHeight = 0.8;  // m, of robots in the air
constexpr Real kLoadRadius = 0.05;  // m

const std::map<std::string, std::string>& CarriedThings() {
  static const std::map<std::string, std::string> things = {
      {"battery", "<battery discharge_model='time_motion'/>"},
      {"directional_leds",
       "<directional_leds medium='directional_leds'><directional_led position='0.09,0,0.2' "
       "orientation='0,90,0' anchor='origin' observable_angle='70' color='red'/><directional_led "
       "position='-0.09,0,0.2' orientation='0,-90,0' anchor='origin' observable_angle='70'/>"
       "</directional_leds>"},
      {"magnets",
       "<magnets><magnet id='front' anchor='origin' offset='0,0,0' passive_field='1,0,0' "
       "active_field='0,2,0'/></magnets>"},
      {"rfid", "<rfid_tags medium='rfid'><rfid_tag memory='4'/></rfid_tags>"},
      {"simple_radios",
       "<simple_radios><simple_radio id='wifi' medium='radios' range='0.7' position='0,0,0.1'/>"
       "</simple_radios>"},
      {"tags",
       "<tags medium='tags'><tag position='0.1,0,0.2' orientation='90,90,0' anchor='origin' "
       "observable_angle='60' side_length='0.03'/></tags>"}};
  return things;
}

std::string Noise(bool noisy, const std::string& attributes) {
  return noisy ? "<noise model='gaussian' " + attributes + "/>" : "";
}

// a camera behind a robot on the ground that looks back, or below a
// robot in the air that looks down
std::string Camera(const std::string& robot, bool noisy) {
  const std::string noise = Noise(noisy, "std_dev='1'");
  const std::string pose = robot == "eye-bot" ? "position='0,0,-0.01' orientation='0,180,0'"
                                              : "position='-0.09,0,0.17' orientation='90,-90,0'";
  return "<camera id='camera' anchor='origin' " + pose +
         " range='0.05:2' focal_length='300,300' principal_point='320,240' resolution='640,480'>"
         "<led_detector medium='leds'>" +
         noise + "</led_detector><directional_led_detector medium='directional_leds'>" + noise +
         "</directional_led_detector><tag_detector medium='tags'>" + noise +
         "</tag_detector></camera>";
}

// required attributes of a device's element
std::string RequiredAttributes(const SListedDevice& device) {
  return " " + device.More.substr(0, device.More.find('>'));
}

// noise attributes of devices without <noise> children
std::string NoiseAttributes(const SListedDevice& device) {
  static const std::map<std::string, std::string> attributes = {
      {"colored_blob_omnidirectional_camera", "noise_std_dev='0.05'"},
      {"colored_blob_perspective_camera", "noise_std_dev='0.05'"},
      {"range_and_bearing (medium)", "noise_std_dev='0.01' packet_drop_prob='0.1'"},
      {"rfid sensors", "miss_prob='0.1'"}};
  for (const std::string& key : {device.Tag, device.Label(), device.Tag + " " + device.Section}) {
    const auto found = attributes.find(key);
    if (found != attributes.end()) {
      return " " + found->second;
    }
  }
  return "";
}

bool TakesNoise(const SListedDevice& device) {
  static const std::set<std::string> without = {"ceiling_attachment", "directional_leds", "leds",
                                                "simple_radios", "tags"};
  return without.count(device.Tag) == 0 && device.Label() != "range_and_bearing (default)" &&
         !(device.Tag == "rfid" && device.Section == "actuators");
}

const std::map<std::string, std::string> kPrefixes = {
    {"foot-bot", "fb"}, {"e-puck", "ep"}, {"eye-bot", "eb"}};

// the n-th position in a square lattice
CVector3 PlaceOf(UInt32 n, UInt32 total, Real spacing, Real height) {
  const auto perRow =
      std::max(1U, static_cast<UInt32>(std::ceil(std::sqrt(static_cast<Real>(total)))));
  const Real middle = 0.5 * spacing * (perRow - 1);
  return CVector3(spacing * (n % perRow) - middle,
                  spacing * static_cast<UInt32>(n / perRow) - middle, height);
}

std::string LoadText(const std::string& id, const CVector3& robot, Real yaw) {
  const Real angle = ToRadians(CDegrees(yaw)).GetValue();
  const Real distance = kFootBotRadius + kLoadRadius + 0.002;
  const CVector3 place =
      robot + CVector3(distance * std::cos(angle), distance * std::sin(angle), 0);
  return "<cylinder id='" + id + "' radius='" + ToText(kLoadRadius) +
         "' height='0.15' movable='true' mass='0.5'><body " + PoseText(place) + "/></cylinder>";
}

}  // namespace

std::vector<SListedDevice> DevicesOf(const std::string& robot, bool carries) {
  std::vector<SListedDevice> devices;
  for (const SListedDevice& device : ListedDevices()) {
    // every robot has a battery and can read the tags of others
    const bool isCarried =
        device.Tag != "battery" && device.Tag != "rfid" && !CarriedText(device.Tag).empty();
    if (device.IsOf(robot) && (carries || !isCarried)) {
      devices.push_back(device);
    }
  }
  return devices;
}

std::string CarriedText(const std::string& deviceTag) {
  const auto found = CarriedThings().find(deviceTag);
  return found != CarriedThings().end() ? found->second : "";
}

std::string DeviceText(const std::string& robot, const SListedDevice& device, bool noisy) {
  std::string text = "<" + device.Tag + " implementation='" + device.Implementation + "'" +
                     RequiredAttributes(device) + (noisy ? NoiseAttributes(device) : "") + ">";
  if (device.Tag == "cameras") {
    text += Camera(robot, noisy);
  } else if (TakesNoise(device)) {
    text += Noise(noisy, "std_dev='0.02'");
  }
  return text + "</" + device.Tag + ">\n";
}

std::string DeviceUserText(const std::string& id, const std::string& robot,
                           const std::vector<SListedDevice>& devices, bool noisy,
                           const std::string& parameters) {
  std::map<std::string, std::string> bySection;
  for (const SListedDevice& device : devices) {
    const bool givesWay =
        device.Section == "actuators" && (device.Label() == "differential_steering (default)" ||
                                          device.Label() == "quadrotor_speed (default)");
    if (!givesWay) {
      bySection[device.Section] += DeviceText(robot, device, noisy);
    }
  }
  return "<device_user id='" + id + "'><actuators>" + bySection["actuators"] +
         "</actuators><sensors>" + bySection["sensors"] + "</sensors><params " + parameters +
         "/></device_user>";
}

std::string DeviceUserRobotText(const std::string& robot, const std::string& id,
                                const CVector3& position, Real yaw, const std::string& attributes) {
  std::string text = "<" + robot + " id='" + id + "' rab_data_size='4' " + attributes + "><body " +
                     PoseText(position, yaw) + "/><controller config='user_" + robot + "'/>";
  for (const auto& thing : CarriedThings()) {
    text += thing.second;
  }
  return text + "</" + robot + ">\n";
}

SExperiment SDeviceWorld::ToExperiment() const {
  const std::string types[] = {"foot-bot", "e-puck", "eye-bot"};
  SExperiment experiment;
  for (const std::string& robot : types) {
    experiment.Controllers +=
        DeviceUserText("user_" + robot, robot, DevicesOf(robot), IsNoisy, Parameters);
    if (HasBareControllers) {
      experiment.Controllers +=
          DeviceUserText("bare_" + robot, robot, DevicesOf(robot, false), IsNoisy, Parameters);
    }
  }
  experiment.LoopFunctions = "<loop_functions label='striped_floor' />";
  experiment.Engines = "<dynamics2d id='ground' /><pointmass3d id='air' />";
  experiment.Media = MediaForDevices();
  experiment.Arena = "<floor id='floor' source='loop_functions' pixels_per_meter='10' />";
  const UInt32 flying = Robots / 3;
  for (UInt32 i = 0; i < Robots; ++i) {
    const std::string& robot = types[i % 3];
    const bool flies = i % 3 == 2;
    const CVector3 place =
        flies ? PlaceOf(i / 3, flying, kFlightSpacing, kHeight)
              : PlaceOf(i - i / 3 - (i % 3 == 2 ? 1 : 0), Robots - flying, kSpacing, 0.0);
    const Real yaw = 37.0 * i;
    experiment.Arena +=
        DeviceUserRobotText(robot, kPrefixes.at(robot) + std::to_string(i), place, yaw);
    if (i % 9 == 0) {
      experiment.Arena += LoadText("load" + std::to_string(i), place, yaw);
    }
  }
  for (const std::string& robot : types) {
    if (HasBareControllers) {
      const CVector3 place(robot == "e-puck" ? 4.6 : 4.3, 4.3, robot == "eye-bot" ? kHeight : 0.0);
      experiment.Arena += "<" + robot + " id='" + kPrefixes.at(robot) +
                          "_bare' rab_data_size='4' rab_range='0.8'><body " + PoseText(place) +
                          "/><controller config='bare_" + robot + "'/></" + robot + ">";
    }
  }
  const UInt32 driving = Robots - flying;
  const Real edge = PlaceOf(0, driving, kSpacing, 0.0).Length();
  // between four robots
  const CVector3 gap =
      PlaceOf(driving / 2, driving, kSpacing, 0.0) + CVector3(0.5 * kSpacing, 0.5 * kSpacing, 0.0);
  experiment.Arena += LightText("lamp0", CVector3(edge, 0.0, 0.5), "yellow") +
                      LightText("lamp1", CVector3(-0.5 * edge, edge, 2.0), "white") +
                      BoxText("wall", CVector3(0.05, 1.0, 0.3), CVector3(edge, 0.3, 0.0)) +
                      PillarText("pillar", gap.GetX(), gap.GetY(), 0.03, 0.3);
  return experiment;
}

}  // namespace argos
