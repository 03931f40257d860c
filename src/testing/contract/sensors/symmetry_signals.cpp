// Sensors of signals of other robots, in worlds that are moved, turned and mirrored.

#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_directional_led_detector_algorithm.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_led_detector_algorithm.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_tag_detector_algorithm.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_omnidirectional_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_perspective_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_simple_radios_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_simple_radios_sensor.h>
#include <argos3/testing/contract/sensors/symmetry_probe.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace argos {

namespace {

constexpr Real kImageWidth = 640.0;  // pixels
// in pixels: some roundings of the position of a near point
constexpr Real kPixelRoundings = 1e-9;

// the ring begins 11.25 degrees from the x axis: its LEDs have no mirror partners
constexpr UInt32 kEPuckLEDs = 8;
constexpr UInt32 kEyeBotLEDs = 33;

const char* const kMedia =
    "<led id='leds'/><directional_led id='signals'/><tag id='tags'/>"
    "<range_and_bearing id='rab'/><simple_radio id='radios'/>";
const char* const kActuators =
    "<leds implementation='default' medium='leds'/><range_and_bearing implementation='default'/>"
    "<simple_radios implementation='default'/>";
// symmetric about the robot's x axis
const char* const kCarried =
    "<directional_leds medium='signals'>"
    "<directional_led position='0.05,0,0.2' orientation='0,90,0' anchor='origin' "
    "observable_angle='80' color='red'/>"
    "<directional_led position='-0.05,0,0.2' orientation='0,-90,0' anchor='origin' "
    "observable_angle='80' color='green'/></directional_leds>"
    "<tags medium='tags'><tag position='0.05,0,0.25' orientation='90,90,0' anchor='origin' "
    "observable_angle='80' side_length='0.02' payload='front'/>"
    "<tag position='-0.05,0,0.25' orientation='-90,90,0' anchor='origin' "
    "observable_angle='80' side_length='0.02' payload='the back'/></tags>"
    "<simple_radios><simple_radio id='wifi' medium='radios' range='1.1' position='0,0,0.1'/>"
    "</simple_radios>";

// another robot of the same type
struct SOther {
  Real Bearing, Distance;  // degrees, m, from the robot, in the world frame
  Real Yaw;  // degrees
};

// no two robots in line, and none at a distance at which a rounding decides
const std::array<SOther, 6> kOthers = {{{41.0, 0.51, 203.0},
                                        {8.0, 0.62, 161.0},
                                        {143.0, 0.47, -61.0},
                                        {-103.0, 0.55, 77.0},
                                        {-31.0, 0.66, 119.0},
                                        {100.0, 1.25, -22.0}}};

std::string RobotText(const SSymmetryScene& scene, const std::string& id, const CVector3& place,
                      Real yaw) {
  return "<" + scene.Robot + " id='" + id + "' rab_range='1.2' rab_data_size='2'><body " +
         PoseText(place, yaw) + "/><controller config='c'/>" + kCarried + "</" + scene.Robot + ">";
}

// the robot and the others at the height of the scene, lights on the ground, and a pillar
std::string SignalArena(const SSymmetryScene& scene, const SSymmetryMap& map) {
  const auto around = [&map](Real bearing, Real distance, Real height) {
    return AroundRobot(map, bearing, distance, height);
  };
  // eye-bots need wider spacing
  const Real spread = scene.Robot == "eye-bot" ? 2.0 : 1.0;
  std::string arena =
      RobotText(scene, "r", around(0.0, 0.0, scene.Height), map.ApplyToYaw(kSymmetryRobotYaw));
  for (size_t i = 0; i < kOthers.size(); ++i) {
    const SOther& other = kOthers[i];
    // no light is at the height of the camera, where a rounding would
    // decide about the row of pixels
    const Real height = scene.Height + 0.03 * static_cast<Real>(i + 1);
    arena += RobotText(scene, "o" + std::to_string(i),
                       around(other.Bearing, spread * other.Distance, height),
                       map.ApplyToYaw(other.Yaw));
  }
  const CVector3 pillar = around(35.0, spread * 0.3, 0.0);
  arena += PillarText("pillar", pillar.GetX(), pillar.GetY(), 0.03, 0.6 + scene.Height);
  // lights directly below flying robots, and around robots on the ground
  arena += LightText("l0", around(30.0, 0.23, 0.02), "yellow") +
           LightText("l1", around(-80.0, 0.21, 0.05), "white") +
           LightText("l2", around(190.0, 0.24, 0.03), "cyan") +
           LightText("l3", around(17.0, 1.4, 0.18), "magenta");
  return arena;
}

// lights all LEDs that have a mirror partner, and sends in every tick
void Signal(CRobotWorld& world, const SSymmetryMap& /*map*/) {
  static const CColor colors[] = {CColor::RED,    CColor::GREEN,  CColor::BLUE,
                                  CColor::ORANGE, CColor::PURPLE, CColor::BROWN};
  for (size_t i = 0; i < kOthers.size(); ++i) {
    const std::string id = "o" + std::to_string(i);
    auto& leds = world.GetActuator<CCI_LEDsActuator>(id, "leds");
    if (leds.GetNumLEDs() != kEPuckLEDs) {
      leds.SetAllColors(colors[i]);
    }
    if (leds.GetNumLEDs() == kEyeBotLEDs) {
      // the last one is on one arm and has no partner
      leds.SetSingleColor(kEyeBotLEDs - 1, CColor::BLACK);
    }
    auto& rab = world.GetActuator<CCI_RangeAndBearingActuator>(id, "range_and_bearing");
    rab.SetData(0, static_cast<UInt8>(10 + i));
    auto& radio = world.GetActuator<CCI_SimpleRadiosActuator>(id, "simple_radios");
    dynamic_cast<CRobotWorldController&>(world.GetRobot(id).GetController()).OnStep = [&radio, i] {
      radio.GetInterfaces()[0].Messages.emplace_back(1, static_cast<UInt8>(20 + i));
    };
  }
  for (auto& sensor : world.GetRobot("r").GetController().GetAllSensors()) {
    sensor.second->Enable();
  }
}

// a sensed object: its type, its position from left to right, and further values
constexpr size_t kRowLength = 6;
typedef std::array<Real, kRowLength> TRow;

// in an order that does not depend on the order of creation, unless isInOrder
TSymmetryReadings Flatten(std::vector<TRow> rows, bool isInOrder = false) {
  // columns are rounded, because some objects are exactly above others
  const auto column = [](const TRow& row) { return std::round(1e6 * row[1]); };
  if (!isInOrder) {
    std::sort(rows.begin(), rows.end(), [&column](const TRow& a, const TRow& b) {
      return std::make_tuple(a[0], column(a), a[2]) < std::make_tuple(b[0], column(b), b[2]);
    });
  }
  TSymmetryReadings readings;
  for (const TRow& row : rows) {
    readings.insert(readings.end(), row.begin(), row.end());
  }
  return readings;
}

template <typename MIRROR>
std::function<TSymmetryReadings(TSymmetryReadings)> MirrorRows(MIRROR mirror) {
  return [mirror](const TSymmetryReadings& readings) {
    std::vector<TRow> rows(readings.size() / kRowLength);
    for (size_t i = 0; i < readings.size(); ++i) {
      rows[i / kRowLength][i % kRowLength] = readings[i];
    }
    for (TRow& row : rows) {
      row[1] = mirror(row[1]);
    }
    return Flatten(rows);
  };
}

Real ToNumber(const CColor& color) {
  return color.GetRed() + 1e3 * color.GetGreen() + 1e6 * color.GetBlue();
}

TRow PlaceOf(const CCI_ColoredBlobOmnidirectionalCameraSensor::SBlob& blob) {
  return {0.0, blob.Angle.GetValue(), blob.Distance, ToNumber(blob.Color)};
}

TRow PlaceOf(const CCI_ColoredBlobPerspectiveCameraSensor::SBlob& blob) {
  return {0.0, static_cast<Real>(blob.X), static_cast<Real>(blob.Y), ToNumber(blob.Color)};
}

template <typename CAMERA>
TSymmetryReadings ReadBlobs(CRobotWorld& world, const SSymmetryMap& map, const char* type) {
  std::vector<TRow> rows;
  for (const auto* blob : world.GetSensor<CAMERA>("r", type).GetReadings().BlobList) {
    rows.push_back(PlaceOf(*blob));
  }
  return Flatten(rows, map.IsInOrderOfCreation);
}

TSymmetryReadings ReadOmnidirectional(CRobotWorld& world, const SSymmetryMap& map) {
  return ReadBlobs<CCI_ColoredBlobOmnidirectionalCameraSensor>(
      world, map, "colored_blob_omnidirectional_camera");
}

TSymmetryReadings ReadPerspective(CRobotWorld& world, const SSymmetryMap& map) {
  return ReadBlobs<CCI_ColoredBlobPerspectiveCameraSensor>(world, map,
                                                           "colored_blob_perspective_camera");
}

template <typename ALGORITHM, typename ADD>
void ForReadings(CRobotWorld& world, size_t number, ADD add) {
  const auto& camera = world.GetSensor<CCI_CameraSensor>("r", "cameras").GetInterfaces().at(0);
  for (const auto& reading :
       dynamic_cast<const ALGORITHM&>(*camera.Algorithms.at(number)).GetReadings()) {
    add(reading);
  }
}

TSymmetryReadings ReadCameras(CRobotWorld& world, const SSymmetryMap& map) {
  std::vector<TRow> rows;
  const auto addLED = [&rows](Real kind, const auto& reading) {
    rows.push_back({kind, reading.Center.GetX(), reading.Center.GetY(), ToNumber(reading.Color)});
  };
  ForReadings<CCI_CameraSensorLEDDetectorAlgorithm>(
      world, 0, [&](const auto& reading) { addLED(0.0, reading); });
  ForReadings<CCI_CameraSensorDirectionalLEDDetectorAlgorithm>(
      world, 1, [&](const auto& reading) { addLED(1.0, reading); });
  ForReadings<CCI_CameraSensorTagDetectorAlgorithm>(world, 2, [&rows](const auto& reading) {
    // the reflection exchanges corners
    const auto [left, right] =
        std::minmax_element(reading.Corners.begin(), reading.Corners.end(),
                            [](const auto& a, const auto& b) { return a.GetX() < b.GetX(); });
    const auto [top, bottom] =
        std::minmax_element(reading.Corners.begin(), reading.Corners.end(),
                            [](const auto& a, const auto& b) { return a.GetY() < b.GetY(); });
    rows.push_back({2.0, reading.Center.GetX(), reading.Center.GetY(),
                    static_cast<Real>(reading.Payload.size()), right->GetX() - left->GetX(),
                    bottom->GetY() - top->GetY()});
  });
  return Flatten(rows, map.IsInOrderOfCreation);
}

TSymmetryReadings ReadRangeAndBearing(CRobotWorld& world, const SSymmetryMap& map) {
  std::vector<TRow> rows;
  for (const auto& packet :
       world.GetSensor<CCI_RangeAndBearingSensor>("r", "range_and_bearing").GetReadings()) {
    rows.push_back({0.0, packet.HorizontalBearing.GetValue(), packet.VerticalBearing.GetValue(),
                    packet.Range, static_cast<Real>(packet.Data[0])});
  }
  return Flatten(rows, map.IsInOrderOfCreation);
}

TSymmetryReadings ReadRadios(CRobotWorld& world, const SSymmetryMap& /*map*/) {
  TSymmetryReadings readings;
  for (const CByteArray& message :
       world.GetSensor<CCI_SimpleRadiosSensor>("r", "simple_radios").GetInterfaces()[0].Messages) {
    readings.push_back(message[0]);
  }
  return readings;
}

SSymmetryProbe SignalProbe(const std::string& name, const SSymmetryScene& scene,
                           const std::string& sensor) {
  SSymmetryProbe probe;
  probe.Name = name + " of the " + scene.Robot;
  probe.Scene = scene;
  probe.Sensors = sensor;
  probe.Actuators = kActuators;
  probe.Prepare = Signal;
  probe.Arena = SignalArena;
  probe.Media = kMedia;
  return probe;
}

void AppendCameras(std::vector<SSymmetryProbe>& probes, const SSymmetryScene& scene) {
  const auto mirrorAngle = [](Real angle) { return -angle; };
  const auto mirrorPixel = [](Real x) { return kImageWidth - 1.0 - x; };
  const auto mirrorPlace = [](Real x) { return kImageWidth - x; };
  if (scene.Robot == "foot-bot") {
    probes.push_back(SignalProbe("omnidirectional camera", scene,
                                 "<colored_blob_omnidirectional_camera implementation='rot_z_only' "
                                 "medium='leds'/>"));
    probes.back().Read = ReadOmnidirectional;
    probes.back().Mirror = MirrorRows(mirrorAngle);
    probes.back().Noise = {0.01, -3.0, 1e9, kRowLength, {1, 2}};
  }
  if (scene.Robot != "e-puck") {
    probes.push_back(
        SignalProbe("perspective camera", scene,
                    "<colored_blob_perspective_camera implementation='default' medium='leds'/>"));
    probes.back().Read = ReadPerspective;
    probes.back().Mirror = MirrorRows(mirrorPixel);
  }
  probes.push_back(SignalProbe(
      "cameras", scene,
      "<cameras implementation='default'><camera id='ahead' anchor='origin' position='0,0,0.22' "
      "orientation='-90,90,0' range='0.05:2' focal_length='300,300' principal_point='320,240' "
      "resolution='640,480'><led_detector medium='leds'/><directional_led_detector "
      "medium='signals'/><tag_detector medium='tags'/></camera></cameras>"));
  probes.back().Read = ReadCameras;
  probes.back().Mirror = MirrorRows(mirrorPlace);
  probes.back().MirrorTolerance = kPixelRoundings;
  probes.back().Noise = {0.01, -1e9, 1e9, kRowLength, {1, 2}};
}

}  // namespace

void AppendSignalProbes(std::vector<SSymmetryProbe>& probes) {
  SSymmetryScene flying = kEyeBotScene;
  flying.Height = 0.7;
  for (const SSymmetryScene& scene : {kFootBotScene, kEPuckScene, flying}) {
    AppendCameras(probes, scene);
    probes.push_back(SignalProbe("range and bearing", scene,
                                 "<range_and_bearing implementation='medium' medium='rab'/>"));
    probes.back().Read = ReadRangeAndBearing;
    probes.back().Mirror = MirrorRows([](Real bearing) { return -bearing; });
    probes.back().Noise = {0.001, -1.5, 1e9, kRowLength, {1, 2, 3}};
    probes.push_back(
        SignalProbe("simple radio", scene, "<simple_radios implementation='default'/>"));
    probes.back().Read = ReadRadios;
    probes.back().Mirror = KeepReadings;
  }
}

}  // namespace argos
