#include <argos3/testing/support/device_list.h>

#include <argos3/core/simulator/entity/entity.h>

namespace argos {

namespace {

const char* const kAll = "foot-bot e-puck eye-bot";
const char* const kEvery = "foot-bot e-puck eye-bot pipuck";
const char* const kPiPuck = "pipuck";
const char* const kWheeled = "foot-bot e-puck";
const char* const kFootBot = "foot-bot";
const char* const kEyeBot = "eye-bot";
// Both rings have 24 sensors at the same angles: the sensor of one robot also works on the other.
const char* const kSwarmanoid = "foot-bot eye-bot";

const char* const kCamera =
    ">"
    "<camera id='front' anchor='origin' position='0,0,0.3' orientation='-90,90,0' range='0.05:2' "
    "focal_length='500,500' principal_point='320,240' resolution='640,480'>"
    "<led_detector medium='leds'/><directional_led_detector medium='directional_leds'/>"
    "<tag_detector medium='tags'/></camera>";

}  // namespace

std::string SListedDevice::ToXml() const {
  const size_t children = More.find('>');
  const std::string head = "<" + Tag + " implementation='" + Implementation + "' ";
  if (children == std::string::npos) {
    return head + More + "/>";
  }
  return head + More + "</" + Tag + ">";
}

const std::vector<SListedDevice>& ListedDevices() {
  static const std::vector<SListedDevice> devices = {
      {"actuators", "differential_steering", "default", kWheeled},
      {"actuators", "leds", "default", kAll, "medium='leds'"},
      {"actuators", "range_and_bearing", "default", kAll},
      {"actuators", "footbot_gripper", "default", kFootBot},
      {"actuators", "gripper", "default", kFootBot},
      {"actuators", "footbot_turret", "default", kFootBot},
      {"actuators", "footbot_distance_scanner", "default", kSwarmanoid},
      {"actuators", "quadrotor_position", "default", kEyeBot},
      {"actuators", "quadrotor_speed", "default", kEyeBot},
      {"actuators", "ceiling_attachment", "default", kEyeBot},
      {"actuators", "directional_leds", "default", kEvery},
      {"actuators", "tags", "default", kAll},
      {"actuators", "simple_radios", "default", kEvery},
      {"actuators", "magnets", "default", kAll},
      {"sensors", "differential_steering", "default", kWheeled},
      {"sensors", "proximity", "default", kAll},
      {"sensors", "footbot_proximity", "default", kSwarmanoid},
      {"sensors", "eyebot_proximity", "default", kSwarmanoid},
      {"sensors", "epuck_proximity", "default", "e-puck"},
      {"sensors", "light", "default", kAll},
      {"sensors", "footbot_light", "rot_z_only", kSwarmanoid},
      {"sensors", "eyebot_light", "rot_z_only", kSwarmanoid},
      {"sensors", "ground", "rot_z_only", kWheeled},
      {"sensors", "footbot_base_ground", "rot_z_only", kFootBot},
      {"sensors", "footbot_motor_ground", "rot_z_only", kFootBot},
      {"sensors", "footbot_distance_scanner", "rot_z_only", kSwarmanoid},
      {"sensors", "footbot_turret_encoder", "default", kFootBot},
      {"sensors", "colored_blob_omnidirectional_camera", "rot_z_only", kFootBot, "medium='leds'"},
      {"sensors", "colored_blob_perspective_camera", "default", kSwarmanoid, "medium='leds'"},
      {"sensors", "range_and_bearing", "medium", kAll, "medium='rab'"},
      {"sensors", "battery", "default", kAll},
      {"sensors", "positioning", "default", kEvery},
      {"sensors", "simple_radios", "default", kEvery},
      {"sensors", "cameras", "default", kEvery, kCamera},
      // declared in ARGoS 3 without implementation, or not part of it
      {"actuators", "differential_steering", "dead_reckoning", kWheeled},
      {"actuators", "pan_tilt_camera", "default", kSwarmanoid},
      {"sensors", "altitude", "default", kEvery},
      {"sensors", "clock", "default", kEvery},
      {"sensors", "footbot_encoder", "default", kFootBot},
      {"actuators", "rfid", "medium", kEvery, "medium='rfid' range='0.5'"},
      {"sensors", "rfid", "medium", kEvery, "medium='rfid' range='0.5'"},
      {"actuators", "pheromone", "medium", kEvery, "medium='pheromone'"},
      {"sensors", "pheromone", "medium", kEvery, "medium='pheromone'"},
      {"actuators", "pipuck_differential_drive", "default", kPiPuck},
      {"actuators", "pipuck_leds", "default", kPiPuck},
      {"sensors", "pipuck_differential_drive", "default", kPiPuck},
      {"sensors", "pipuck_front_camera", "default", kPiPuck,
       "tag_medium='tags' directional_led_medium='directional_leds'"},
      {"sensors", "pipuck_ground", "default", kPiPuck},
      {"sensors", "pipuck_imu", "default", kPiPuck},
      {"sensors", "pipuck_rangefinders", "default", kPiPuck},
      {"sensors", "pipuck_system", "default", kPiPuck}};
  return devices;
}

const std::vector<std::string>& ListedRobots() {
  static const std::vector<std::string> robots = [] {
    std::vector<std::string> labels;
    for (const auto& [label, type] : CFactory<CEntity>::GetTypeMap()) {
      // a robot's description has an example with its controller
      if (type->LongDescription.find("<controller ") != std::string::npos) {
        labels.push_back(label);
      }
    }
    return labels;
  }();
  return robots;
}

std::string MediaForDevices() {
  return "<led id='leds'/><range_and_bearing id='rab'/><simple_radio id='radios'/>"
         "<directional_led id='directional_leds'/><tag id='tags'/><rfid id='rfid'/>"
         "<pheromone id='pheromone'><layer id='trail'/></pheromone>";
}

std::string RobotForDevices(const std::string& type, const std::string& id,
                            const std::string& position, const std::string& config) {
  if (type == "pipuck") {
    return "<pipuck id='" + id +
           "' wifi_medium='radios' led_medium='directional_leds'><body position='" + position +
           "'/><controller config='" + config + "'/></pipuck>";
  }
  return "<" + type + " id='" + id + "' rab_range='3' rab_data_size='3'><body position='" +
         position + "'/><controller config='" + config +
         "'/><battery delta='0.25'/>"
         "<simple_radios><simple_radio id='wifi' medium='radios' range='3'/></simple_radios>"
         "<magnets><magnet id='front' anchor='origin' offset='0,0,0' passive_field='1,0,0' "
         "active_field='0,2,0'/></magnets>"
         "<directional_leds medium='directional_leds'>"
         "<directional_led anchor='origin' position='0,0,0.3' orientation='0,-90,0' "
         "observable_angle='60' color='red'/>"
         "<directional_led anchor='origin' position='0,0,0.7' orientation='0,-90,0' "
         "observable_angle='60' color='red'/></directional_leds>"
         "<tags medium='tags'>"
         "<tag anchor='origin' position='0,0,0.3' orientation='0,-90,0' observable_angle='60' "
         "side_length='0.1' payload='low'/>"
         "<tag anchor='origin' position='0,0,0.7' orientation='0,-90,0' observable_angle='60' "
         "side_length='0.1' payload='high'/></tags></" +
         type + ">";
}

}  // namespace argos
