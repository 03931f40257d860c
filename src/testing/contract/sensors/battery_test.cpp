// Batteries and the battery sensor.

#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_battery_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/simulator/entities/battery_equipped_entity.h>
#include <argos3/testing/contract/sensors/scene.h>
#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace battery_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kForEver = std::numeric_limits<Real>::infinity();
constexpr Real kTick = 0.1;  // s

// a robot of type @p tag with the given <battery> element, if any
SRobotExperiment WithBattery(const std::string& battery, const std::string& tag = "foot-bot",
                             const std::string& pose = "position=\"0,0,0\"") {
  SRobotExperiment experiment;
  experiment.Actuators = "<differential_steering implementation=\"default\"/>";
  experiment.Sensors = "<battery implementation=\"default\"/>";
  experiment.Engine = "<dynamics2d id=\"dyn2d\" velocity_lag=\"0\"/>";
  experiment.Arena = "<" + tag + " id=\"r\"><body " + pose + "/><controller config=\"c\"/>" +
                     battery + "</" + tag + ">";
  return experiment;
}

const CCI_BatterySensor::SReading& Reading(CRobotWorld& world) {
  return world.GetSensor<CCI_BatterySensor>("r", "battery").GetReading();
}

CBatteryEquippedEntity& Battery(CRobotWorld& world) {
  return world.Get<CComposableEntity>("r").GetComponent<CBatteryEquippedEntity>("battery");
}

// speeds in cm/s
void Drive(CRobotWorld& world, Real left, Real right) {
  world.GetActuator<CCI_DifferentialSteeringActuator>("r", "differential_steering")
      .SetLinearVelocity(left, right);
}

// displacement of a foot-bot's origin in one tick of an arc, and its rotation
struct SMotion {
  Real Distance, Angle;  // m, rad
};

SMotion ArcInATick(Real left, Real right) {
  const Real angle = 0.01 * (right - left) / 0.14 * kTick;
  const Real way = 0.01 * 0.5 * (left + right) * kTick;
  // ratio of chord and arc
  const Real share = angle == 0.0 ? 1.0 : std::sin(0.5 * angle) / (0.5 * angle);
  return {std::abs(way * share), std::abs(angle)};
}

// reduces the charge by the attribute of its element in every tick without motion
class CIdleModel : public CBatteryDischargeModel {
 public:
  void Init(TConfigurationNode& battery) override {
    GetNodeAttribute(battery, "idle_delta", m_delta);
  }
  void operator()() override {
    if (m_pcBattery->ComputeDistanceMoved() == 0.0) {
      m_pcBattery->SetAvailableCharge(m_pcBattery->GetAvailableCharge() - m_delta);
    }
  }

 private:
  Real m_delta = 0.0;
};

}  // namespace

REGISTER_BATTERY_DISCHARGE_MODEL(CIdleModel, "idle_for_tests")

TEST_CASE("battery: the time model subtracts delta in every tick, down to zero",
          "[contract][sensors]") {
  const std::string tag = GENERATE("foot-bot", "e-puck", "eye-bot");
  CAPTURE(tag);
  SRobotExperiment experiment = WithBattery(
      "<battery discharge_model=\"time\" delta=\"0.3\" start_charge=\"2\" full_charge=\"4\"/>",
      tag);
  experiment.Actuators = "";
  experiment.Engine = "<toy_engine id=\"toy\"/>";
  CRobotWorld world(experiment);
  CHECK(Reading(world).AvailableCharge == 0.5);
  Real charge = 2.0;
  for (int tick = 0; tick < 8; ++tick) {
    CAPTURE(tick);
    const Real before = charge;
    charge = std::max(0.0, charge - 0.3);
    world.Step();
    CHECK_THAT(Battery(world).GetAvailableCharge(), WithinAbs(charge, 1e-15));
    CHECK_THAT(Reading(world).AvailableCharge, WithinAbs(charge / 4.0, 1e-15));
    if (charge == 0.0) {
      CHECK(Reading(world).TimeLeft == 0.0);
    } else {
      CHECK_THAT(Reading(world).TimeLeft, WithinAbs(before * kTick / (before - charge), 1e-13));
    }
  }
  CHECK(charge == 0.0);
}

TEST_CASE("battery: omitted models and values have the documented defaults",
          "[contract][sensors]") {
  CRobotWorld world(WithBattery("<battery/>"));
  world.Step(3);
  CHECK(Battery(world).GetFullCharge() == 1.0);
  CHECK_THAT(Battery(world).GetAvailableCharge(), WithinAbs(1.0 - 3e-5, 1e-15));
}

TEST_CASE("battery: the motion model subtracts charge according to the actual motion",
          "[contract][sensors]") {
  using TSpeeds = std::pair<Real, Real>;  // cm/s
  const auto [left, right] = GENERATE(TSpeeds(10, 10), TSpeeds(4, 12), TSpeeds(-5, 5));
  const bool withTime = GENERATE(false, true);
  CAPTURE(left, right, withTime);
  CRobotWorld world(WithBattery(
      withTime ? "<battery discharge_model=\"time_motion\" time_factor=\"0.001\" "
                 "pos_factor=\"0.5\" orient_factor=\"0.25\"/>"
               : "<battery discharge_model=\"motion\" pos_delta=\"0.5\" orient_delta=\"0.25\"/>",
      "foot-bot", "position=\"1,-2,0\" orientation=\"70,0,0\""));
  Drive(world, left, right);
  // the order was given before the first tick, so it is executed from the first tick on
  const SMotion motion = ArcInATick(left, right);
  const Real perTick = 0.5 * motion.Distance + 0.25 * motion.Angle + (withTime ? 0.001 : 0.0);
  for (int tick = 1; tick <= 10; ++tick) {
    world.Step();
    // tolerance of some roundings of positions of 2 m
    CHECK_THAT(Battery(world).GetAvailableCharge(), WithinAbs(1.0 - tick * perTick, 1e-14));
  }
}

TEST_CASE("battery: the initial pose and moves by a program cost no charge",
          "[contract][sensors]") {
  CRobotWorld world(WithBattery("<battery discharge_model=\"motion\"/>", "foot-bot",
                                "position=\"1,0,0\" orientation=\"90,0,0\""));
  world.Step(2);
  CHECK(Battery(world).GetAvailableCharge() == 1.0);
  auto& body = world.Get<CFootBotEntity>("r").GetEmbodiedEntity();
  REQUIRE(body.MoveTo(CVector3(-3.0, 2.0, 0.0), CQuaternion()));
  world.Step(2);
  CHECK(Battery(world).GetAvailableCharge() == 1.0);
  CHECK(Reading(world).TimeLeft == kForEver);
}

TEST_CASE("battery: without the element the charge is constant", "[contract][sensors]") {
  CRobotWorld world(WithBattery(""));
  Drive(world, 10.0, 10.0);
  world.Step(10);
  CHECK(Reading(world).AvailableCharge == 1.0);
  CHECK(Reading(world).TimeLeft == kForEver);
}

TEST_CASE("battery: it discharges only if the controller has the sensor", "[contract][sensors]") {
  SRobotExperiment experiment = WithBattery("<battery delta=\"0.1\"/>");
  experiment.Sensors = "";
  CRobotWorld world(experiment);
  CBatteryEquippedEntity& battery = world.Get<CFootBotEntity>("r").GetBatterySensorEquippedEntity();
  world.Step(3);
  CHECK(battery.GetAvailableCharge() == 1.0);
  battery.Enable();
  world.Step();
  CHECK_THAT(battery.GetAvailableCharge(), WithinAbs(0.9, 1e-15));
}

TEST_CASE("battery: a reset restores the charge, and the run repeats", "[contract][sensors]") {
  CRobotWorld world(WithBattery(
      "<battery discharge_model=\"time_motion\" time_factor=\"0.01\" start_charge=\"0.8\"/>"));
  const auto run = [&world] {
    std::vector<Real> charges;
    for (int i = 0; i < 5; ++i) {
      Drive(world, 10.0, 5.0);
      world.Step();
      charges.push_back(Reading(world).AvailableCharge);
      charges.push_back(Reading(world).TimeLeft);
    }
    return charges;
  };
  const std::vector<Real> first = run();
  CHECK(first[0] < 0.8);
  world.GetSimulator().Reset();
  CHECK(Battery(world).GetAvailableCharge() == 0.8);
  CHECK(Reading(world).AvailableCharge == 0.8);
  CHECK(run() == first);
}

TEST_CASE("battery: while it is charged the remaining time is infinite", "[contract][sensors]") {
  CRobotWorld world(WithBattery("<battery delta=\"0.1\" start_charge=\"0.5\"/>"));
  world.Step();
  CHECK(Reading(world).TimeLeft < kForEver);
  Battery(world).SetAvailableCharge(0.9);
  world.Step();
  CHECK_THAT(Reading(world).AvailableCharge, WithinAbs(0.8, 1e-15));
  CHECK(Reading(world).TimeLeft == kForEver);
}

TEST_CASE("battery: users can add models with their own attributes", "[contract][sensors]") {
  CRobotWorld world(
      WithBattery("<battery discharge_model=\"idle_for_tests\" idle_delta=\"0.125\"/>"));
  world.Step(2);
  CHECK(Reading(world).AvailableCharge == 0.75);
  Drive(world, 10.0, 10.0);
  world.Step(3);
  CHECK(Reading(world).AvailableCharge == 0.75);
}

TEST_CASE("battery: robots created by a program have the given model", "[contract][sensors]") {
  SRobotExperiment experiment = WithBattery("");
  CRobotWorld world(experiment);
  world.Add(std::make_unique<CFootBotEntity>("made", "c", CVector3(2.0, 0.0, 0.0), CQuaternion(),
                                             3.0, 10, "time"));
  world.Add(std::make_unique<CEPuckEntity>("small", "c", CVector3(-2.0, 0.0, 0.0), CQuaternion(),
                                           0.8, 2, "time"));
  world.Step(2);
  CHECK_THAT(world.GetSensor<CCI_BatterySensor>("made", "battery").GetReading().AvailableCharge,
             WithinAbs(1.0 - 2e-5, 1e-15));
  CHECK_THAT(world.GetSensor<CCI_BatterySensor>("small", "battery").GetReading().AvailableCharge,
             WithinAbs(1.0 - 2e-5, 1e-15));
  CHECK(Reading(world).AvailableCharge == 1.0);
  CHECK_THROWS_WITH(CEPuckEntity("e", "c", CVector3(), CQuaternion(), 0.8, 2, "tyme"),
                    Contains("e-puck \"e\"") && Contains("\"tyme\"") && Contains("time"));
}

TEST_CASE("battery noise: has the requested distribution", "[contract][sensors][noise]") {
  constexpr int kTicks = 4000;
  const bool even = GENERATE(true, false);
  const std::string device = "battery implementation=\"default\"";
  SRobotExperiment experiment = WithBattery("<battery delta=\"0\" start_charge=\"0.5\"/>");
  experiment.Sensors =
      even ? "<" + device + " noise_range=\"-0.1:0.3\"/>"
           : WithNoise(device, "on=\"available_charge\" model=\"gaussian\" std_dev=\"0.02\"");
  CRobotWorld world(experiment);
  std::vector<Real> deviations;
  for (int i = 0; i < kTicks; ++i) {
    world.Step();
    deviations.push_back(Reading(world).AvailableCharge - 0.5);
  }
  CHECK(KolmogorovSmirnovExcess(deviations, [even](Real x) {
          return even ? UniformDistribution(x, -0.1, 0.3) : NormalDistribution(x, 0.02);
        }) <= 1.0);
  CHECK(Battery(world).GetAvailableCharge() == 0.5);
}

TEST_CASE("battery noise: readings stay in [0,1]", "[contract][sensors][noise]") {
  SRobotExperiment experiment = WithBattery("<battery delta=\"0\" start_charge=\"0.5\"/>");
  experiment.Sensors = "<battery implementation=\"default\" noise_range=\"-5:5\"/>";
  CRobotWorld world(experiment);
  bool empty = false;
  bool full = false;
  for (int i = 0; i < 100; ++i) {
    world.Step();
    REQUIRE(Reading(world).AvailableCharge >= 0.0);
    REQUIRE(Reading(world).AvailableCharge <= 1.0);
    empty = empty || Reading(world).AvailableCharge == 0.0;
    full = full || Reading(world).AvailableCharge == 1.0;
  }
  CHECK((empty && full));
}

TEST_CASE("battery: a charge above the full one reads 1", "[contract][sensors]") {
  CRobotWorld world(WithBattery("<battery delta=\"0.25\" start_charge=\"0.5\"/>"));
  Battery(world).SetAvailableCharge(1.5);
  for (const Real charge : {1.0, 1.0, 0.75}) {
    world.Step();
    CHECK(Reading(world).AvailableCharge == charge);
  }
}

TEST_CASE("battery: attributes without effect in ARGoS 3 are reported, once",
          "[contract][sensors][errors]") {
  SRobotExperiment experiment = WithBattery("");
  experiment.Arena =
      "<distribute><position method=\"uniform\" min=\"-2,-2,0\" max=\"2,2,0\"/>"
      "<orientation method=\"constant\" values=\"0,0,0\"/>"
      "<entity quantity=\"5\" max_trials=\"100\"><foot-bot id=\"fb\">"
      "<controller config=\"c\"/><battery model=\"time\" factor=\"1e-5\"/></foot-bot></entity>"
      "</distribute>";
  CRobotWorld world(experiment);
  const std::string warnings = TakeLogErr();
  CHECK_THAT(warnings, Contains("[WARNING] test.argos:") && Contains("\"model\" has no effect") &&
                           Contains("\"discharge_model\"") && Contains("\"factor\" has no effect"));
  CHECK(warnings.find("\"model\"") == warnings.rfind("\"model\""));
  CHECK(warnings.find("not used") == std::string::npos);
  // the defaults apply
  world.Step();
  CHECK_THAT(world.GetSensor<CCI_BatterySensor>("fb3", "battery").GetReading().AvailableCharge,
             WithinAbs(1.0 - 1e-5, 1e-15));
}

TEST_CASE("battery: invalid experiments are refused with place and reason",
          "[contract][sensors][errors]") {
  struct SCase {
    const char* Battery;
    const char* Found;
    const char* Right;
  };
  const SCase c = GENERATE(
      SCase{"<battery discharge_model=\"tyme\"/>", "\"tyme\"", "\"time\""},
      SCase{"<battery start_charge=\"-1\"/>", "got -1", "start_charge must be a number >= 0"},
      SCase{"<battery full_charge=\"0\"/>", "got 0", "full_charge must be a number > 0"},
      SCase{"<battery start_charge=\"2\"/>", "got 2", "at most full_charge (1)"},
      SCase{"<battery delta=\"-0.5\"/>", "got -0.5", "delta must be a number >= 0"},
      SCase{"<battery discharge_model=\"motion\" orient_delta=\"-2\"/>", "got -2", "orient_delta"},
      SCase{"<battery discharge_model=\"time_motion\" pos_factor=\"x\"/>", "\"x\"", "pos_factor"},
      SCase{"<battery discharge_model=\"idle_for_tests\"/>", "idle_delta", "idle_delta"});
  CAPTURE(c.Battery);
  // with and without the sensor
  const bool sensed = GENERATE(true, false);
  SRobotExperiment experiment = WithBattery(c.Battery);
  if (!sensed) {
    experiment.Sensors = "";
  }
  CHECK_THAT(LoadError(experiment), Contains("test.argos:") && Contains("<battery>") &&
                                        Contains(c.Found) && Contains(c.Right));
}

TEST_CASE("battery component: invalid values are refused", "[contract][sensors][errors]") {
  CHECK_THROWS_WITH(CBatteryEquippedEntity(nullptr, "b", nullptr, 1.0, 0.0),
                    Contains("full charge") && Contains("> 0"));
  CHECK_THROWS_WITH(CBatteryEquippedEntity(nullptr, "b", nullptr, -1.0), Contains(">= 0"));
  CBatteryEquippedEntity battery(nullptr, "b", "motion", 1.0, 2.0);
  CHECK(battery.GetFullCharge() == 2.0);
  CHECK_THROWS_WITH(battery.SetFullCharge(-3.0), Contains("got -3"));
  CHECK_THROWS_WITH(battery.ComputeDistanceMoved(), Contains("needs a robot with a body"));
  CHECK_THROWS_WITH(battery.SetDischargeModel("motin"), Contains("motion"));
  SRobotExperiment experiment;
  experiment.Sensors = "<battery implementation=\"default\"/>";
  experiment.Arena = Robot("toy-robot", "t0", PoseText(CVector3()));
  CHECK_THAT(LoadError(experiment), Contains("\"t0\"") && Contains("battery"));
}

}  // namespace battery_test
