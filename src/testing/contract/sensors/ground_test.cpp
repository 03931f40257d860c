// Compares ground sensors with the colours of floors that are known at every point.

#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_base_ground_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_motor_ground_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_ground_sensor.h>
#include <argos3/plugins/simulator/entities/ground_sensor_equipped_entity.h>
#include <argos3/testing/contract/sensors/scene.h>
#include <argos3/testing/support/temporary_folder.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

namespace ground_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

// every point within a few decimetres has its own colour, over the whole range of colours
CColor ColorAt(Real x, Real y) {
  const auto wave = [](Real phase) {
    return static_cast<UInt8>(std::lround(127.5 + 127.5 * std::sin(phase)));
  };
  return CColor(wave(7.0 * x + 3.0 * y), wave(4.0 * x - 6.0 * y), wave(9.0 * y + 1.0));
}

Real GreyAt(Real x, Real y) {
  const CColor color = ColorAt(x, y);
  return (0.299 * color.GetRed() + 0.587 * color.GetGreen() + 0.114 * color.GetBlue()) / 255.0;
}

class CColorfulFloor : public CLoopFunctions {
 public:
  void Init(TConfigurationNode& tree) override {
    bool makeFloor = false;
    GetNodeAttributeOrDefault(tree, "make_floor", makeFloor, makeFloor);
    if (makeFloor) {
      AddEntity(*std::make_unique<CFloorEntity>("made", 10).release());
    }
  }
  CColor GetFloorColor(const CVector2& point) override {
    return Uniform ? CColor(100, 100, 100) : ColorAt(point.GetX(), point.GetY());
  }
  bool Uniform = false;
};

const char* const kFloor =
    "<floor id=\"floor\" source=\"loop_functions\" pixels_per_meter=\"10\"/>";

SRobotExperiment OnFloor(const std::string& device, const std::string& arena) {
  SRobotExperiment experiment;
  experiment.Sensors = device;
  experiment.Arena = kFloor + arena;
  experiment.LoopFunctions = "<loop_functions label=\"colorful_floor\"/>";
  return experiment;
}

// published positions in the robot's frame, m
const std::vector<CVector2> kMotor = {
    {0.063, 0.0116}, {-0.063, 0.0116}, {-0.063, -0.0116}, {0.063, -0.0116}};
const std::vector<CVector2> kBase = {{0.08, 0.0},  {0.042, 0.065},   {0.0, 0.08},  {-0.042, 0.065},
                                     {-0.08, 0.0}, {-0.042, -0.065}, {0.0, -0.08}, {0.042, -0.065}};
const std::vector<CVector2> kEPuck = {{0.03, -0.009}, {0.03, 0.0}, {0.03, 0.009}};

// positions of sensors on the floor
std::vector<CVector2> OnGround(std::vector<CVector2> offsets, Real x, Real y, Real yaw) {
  for (CVector2& offset : offsets) {
    offset = CVector2(x + offset.GetX() * std::cos(yaw) - offset.GetY() * std::sin(yaw),
                      y + offset.GetX() * std::sin(yaw) + offset.GetY() * std::cos(yaw));
  }
  return offsets;
}

const std::vector<Real>& Readings(CRobotWorld& world) {
  return world.GetSensor<CCI_GroundSensor>("r", "ground").GetReadings();
}

// One grey level in 255: where the last digit of the sine differs, the middle of a
// step may be rounded the other way.
constexpr Real kOneLevel = 1.0 / 255.0;

}  // namespace

REGISTER_LOOP_FUNCTIONS(CColorfulFloor, "colorful_floor")

TEST_CASE("ground: every sensor reads the grey level at the point below it",
          "[contract][sensors]") {
  CRandomStream random(1, "test", "ground", "poses");
  for (int trial = 0; trial < 50; ++trial) {
    const Real x = random.Uniform(-4.0, 4.0);
    const Real y = random.Uniform(-4.0, 4.0);
    const Real yaw = random.Uniform(-M_PI, M_PI);
    CAPTURE(trial, x, y, yaw);
    const std::string pose = PoseText(CVector3(x, y, 0.0), yaw * 180.0 / M_PI);
    CRobotWorld footBot(
        OnFloor("<footbot_motor_ground implementation=\"rot_z_only\"/>"
                "<footbot_base_ground implementation=\"rot_z_only\"/>"
                "<ground implementation=\"rot_z_only\"/>",
                Robot("foot-bot", "r", pose)));
    footBot.Step();
    const auto& motor =
        footBot.GetSensor<CCI_FootBotMotorGroundSensor>("r", "footbot_motor_ground").GetReadings();
    const auto& base =
        footBot.GetSensor<CCI_FootBotBaseGroundSensor>("r", "footbot_base_ground").GetReadings();
    const std::vector<Real>& all = Readings(footBot);
    REQUIRE(motor.size() == 4);
    REQUIRE(base.size() == 8);
    REQUIRE(all.size() == 12);
    const std::vector<CVector2> motorPlaces = OnGround(kMotor, x, y, yaw);
    for (size_t i = 0; i < 4; ++i) {
      CAPTURE(i);
      const Real grey = GreyAt(motorPlaces[i].GetX(), motorPlaces[i].GetY());
      CHECK_THAT(motor[i].Value, WithinAbs(grey, kOneLevel));
      CHECK(all[i] == motor[i].Value);
      CHECK_THAT((motor[i].Offset * 0.01 - kMotor[i]).Length(), WithinAbs(0.0, 1e-17));
    }
    const std::vector<CVector2> basePlaces = OnGround(kBase, x, y, yaw);
    for (size_t i = 0; i < 8; ++i) {
      CAPTURE(i);
      const Real grey = GreyAt(basePlaces[i].GetX(), basePlaces[i].GetY());
      if (std::abs(grey - 0.5) > kOneLevel) {
        CHECK(base[i].Value == (grey < 0.5 ? 0.0 : 1.0));
      }
      CHECK(all[4 + i] == base[i].Value);
      CHECK_THAT((base[i].Offset * 0.01 - kBase[i]).Length(), WithinAbs(0.0, 1e-16));
    }
    CRobotWorld ePuck(
        OnFloor("<ground implementation=\"rot_z_only\"/>", Robot("e-puck", "r", pose)));
    ePuck.Step();
    REQUIRE(Readings(ePuck).size() == 3);
    const std::vector<CVector2> ePuckPlaces = OnGround(kEPuck, x, y, yaw);
    for (size_t i = 0; i < 3; ++i) {
      CHECK_THAT(Readings(ePuck)[i],
                 WithinAbs(GreyAt(ePuckPlaces[i].GetX(), ePuckPlaces[i].GetY()), kOneLevel));
    }
  }
}

TEST_CASE("ground: the image is read at the robot's position", "[contract][sensors]") {
  const CTemporaryFolder folder;
  // the arena of 10 m x 10 m has four quarters; the upper row of the file is at y > 0
  const std::string file =
      folder.Write("floor.ppm", "P3 2 2 255\n255 0 0  0 255 0\n0 0 255  0 0 0\n");
  const Real x = GENERATE(-1.0, 1.0);
  const Real y = GENERATE(-1.0, 1.0);
  CAPTURE(x, y);
  SRobotExperiment experiment;
  experiment.Sensors = "<ground implementation=\"rot_z_only\"/>";
  experiment.Arena = Robot("e-puck", "r", PoseText(CVector3(x, y, 0.0))) +
                     "<floor id=\"floor\" source=\"image\" path=\"" + file + "\"/>";
  CRobotWorld world(experiment);
  world.Step();
  const Real expected = y > 0.0 ? (x < 0.0 ? 0.299 : 0.587) : (x < 0.0 ? 0.114 : 0.0);
  CHECK_THAT(Readings(world)[1], WithinAbs(expected, 1e-15));
}

TEST_CASE("ground: current colours of the loop functions are read", "[contract][sensors]") {
  CRobotWorld world(OnFloor("<ground implementation=\"rot_z_only\"/>",
                            Robot("e-puck", "r", PoseText(CVector3()))));
  world.Step();
  const std::vector<Real> before = Readings(world);
  dynamic_cast<CColorfulFloor&>(world.GetSimulator().GetLoopFunctions()).Uniform = true;
  world.Step();
  for (const Real reading : Readings(world)) {
    CHECK_THAT(reading, WithinAbs(100.0 / 255.0, 1e-15));
  }
  CHECK(before != Readings(world));
}

TEST_CASE("ground: sensors added or changed by a program are read", "[contract][sensors]") {
  CRobotWorld world(OnFloor("<ground implementation=\"rot_z_only\"/>",
                            Robot("e-puck", "r", PoseText(CVector3()))));
  auto& robot = world.Get<CEPuckEntity>("r");
  CGroundSensorEquippedEntity& sensors = robot.GetGroundSensorEquippedEntity();
  sensors.GetSensor(0).Offset = CVector2(1.0, 2.0);
  sensors.GetSensor(1).Type = CGroundSensorEquippedEntity::TYPE_BLACK_WHITE;
  sensors.AddSensorRing(CVector2(0.5, 0.0), 1.0, CRadians::PI_OVER_TWO,
                        CGroundSensorEquippedEntity::TYPE_GRAYSCALE, 2,
                        robot.GetEmbodiedEntity().GetOriginAnchor());
  world.Step();
  REQUIRE(Readings(world).size() == 5);
  CHECK_THAT(Readings(world)[0], WithinAbs(GreyAt(1.0, 2.0), kOneLevel));
  CHECK(Readings(world)[1] == (GreyAt(0.03, 0.0) < 0.5 ? 0.0 : 1.0));
  CHECK_THAT(Readings(world)[3], WithinAbs(GreyAt(0.5, 1.0), kOneLevel));
  CHECK_THAT(Readings(world)[4], WithinAbs(GreyAt(0.5, -1.0), kOneLevel));
}

TEST_CASE("ground: the floor may be anywhere in the file, or created by the loop functions",
          "[contract][sensors]") {
  const std::string sensor = "<ground implementation=\"rot_z_only\"/>";
  SRobotExperiment experiment = OnFloor(sensor, "");
  SECTION("a floor after the robot") {
    experiment.Arena = Robot("e-puck", "r", PoseText(CVector3())) + kFloor;
  }
  SECTION("a floor created by the loop functions") {
    experiment.Arena = Robot("e-puck", "r", PoseText(CVector3()));
    experiment.LoopFunctions = "<loop_functions label=\"colorful_floor\" make_floor=\"true\"/>";
  }
  CRobotWorld world(experiment);
  world.Step();
  CHECK_THAT(Readings(world)[1], WithinAbs(GreyAt(0.03, 0.0), kOneLevel));
}

TEST_CASE("ground: without a floor, experiments are refused", "[contract][sensors][errors]") {
  const std::string tag = GENERATE("ground", "footbot_motor_ground", "footbot_base_ground");
  CAPTURE(tag);
  SRobotExperiment experiment;
  experiment.Sensors = "<" + tag + " implementation=\"rot_z_only\"/>";
  experiment.Arena = Robot("foot-bot", "a", PoseText(CVector3())) +
                     Robot("foot-bot", "b", PoseText(CVector3(1.0, 0.0, 0.0)));
  const std::string error = LoadError(experiment);
  CHECK_THAT(error, Contains("test.argos:") && Contains("<" + tag + ">") && Contains("<floor>"));
  // the error is reported once, although two robots have the sensor
  CHECK_THAT(error, Contains("needs a floor"));
  CHECK(error.find("needs a floor") == error.rfind("needs a floor"));
}

TEST_CASE("ground: a floor removed during a run is an error that names the robot",
          "[contract][sensors][errors]") {
  CRobotWorld world(OnFloor("<ground implementation=\"rot_z_only\"/>",
                            Robot("e-puck", "r", PoseText(CVector3()))));
  world.Step();
  world.GetSimulator().GetLoopFunctions().RemoveEntity("floor");
  CHECK_THROWS_WITH(world.Step(), Contains("\"r\"") && Contains("<floor>"));
}

TEST_CASE("ground noise: grey sensors have the requested distribution",
          "[contract][sensors][noise]") {
  constexpr int kTicks = 1000;
  const bool even = GENERATE(true, false);
  const std::string device = "ground implementation=\"rot_z_only\"";
  SRobotExperiment experiment =
      OnFloor(even ? "<" + device + " noise_level=\"0.3\"/>"
                   : WithNoise(device, "model=\"gaussian\" std_dev=\"0.05\""),
              Robot("e-puck", "r", PoseText(CVector3())));
  CRobotWorld world(experiment);
  dynamic_cast<CColorfulFloor&>(world.GetSimulator().GetLoopFunctions()).Uniform = true;
  std::vector<Real> deviations;
  for (int i = 0; i < kTicks; ++i) {
    world.Step();
    for (const Real reading : Readings(world)) {
      deviations.push_back(reading - 100.0 / 255.0);
    }
  }
  const auto distribution = [even](Real x) {
    return even ? UniformDistribution(x, -0.3, 0.3) : NormalDistribution(x, 0.05);
  };
  CHECK(KolmogorovSmirnovExcess(deviations, distribution) <= 1.0);
}

TEST_CASE(
    "ground noise: black and white flip with the probability that noise crosses the threshold",
    "[contract][sensors][noise]") {
  constexpr int kTicks = 1000;
  SRobotExperiment experiment =
      OnFloor("<footbot_base_ground implementation=\"rot_z_only\" noise_level=\"0.3\"/>",
              Robot("foot-bot", "r", PoseText(CVector3())));
  CRobotWorld world(experiment);
  dynamic_cast<CColorfulFloor&>(world.GetSimulator().GetLoopFunctions()).Uniform = true;
  std::vector<size_t> counts(2, 0);
  for (int i = 0; i < kTicks; ++i) {
    world.Step();
    for (const auto& reading :
         world.GetSensor<CCI_FootBotBaseGroundSensor>("r", "footbot_base_ground").GetReadings()) {
      REQUIRE((reading.Value == 0.0 || reading.Value == 1.0));
      ++counts[static_cast<size_t>(reading.Value)];
    }
  }
  // U[-0.3, 0.3] added to 100/255 reaches 0.5 with this probability
  const Real white = (0.3 - (0.5 - 100.0 / 255.0)) / 0.6;
  CHECK(ChiSquareExcess(counts, {1.0 - white, white}) <= 1.0);
}

TEST_CASE("ground: invalid experiments are refused with the reason",
          "[contract][sensors][errors]") {
  CHECK_THAT(LoadError(OnFloor("<footbot_motor_ground implementation=\"rot_z_only\"/>",
                               Robot("e-puck", "ep0", PoseText(CVector3())))),
             Contains("footbot_motor_ground") && Contains("needs a robot with 12") &&
                 Contains("\"ep0\" has 3"));
  CHECK_THAT(LoadError(OnFloor("<ground implementation=\"rot_z_only\"/>",
                               Robot("toy-robot", "t0", PoseText(CVector3())))),
             Contains("\"t0\"") && Contains("ground_sensors"));
  CHECK_THAT(LoadError(OnFloor("<ground implementation=\"rot_z_only\" noise_level=\"-1\"/>",
                               Robot("e-puck", "ep0", PoseText(CVector3())))),
             Contains("noise_level") && Contains(">= 0") && Contains("-1"));
}

}  // namespace ground_test
