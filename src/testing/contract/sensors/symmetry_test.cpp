// Worlds that are moved, turned or mirrored: the readings of robots equal those in the original,
// with left and right exchanged by the reflection.
//
// Each probe is one sensor of one robot; a new probe is one more entry in MakeSymmetryProbes().

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>
#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_light_sensor.h>
#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_proximity_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_base_ground_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_distance_scanner_actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_distance_scanner_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_encoder_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_light_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_motor_ground_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_turret_actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_turret_encoder_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_altitude_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_battery_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_clock_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_ground_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_light_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_positioning_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_proximity_sensor.h>
#include <argos3/testing/contract/sensors/symmetry_probe.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace argos;
using Catch::Matchers::WithinAbs;

namespace {

using SMap = SSymmetryMap;
using SScene = SSymmetryScene;
using SProbe = SSymmetryProbe;
using TReadings = TSymmetryReadings;

// The angles of the e-puck's proximity sensors are published as fractions of PI, symmetric to 0.1
// degrees. This moves the point hit by a ray by 0.1 mm, on curves with a slope of 37 per metre.
constexpr Real kEPuckAngles = 5e-3;

const SMap kMaps[] = {{false, 90.0, 0.0, 0.0},   {false, 180.0, 0.0, 0.0}, {false, 37.0, 0.4, -0.7},
                      {false, -119.0, 1.1, 0.6}, {true, 0.0, 0.0, 0.0},    {true, 37.0, -0.5, 0.3},
                      {true, 180.0, 0.0, 0.9}};

// a floor whose colours are transformed with the world
class CMappedFloor : public CLoopFunctions {
 public:
  CColor GetFloorColor(const CVector2& point) override {
    const CVector2 original = Map.Revert(point);
    // wide steps, so that rounding of positions changes no colour under the sensors
    const auto step = [](Real phase) {
      return static_cast<UInt8>(40 * (1 + static_cast<int>(std::floor(phase)) % 5));
    };
    return CColor(step(20.0 + 61.3 * original.GetX()), step(20.0 + 83.7 * original.GetY()), 77);
  }
  SMap Map;
};

std::string BuildArena(const SScene& scene, const SMap& map) {
  const auto around = [&](Real bearing, Real distance) {
    return AroundRobot(map, bearing, distance, 0.0);
  };
  const auto pillar = [&](const std::string& id, Real bearing, Real gap, Real radius) {
    const CVector3 place = around(bearing, scene.Radius + gap + radius);
    return PillarText(id, place.GetX(), place.GetY(), radius, 0.6);
  };
  const CVector3 robot = map.Apply(kSymmetryRobotAt) + CVector3(0.0, 0.0, scene.Height);
  const auto lamp = [&](const std::string& id, Real bearing, Real distance, Real height,
                        Real intensity) {
    return LampText(id, around(bearing, distance) + CVector3(0.0, 0.0, height), intensity);
  };
  return "<floor id=\"floor\" source=\"loop_functions\" pixels_per_meter=\"10\"/><" + scene.Robot +
         " id=\"r\"><body " + PoseText(robot, map.ApplyToYaw(kSymmetryRobotYaw)) +
         "/><controller config=\"c\"/><battery discharge_model=\"motion\" "
         "start_charge=\"0.5\"/></" +
         scene.Robot + ">" +
         // near pillars for proximity sensors, distant ones for the scanner and,
         // from above, the altitude sensor
         pillar("p0", 70.0, 0.02, 0.05) + pillar("p1", 160.0, 0.035, 0.03) +
         pillar("p2", -100.0, 0.01, 0.02) + pillar("p3", -30.0, 0.6, 0.1) +
         BoxText("b0", CVector3(0.1, 0.5, 0.4), around(20.0, scene.Radius + 0.25),
                 map.ApplyToYaw(40.0)) +
         lamp("l0", 120.0, 1.5, 0.3, 0.9) + lamp("l1", -45.0, 1.2, 0.1, 0.8) +
         lamp("l2", -150.0, 0.9, 0.7, 0.6);
}

// reverses readings of sensors that are symmetric about the robot's x axis and counted around it
TReadings Reverse(TReadings readings) {
  std::reverse(readings.begin(), readings.end());
  return readings;
}

// the first sensor is on the axis
TReadings ReverseRest(TReadings readings) {
  std::reverse(readings.begin() + 1, readings.end());
  return readings;
}

// the robot's motor ground sensors, then its base ground sensors
TReadings MirrorGround(const TReadings& readings) {
  TReadings motor = Reverse(TReadings(readings.begin(), readings.begin() + 4));
  const TReadings base = ReverseRest(TReadings(readings.begin() + 4, readings.end()));
  motor.insert(motor.end(), base.begin(), base.end());
  return motor;
}

template <typename SENSOR>
SENSOR& SensorOf(CRobotWorld& world, const std::string& tag) {
  return world.GetSensor<SENSOR>("r", tag);
}

// for sensors whose readings have a Value
template <typename SENSOR>
std::function<TReadings(CRobotWorld&, const SMap&)> Values(const std::string& tag) {
  return [tag](CRobotWorld& world, const SMap&) {
    TReadings values;
    for (const auto& reading : SensorOf<SENSOR>(world, tag).GetReadings()) {
      values.push_back(reading.Value);
    }
    return values;
  };
}

// for sensors whose readings are numbers
template <typename SENSOR>
std::function<TReadings(CRobotWorld&, const SMap&)> Numbers(const std::string& tag) {
  return
      [tag](CRobotWorld& world, const SMap&) { return SensorOf<SENSOR>(world, tag).GetReadings(); };
}

std::string Default(const std::string& tag) {
  return "<" + tag + " implementation=\"default\"/>";
}

std::string RotZOnly(const std::string& tag) {
  return "<" + tag + " implementation=\"rot_z_only\"/>";
}

void AddRings(std::vector<SProbe>& probes) {
  probes.push_back({"proximity of a foot-bot", kFootBotScene, Default("proximity"),
                    Numbers<CCI_ProximitySensor>("proximity"), Reverse});
  probes.push_back({"proximity of an e-puck", kEPuckScene, Default("proximity"),
                    Numbers<CCI_ProximitySensor>("proximity"), Reverse});
  probes.back().MirrorTolerance = kEPuckAngles;
  probes.push_back({"footbot_proximity", kFootBotScene, Default("footbot_proximity"),
                    Values<CCI_FootBotProximitySensor>("footbot_proximity"), Reverse});
  probes.push_back({"epuck_proximity", kEPuckScene, Default("epuck_proximity"),
                    Values<CCI_EPuckProximitySensor>("epuck_proximity"), Reverse});
  probes.back().MirrorTolerance = kEPuckAngles;
  probes.push_back({"eyebot_proximity", kEyeBotScene, Default("eyebot_proximity"),
                    Values<CCI_EyeBotProximitySensor>("eyebot_proximity"), Reverse});
  probes.push_back({"light of a foot-bot", kFootBotScene, Default("light"),
                    Numbers<CCI_LightSensor>("light"), Reverse});
  probes.push_back({"light of an e-puck", kEPuckScene, Default("light"),
                    Numbers<CCI_LightSensor>("light"), Reverse});
  probes.push_back({"light of an eye-bot", kEyeBotScene, Default("light"),
                    Numbers<CCI_LightSensor>("light"), Reverse});
  probes.push_back({"proximity of an eye-bot", kEyeBotScene, Default("proximity"),
                    Numbers<CCI_ProximitySensor>("proximity"), Reverse});
  probes.push_back({"footbot_proximity of an eye-bot", kEyeBotScene, Default("footbot_proximity"),
                    Values<CCI_FootBotProximitySensor>("footbot_proximity"), Reverse});
  probes.push_back({"eyebot_proximity of a foot-bot", kFootBotScene, Default("eyebot_proximity"),
                    Values<CCI_EyeBotProximitySensor>("eyebot_proximity"), Reverse});
  probes.push_back({"footbot_light of an eye-bot", kEyeBotScene, RotZOnly("footbot_light"),
                    Values<CCI_FootBotLightSensor>("footbot_light"), Reverse});
  probes.push_back({"eyebot_light of a foot-bot", kFootBotScene, RotZOnly("eyebot_light"),
                    Values<CCI_EyeBotLightSensor>("eyebot_light"), Reverse});
  probes.push_back({"footbot_light", kFootBotScene, RotZOnly("footbot_light"),
                    Values<CCI_FootBotLightSensor>("footbot_light"), Reverse});
  probes.push_back({"eyebot_light", kEyeBotScene, RotZOnly("eyebot_light"),
                    Values<CCI_EyeBotLightSensor>("eyebot_light"), Reverse});
}

void AddNoise(std::vector<SProbe>& probes, size_t first, const SNoisyReadings& noise) {
  for (size_t i = first; i < probes.size(); ++i) {
    probes[i].Noise = noise;
  }
}

void AddGround(std::vector<SProbe>& probes) {
  probes.push_back({"ground of a foot-bot", kFootBotScene, RotZOnly("ground"),
                    Numbers<CCI_GroundSensor>("ground"), MirrorGround});
  // the other sensors read only black and white
  probes.back().Noise = {0.02, 0.0, 1.0, 12, {0, 1, 2, 3}};
  probes.push_back({"ground of an e-puck", kEPuckScene, RotZOnly("ground"),
                    Numbers<CCI_GroundSensor>("ground"), Reverse});
  probes.back().Noise = {0.02, 0.0, 1.0};
  probes.push_back({"footbot_motor_ground", kFootBotScene, RotZOnly("footbot_motor_ground"),
                    Values<CCI_FootBotMotorGroundSensor>("footbot_motor_ground"), Reverse});
  probes.back().Noise = {0.02, 0.0, 1.0};
  probes.push_back({"footbot_base_ground", kFootBotScene, RotZOnly("footbot_base_ground"),
                    Values<CCI_FootBotBaseGroundSensor>("footbot_base_ground"), ReverseRest});
}

TReadings ReadPose(CRobotWorld& world, const SMap& map) {
  const auto& reading = SensorOf<CCI_PositioningSensor>(world, "positioning").GetReading();
  const CVector2 place = map.Revert(CVector2(reading.Position.GetX(), reading.Position.GetY()));
  CRadians z, y, x;
  reading.Orientation.ToEulerAngles(z, y, x);
  const Real yaw = (z - ToRadians(CDegrees(map.Turn))).GetValue();
  return {place.GetX(), place.GetY(), reading.Position.GetZ(), std::sin(yaw), std::cos(yaw)};
}

// readings above a pillar and beside it
TReadings ReadAltitudes(CRobotWorld& world, const SMap& map) {
  TReadings heights;
  for (const Real bearing : {70.0, 160.0, 40.0}) {
    const Real angle = bearing * M_PI / 180.0;
    auto& body = world.Get<CComposableEntity>("r").GetComponent<CEmbodiedEntity>("body");
    body.MoveTo(
        map.Apply(kSymmetryRobotAt + CVector3(0.32 * std::cos(angle), 0.32 * std::sin(angle), 1.0)),
        CQuaternion(), false, true);
    world.Step();
    heights.push_back(SensorOf<CCI_AltitudeSensor>(world, "altitude").GetReading());
  }
  return heights;
}

void AddPoseSensors(std::vector<SProbe>& probes) {
  for (SScene scene : {kFootBotScene, kEPuckScene, kEyeBotScene}) {
    probes.push_back({"positioning of the " + scene.Robot, scene, Default("positioning"), ReadPose,
                      [](TReadings readings) {
                        readings[3] = -readings[3];
                        return readings;
                      }});
    probes.back().Noise = {0.01, -1e9, 1e9, 5, {0, 1, 2}};
    // the pillar p1 is placed for a robot of the eye-bot's size
    scene.Radius = kEyeBotScene.Radius;
    scene.Height = 1.0;
    probes.push_back({"altitude of the " + scene.Robot, scene, Default("altitude"), ReadAltitudes,
                      KeepReadings});
    probes.back().Noise = {0.01};
    probes.push_back({"clock of the " + scene.Robot, scene, Default("clock"),
                      [](CRobotWorld& world, const SMap&) {
                        const auto& reading =
                            SensorOf<CCI_ClockSensor>(world, "clock").GetReading();
                        return TReadings{static_cast<Real>(reading.Tick), reading.Time};
                      },
                      KeepReadings});
    probes.back().Noise = {0.01, -1e9, 1e9, 2, {1}};
  }
}

// speeds in cm/s in the original world; mirrored robots have left and right exchanged
void Drive(CRobotWorld& world, const SMap& map) {
  auto& wheels = world.GetActuator<CCI_DifferentialSteeringActuator>("r", "differential_steering");
  map.IsMirror ? wheels.SetLinearVelocity(0.5, 0.2) : wheels.SetLinearVelocity(0.2, 0.5);
}

void AddMotion(std::vector<SProbe>& probes) {
  const std::string wheels = Default("differential_steering");
  const std::string engine = "<dynamics2d id=\"dyn2d\"/>";
  for (const SScene& scene : {kFootBotScene, kEPuckScene}) {
    probes.push_back({"differential_steering of the " + scene.Robot, scene, wheels,
                      [](CRobotWorld& world, const SMap&) {
                        const auto& reading =
                            SensorOf<CCI_DifferentialSteeringSensor>(world, "differential_steering")
                                .GetReading();
                        return TReadings{
                            reading.VelocityLeftWheel, reading.CoveredDistanceLeftWheel,
                            reading.CoveredDistanceRightWheel, reading.VelocityRightWheel};
                      },
                      Reverse, wheels, engine, Drive});
    probes.back().Noise = {0.01};
    probes.back().Noise = {0.01};
    probes.push_back({"battery of the " + scene.Robot, scene, Default("battery"),
                      [](CRobotWorld& world, const SMap&) {
                        const auto& reading =
                            SensorOf<CCI_BatterySensor>(world, "battery").GetReading();
                        return TReadings{reading.AvailableCharge};
                      },
                      KeepReadings, wheels, engine, Drive});
    probes.back().Noise = {0.01, 0.0, 1.0};
  }
  probes.push_back(
      {"footbot_encoder", kFootBotScene, Default("footbot_encoder"),
       [](CRobotWorld& world, const SMap&) {
         const auto& reading =
             SensorOf<CCI_FootBotEncoderSensor>(world, "footbot_encoder").GetReading();
         return TReadings{reading.CoveredDistanceLeftWheel, reading.CoveredDistanceRightWheel};
       },
       Reverse, wheels, engine, Drive});
  probes.back().Noise = {0.01};
  probes.push_back({"footbot_turret_encoder", kFootBotScene, Default("footbot_turret_encoder"),
                    [](CRobotWorld& world, const SMap&) {
                      return TReadings{
                          SensorOf<CCI_FootBotTurretEncoderSensor>(world, "footbot_turret_encoder")
                              .GetRotation()
                              .GetValue()};
                    },
                    [](TReadings readings) {
                      readings[0] = -readings[0];
                      return readings;
                    },
                    Default("footbot_turret"), engine,
                    [](CRobotWorld& world, const SMap& map) {
                      world.GetActuator<CCI_FootBotTurretActuator>("r", "footbot_turret")
                          .SetActiveWithRotation(CRadians(map.IsMirror ? -0.7 : 0.7));
                    }});
  for (const Real rpm : {0.0, 50.0}) {
    probes.push_back(
        {rpm == 0.0 ? "distance scanner, held" : "distance scanner, turning", kFootBotScene,
         RotZOnly("footbot_distance_scanner"),
         [](CRobotWorld& world, const SMap& map) {
           // by angle in the frame of the original robot
           TReadings readings;
           for (const auto& [angle, distance] :
                SensorOf<CCI_FootBotDistanceScannerSensor>(world, "footbot_distance_scanner")
                    .GetReadingsMap()) {
             readings.push_back(angle.GetValue());
             readings.push_back(distance);
           }
           if (map.IsMirror) {
             std::reverse(readings.begin(), readings.end());
             for (size_t i = 0; i < readings.size(); i += 2) {
               std::swap(readings[i], readings[i + 1]);
               readings[i] = -readings[i];
             }
           }
           return readings;
         },
         KeepReadings, Default("footbot_distance_scanner"), "<toy_engine id=\"toy\"/>",
         [rpm](CRobotWorld& world, const SMap& map) {
           auto& motor = world.GetActuator<CCI_FootBotDistanceScannerActuator>(
               "r", "footbot_distance_scanner");
           const Real sign = map.IsMirror ? -1.0 : 1.0;
           // not along the axes, where a beam would change its position in the list
           motor.SetAngle(CRadians(sign * 0.3));
           world.GetRobot("r").Act();
           if (rpm != 0.0) {
             motor.SetRPM(sign * rpm);
           }
         }});
    // values below 0 are codes for missing distances
    probes.back().Noise = {0.2, 0.0, 1e9, 2, {1}};
  }
}

TReadings Run(const SProbe& probe, const SMap& map) {
  CRobotWorld world(MakeSymmetryExperiment(probe, map));
  dynamic_cast<CMappedFloor&>(world.GetSimulator().GetLoopFunctions()).Map = map;
  if (probe.Prepare) {
    probe.Prepare(world, map);
  }
  world.Step(3);
  return probe.Read(world, map);
}

}  // namespace

REGISTER_LOOP_FUNCTIONS(CMappedFloor, "mapped_floor")

std::vector<SSymmetryProbe> argos::MakeSymmetryProbes() {
  std::vector<SProbe> probes;
  AddRings(probes);
  AddNoise(probes, 0, {0.002, 0.0, 1.0});
  AddGround(probes);
  AddPoseSensors(probes);
  AddMotion(probes);
  AppendSignalProbes(probes);
  return probes;
}

SRobotExperiment argos::MakeSymmetryExperiment(const SSymmetryProbe& probe,
                                               const SSymmetryMap& map) {
  SRobotExperiment experiment;
  experiment.Actuators = probe.Actuators;
  experiment.Sensors = probe.Sensors;
  experiment.Engine = probe.Engine;
  experiment.Media = probe.Media;
  experiment.Arena = probe.Arena ? probe.Arena(probe.Scene, map) : BuildArena(probe.Scene, map);
  experiment.LoopFunctions = "<loop_functions label=\"mapped_floor\"/>";
  return experiment;
}

TEST_CASE("symmetry: moved, turned and mirrored worlds give moved, turned and mirrored readings",
          "[contract][sensors]") {
  for (const SProbe& probe : MakeSymmetryProbes()) {
    CAPTURE(probe.Name);
    const TReadings original = Run(probe, SMap());
    REQUIRE_FALSE(original.empty());
    // the readings are neither zero nor all equal
    CHECK((original.size() == 1 || *std::max_element(original.begin(), original.end()) >
                                       *std::min_element(original.begin(), original.end())));
    for (const SMap& map : kMaps) {
      CAPTURE(map.IsMirror, map.Turn, map.ShiftX, map.ShiftY);
      const TReadings expected = map.IsMirror ? probe.Mirror(original) : original;
      const TReadings seen = Run(probe, map);
      REQUIRE(seen.size() == expected.size());
      for (size_t i = 0; i < seen.size(); ++i) {
        CAPTURE(i);
        CHECK_THAT(seen[i], WithinAbs(expected[i],
                                      map.IsMirror ? probe.MirrorTolerance : kSymmetryRoundings));
      }
    }
  }
}
