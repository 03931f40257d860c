// Pheromones: robots deposit where they are, and read the concentration of the field.

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pheromone_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pheromone_sensor.h>
#include <argos3/plugins/simulator/media/pheromone_medium.h>
#include <argos3/testing/support/invariants.h>
#include <argos3/testing/support/no_allocation.h>
#include <argos3/testing/support/robot_world.h>
#include <argos3/testing/support/statistics.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace argos::pheromone_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr Real kTick = 0.1;  // s
constexpr Real kRounding = 1e-12;

// 40 x 20 cells of 0.05 m x 0.05 m from (-0.5,-0.5) on: centres are at 0.025 + multiples of 0.05
const char* const kRegion = "size=\"2,1\" center=\"0.5,0\" cell_size=\"0.05\"";

struct SSetup {
  std::string Layers = "<layer id=\"trail\"/>";
  std::string Medium = kRegion;
  std::string Actuator = "";  // attributes, like the members below
  std::string ActuatorChildren = "";
  std::string Sensor = "";
  std::string SensorChildren = "";
};

SRobotExperiment WithPheromones(const std::string& arena, const SSetup& setup = {}) {
  SRobotExperiment experiment;
  const std::string device = "<pheromone implementation=\"medium\" medium=\"scents\" ";
  experiment.Actuators = device + setup.Actuator + ">" + setup.ActuatorChildren + "</pheromone>";
  experiment.Sensors = device + setup.Sensor + ">" + setup.SensorChildren + "</pheromone>";
  experiment.Media =
      "<pheromone id=\"scents\" " + setup.Medium + ">" + setup.Layers + "</pheromone>";
  experiment.Arena = arena;
  return experiment;
}

std::string Layer(const std::string& id, const std::string& attributes = "") {
  return "<layer id=\"" + id + "\" " + attributes + "/>";
}

CPheromoneMedium& Medium(CTestWorld& world) {
  return world.GetSimulator().GetMedium<CPheromoneMedium>("scents");
}

CCI_PheromoneActuator& Actuator(CRobotWorld& world, const std::string& robot = "r") {
  return world.GetActuator<CCI_PheromoneActuator>(robot, "pheromone");
}

const CCI_PheromoneSensor& Sensor(CRobotWorld& world, const std::string& robot = "r") {
  return world.GetSensor<CCI_PheromoneSensor>(robot, "pheromone");
}

Real Total(CTestWorld& world, size_t layer = 0) {
  return Medium(world).GetField(layer).ComputeTotal();
}

CEmbodiedEntity& Body(CTestWorld& world, const std::string& robot) {
  return world.Get<CComposableEntity>(robot).GetComponent<CEmbodiedEntity>("body");
}

// in the centre of a cell, facing along y
std::string RobotInCell(const std::string& tag = "foot-bot", const std::string& id = "r") {
  return Robot(tag, id, "position=\"0.525,0.025,0\" orientation=\"90,0,0\"");
}

}  // namespace

TEST_CASE("pheromone: is deposited at the robot's position and read below its sensors",
          "[contract][media]") {
  const std::string tag = GENERATE("foot-bot", "e-puck", "eye-bot", "toy-robot");
  CAPTURE(tag);
  SSetup setup;
  // 10 cm ahead of the robot is the centre of a cell, at (0.525,0.125)
  setup.Actuator = "offset=\"0.1,0\"";
  setup.SensorChildren =
      "<point offset=\"0.1,0\"/><point offset=\"0.075,0\"/><point offset=\"0.1,0.025\"/>"
      "<point offset=\"0.1,-0.025\"/><point offset=\"0.0875,0.0125\"/><point offset=\"0.05,0\"/>";
  CRobotWorld world(WithPheromones(RobotInCell(tag), setup));
  world.Step();
  CHECK(Total(world) == 0.0);
  Actuator(world).SetRate(3.0);
  CHECK(Sensor(world).GetReadings()[0].Value == 0.0);
  world.Step();
  // 3/s for 0.1 s into 0.0025 m^2; between centres of cells the reading
  // falls linearly along each axis
  const Real here = 3.0 * kTick / (0.05 * 0.05);
  const auto& readings = Sensor(world).GetReadings();
  REQUIRE(readings.size() == 6);
  const Real shares[] = {1.0, 0.5, 0.5, 0.5, 0.5625, 0.0};
  for (size_t i = 0; i < 6; ++i) {
    CAPTURE(i);
    CHECK_THAT(readings[i].Value, WithinAbs(shares[i] * here, here * kRounding));
  }
  // offsets are in the robot's frame, in cm
  CHECK_THAT(readings[2].Offset.GetX(), WithinAbs(10.0, kRounding));
  CHECK_THAT(readings[2].Offset.GetY(), WithinAbs(2.5, kRounding));
  CHECK_THAT(Medium(world).GetConcentration(0, CVector3(0.525, 0.125, 7.0)),
             WithinRel(here, kRounding));
  // the rate holds until the next order
  world.Step(9);
  CHECK_THAT(Total(world), WithinRel(10 * 3.0 * kTick, kRounding));
  Actuator(world).SetRate(0.5);
  world.Step(2);
  CHECK_THAT(Total(world), WithinRel(10 * 3.0 * kTick + 2 * 0.5 * kTick, kRounding));
  Actuator(world).SetRate(0.0);
  world.Step(2);
  CHECK_THAT(Total(world), WithinRel(3.1, kRounding));
}

TEST_CASE("pheromone: is deposited before the robot's motion and read after it",
          "[contract][media]") {
  const std::string tag = GENERATE("foot-bot", "e-puck");
  SRobotExperiment experiment =
      WithPheromones(Robot(tag, "r", "position=\"0.525,0.025,0\" orientation=\"0,0,0\""));
  experiment.Engine = "<dynamics2d id=\"engine\" velocity_lag=\"0\"/>";
  experiment.Actuators += "<differential_steering implementation=\"default\"/>";
  CRobotWorld world(experiment);
  world.GetActuator<CCI_DifferentialSteeringActuator>("r", "differential_steering")
      .SetLinearVelocity(10.0, 10.0);
  Actuator(world).SetRate(1.0);
  world.Step();
  CHECK_THAT(Body(world, "r").GetOriginAnchor().Position.GetX(), WithinAbs(0.535, 1e-9));
  CHECK_THAT(Medium(world).GetField(0).GetCell(20, 10), WithinRel(40.0, kRounding));
  // the robot is 1 cm off the centre of a cell of 5 cm; the engine
  // computes lengths in single precision
  CHECK_THAT(Sensor(world).GetReadings()[0].Value, WithinAbs(40.0 * 0.8, 1e-5));
}

TEST_CASE("pheromone: deposits add up, and evaporation is exp(-t / tau)", "[contract][media]") {
  SSetup setup;
  setup.Layers = Layer("trail", "evaporation=\"0.25\"");
  CRobotWorld world(
      WithPheromones(RobotInCell("foot-bot", "a") + RobotInCell("e-puck", "b"), setup));
  Actuator(world, "a").SetRate(1.0);
  Actuator(world, "b").SetRate(2.5);
  world.Step();
  const Real factor = std::exp(-0.25 * kTick);
  Real expected = 3.5 * kTick / 0.0025 * factor;
  CHECK_THAT(Sensor(world, "a").GetReadings()[0].Value, WithinRel(expected, kRounding));
  CHECK(Sensor(world, "b").GetReadings()[0].Value == Sensor(world, "a").GetReadings()[0].Value);
  Actuator(world, "a").SetRate(0.0);
  Actuator(world, "b").SetRate(0.0);
  world.Step(600);
  expected *= std::exp(-0.25 * 60.0);
  CHECK_THAT(Sensor(world, "a").GetReadings()[0].Value, WithinRel(expected, 600 * kRounding));
  // at a constant rate the total converges to that of the geometric series
  Actuator(world, "a").SetRate(1.0);
  world.Step(2000);
  CHECK_THAT(Total(world), WithinRel(kTick * factor / (1.0 - factor), 1e-11));
}

TEST_CASE("pheromone: diffuses by 2 D t along each axis and stays in its region",
          "[contract][media]") {
  SSetup setup;
  setup.Layers = Layer("trail", "diffusion=\"0.001\"");
  CRobotWorld world(WithPheromones(RobotInCell(), setup));
  Actuator(world).SetRate(2.0);
  world.Step();
  Actuator(world).SetRate(0.0);
  world.Step(9);
  const CPheromoneField& field = Medium(world).GetField(0);
  CVector2 variance;
  for (size_t j = 0; j < field.GetGrid().NumY; ++j) {
    for (size_t i = 0; i < field.GetGrid().NumX; ++i) {
      const CVector2 off = field.GetCenter(i, j) - CVector2(0.525, 0.025);
      variance += CVector2(off.GetX() * off.GetX(), off.GetY() * off.GetY()) *
                  (field.GetCell(i, j) * 0.0025 / 0.2);
    }
  }
  // in 1 s the standard deviation is 4.5 cm, and the borders are 47 cm away
  CHECK_THAT(variance.GetX(), WithinRel(2.0 * 0.001 * 1.0, 1e-9));
  CHECK_THAT(variance.GetY(), WithinRel(2.0 * 0.001 * 1.0, 1e-9));
  world.Step(5000);
  CHECK_THAT(Total(world), WithinRel(0.2, 1e-11));
  // 500 s: the slowest mode, along 2 m, has decayed by exp(-D (PI / 2 m)^2 t) = 0.29
  const Real even = 0.2 / 2.0;
  CHECK_THAT(Sensor(world).GetReadings()[0].Value, WithinAbs(even, 0.02 * even));
}

TEST_CASE("pheromone: in a periodic arena it spreads across the sides that are joined",
          "[contract][media]") {
  const std::string axes = GENERATE("x", "y", "true");
  CAPTURE(axes);
  const auto world = [&axes](const CVector3& place) {
    SExperiment experiment;
    experiment.Engines = "<kinematics2d id='e'/>";
    experiment.Media =
        "<pheromone id='scents' cell_size='0.1'><layer id='trail' diffusion='0.002'/></pheromone>";
    experiment.ArenaSize = "1,1,1";
    experiment.ArenaAttributes = "periodic='" + axes + "'";
    auto made = std::make_unique<CTestWorld>(experiment);
    const CSimulator::CScope scope(made->GetSimulator());
    Medium(*made).Deposit(0, place, 0.5);
    made->Step(30);
    return made;
  };
  // once in the middle, and once on the seams
  const CVector3 shift(axes == "y" ? 0.0 : 0.5, axes == "x" ? 0.0 : 0.5, 0.0);
  const auto middle = world(CVector3());
  const auto seam = world(shift);
  CHECK_THAT(Total(*seam), WithinRel(0.5, 1e-12));
  for (int i = -5; i < 5; ++i) {
    for (int j = -5; j < 5; ++j) {
      const CVector3 offset(0.1 * i + 0.05, 0.1 * j + 0.05, 0.0);
      CAPTURE(offset);
      const Real expected = Medium(*middle).GetConcentration(0, offset);
      // outside of the arena, too
      CHECK_THAT(Medium(*seam).GetConcentration(0, shift + offset), WithinAbs(expected, 1e-12));
      CHECK_THAT(Medium(*seam).GetConcentration(0, offset - shift), WithinAbs(expected, 1e-12));
    }
  }
}

TEST_CASE("pheromone: layers are independent of each other", "[contract][media]") {
  SSetup setup;
  setup.Layers = Layer("home") + Layer("food", "evaporation=\"1\"") + Layer("alarm");
  setup.Sensor = "layers=\"alarm,home\"";
  setup.Actuator = "layers=\"food, home\"";
  CRobotWorld world(WithPheromones(RobotInCell(), setup));
  REQUIRE(Actuator(world).GetInterfaces().size() == 2);
  CHECK(Actuator(world).GetInterfaces()[0].Layer == "food");
  CHECK(Actuator(world).GetInterfaces()[1].Layer == "home");
  REQUIRE(Sensor(world).GetInterfaces().size() == 2);
  CHECK(Sensor(world).GetInterfaces()[0].Layer == "alarm");
  CHECK(&Sensor(world).GetReadings() == &Sensor(world).GetReadings("alarm"));

  Actuator(world).SetRate(4.0);  // the rate applies to the first layer of the actuator
  Actuator(world).SetRate("home", 1.0);
  world.Step(3);
  CHECK_THAT(Total(world, 0), WithinRel(0.3, kRounding));
  const Real factor = std::exp(-kTick);
  CHECK_THAT(Total(world, 1),
             WithinRel(0.4 * (factor + factor * factor + factor * factor * factor), kRounding));
  CHECK(Total(world, 2) == 0.0);
  CHECK(Sensor(world).GetReadings("alarm")[0].Value == 0.0);
  CHECK_THAT(Sensor(world).GetReadings("home")[0].Value, WithinRel(0.3 / 0.0025, kRounding));
  CHECK(Medium(world).GetNumLayers() == 3);
  CHECK(Medium(world).GetLayerNumber("food") == 1);
  CHECK(Medium(world).GetLayerId(1) == "food");

  CHECK_THROWS_WITH(Sensor(world).GetReadings("hmoe"), Contains("hmoe") && Contains("home"));
  CHECK_THROWS_WITH(Actuator(world).SetRate("alarm", 1.0), Contains("unknown layer \"alarm\""));
  CHECK_THROWS_WITH(Medium(world).GetLayerNumber("fod"), Contains("fod") && Contains("food"));
}

TEST_CASE("pheromone: outside the region nothing is deposited or read", "[contract][media]") {
  CRobotWorld world(WithPheromones(Robot("foot-bot", "in", "position=\"-0.49,-0.49,0\"") +
                                   Robot("foot-bot", "out", "position=\"-0.51,-0.2,0\"")));
  Actuator(world, "in").SetRate(1.0);
  Actuator(world, "out").SetRate(1.0);
  world.Step();
  CHECK_THAT(Total(world), WithinRel(kTick, kRounding));
  CHECK_THAT(Sensor(world, "in").GetReadings()[0].Value, WithinRel(kTick / 0.0025, kRounding));
  CHECK(Sensor(world, "out").GetReadings()[0].Value == 0.0);
}

TEST_CASE("pheromone: by default the region is the arena, divided into whole cells",
          "[contract][media]") {
  SSetup setup;
  setup.Medium = "cell_size=\"0.3\"";
  CRobotWorld world(WithPheromones(RobotInCell(), setup));
  // 10 m x 10 m around the origin: 34 cells of 0.294 m
  const auto& grid = Medium(world).GetField(0).GetGrid();
  CHECK(grid.NumX == 34);
  CHECK(grid.NumY == 34);
  CHECK_THAT(grid.CellX, WithinRel(10.0 / 34.0, kRounding));
  CHECK(grid.MinX == -5.0);
  CHECK(grid.MinY == -5.0);
  // at least one cell, also if the region is smaller
  setup.Medium = "cell_size=\"30\"";
  CRobotWorld coarse(WithPheromones(RobotInCell(), setup));
  const auto& one = Medium(coarse).GetField(0).GetGrid();
  CHECK(one.NumX == 1);
  CHECK(one.NumY == 1);
  CHECK(one.CellX == 10.0);
}

TEST_CASE("pheromone: programs can read and change the field", "[contract][media]") {
  SSetup setup;
  setup.Layers = Layer("trail", "maximum=\"50\" evaporation=\"1\"");
  CRobotWorld world(WithPheromones(RobotInCell(), setup));
  CPheromoneField& field = Medium(world).GetField(0);
  CHECK_THAT(field.GetCenter(20, 10).GetX(), WithinAbs(0.525, kRounding));
  CHECK_THAT(field.GetCenter(20, 10).GetY(), WithinAbs(0.025, kRounding));
  field.SetCell(20, 10, 32.0);
  world.Step();
  const Real left = 32.0 * std::exp(-kTick);
  CHECK_THAT(Sensor(world).GetReadings()[0].Value, WithinRel(left, kRounding));
  CHECK_THAT(field.GetCell(20, 10), WithinRel(left, kRounding));
  field.SetCell(20, 10, 1.0);
  CHECK_THAT(field.GetCell(20, 10), WithinRel(1.0, kRounding));
  Medium(world).Deposit(0, CVector3(0.525, 0.025, 0.0), 0.01);
  CHECK_THAT(field.GetCell(20, 10), WithinRel(5.0, kRounding));
  // a deposit beyond the maximum is lost
  Medium(world).Deposit(0, CVector3(0.525, 0.025, 0.0), 1.0);
  CHECK_THAT(field.GetCell(20, 10), WithinRel(50.0, kRounding));
  field.Clear();
  CHECK(field.ComputeTotal() == 0.0);

  CHECK_THROWS_WITH(field.SetCell(40, 0, 1.0), Contains("(40,0)") && Contains("40 x 20"));
  CHECK_THROWS_WITH(field.SetCell(0, 20, 1.0), Contains("(0,20)"));
  for (const Real wrong : {-1e-9, 51.0, std::nan("")}) {
    CHECK_THROWS_WITH(field.SetCell(0, 0, wrong), Contains("[0,50]"));
  }
  for (const Real wrong : {-1e-9, HUGE_VAL, std::nan("")}) {
    CHECK_THROWS_WITH(Medium(world).Deposit(0, CVector3(), wrong),
                      Contains("amount must be a number"));
  }
}

TEST_CASE("pheromone: the field changes the digest", "[contract][media]") {
  SSetup setup;
  setup.Layers = Layer("a") + Layer("b");
  CRobotWorld world(WithPheromones(RobotInCell(), setup));
  world.Step();
  const UInt64 before = world.ComputeDigest();
  Medium(world).GetField(1).SetCell(39, 19, 1e-9);
  CHECK(world.ComputeDigest() != before);
  Medium(world).GetField(1).Clear();
  CHECK(world.ComputeDigest() == before);
}

TEST_CASE("pheromone: after a reset the field is empty and rates are zero", "[contract][media]") {
  CRobotWorld world(WithPheromones(RobotInCell()));
  Actuator(world).SetRate(1.0);
  world.Step(3);
  world.GetSimulator().Reset();
  CHECK(Total(world) == 0.0);
  CHECK(Sensor(world).GetReadings()[0].Value == 0.0);
  CHECK(Actuator(world).GetInterfaces()[0].Rate == 0.0);
  world.Step(3);
  CHECK(Total(world) == 0.0);
}

TEST_CASE("pheromone: robots can be added and removed", "[contract][media]") {
  CRobotWorld world(WithPheromones(RobotInCell("foot-bot", "a") + RobotInCell("e-puck", "b")));
  Actuator(world, "a").SetRate(1.0);
  Actuator(world, "b").SetRate(2.0);
  world.Step();
  world.GetSimulator().GetLoopFunctions().RemoveEntity("a");
  world.Step();
  CHECK_THAT(Total(world), WithinRel((3.0 + 2.0) * kTick, kRounding));
  CHECK_THAT(Sensor(world, "b").GetReadings()[0].Value, WithinRel(0.5 / 0.0025, kRounding));
}

TEST_CASE("pheromone noise: readings and rates have the stated distribution", "[contract][media]") {
  SSetup setup;
  setup.SensorChildren =
      "<noise on=\"value\" model=\"gaussian\" std_dev=\"0.05\" relative=\"true\"/>";
  setup.ActuatorChildren = "<noise on=\"rate\" model=\"uniform\" level=\"0.2\"/>";
  CRobotWorld world(WithPheromones(RobotInCell(), setup));
  constexpr size_t kDraws = 4000;
  std::vector<Real> errors;
  std::vector<Real> rates;
  CPheromoneField& field = Medium(world).GetField(0);
  Actuator(world).SetRate(1.0);
  for (size_t i = 0; i < kDraws; ++i) {
    field.Clear();
    world.Step();
    const Real truth = field.GetCell(20, 10);
    errors.push_back(Sensor(world).GetReadings()[0].Value / truth - 1.0);
    rates.push_back(truth * 0.0025 / kTick);
  }
  // exceeded for one seed in a million
  CHECK(KolmogorovSmirnovExcess(errors, [](Real e) { return NormalDistribution(e, 0.05); }) < 1.0);
  CHECK(KolmogorovSmirnovExcess(
            rates, [](Real rate) { return std::clamp((rate - 0.8) / 0.4, 0.0, 1.0); }) < 1.0);
  // without a deposit there is no noise
  Actuator(world).SetRate(0.0);
  field.Clear();
  world.Step();
  CHECK(Total(world) == 0.0);
  world.GetSimulator().Reset();
  Actuator(world).SetRate(1.0);
  world.Step();
  CHECK_THAT(field.GetCell(20, 10) * 0.0025 / kTick, WithinRel(rates[0], kRounding));
  CHECK_THAT(Sensor(world).GetReadings()[0].Value / field.GetCell(20, 10) - 1.0,
             WithinAbs(errors[0], kRounding));
}

TEST_CASE("pheromone noise: readings and rates stay >= 0", "[contract][media]") {
  SSetup setup;
  setup.SensorChildren = "<noise on=\"value\" model=\"gaussian\" std_dev=\"10\"/>";
  setup.ActuatorChildren = "<noise on=\"rate\" model=\"gaussian\" std_dev=\"1\"/>";
  CRobotWorld world(WithPheromones(RobotInCell(), setup));
  Actuator(world).SetRate(0.01);
  size_t numZero = 0;
  Real total = 0.0;
  for (int i = 0; i < 200; ++i) {
    world.Step();
    REQUIRE(Sensor(world).GetReadings()[0].Value >= 0.0);
    REQUIRE(Total(world) >= total);
    numZero += Total(world) == total ? 1 : 0;
    total = Total(world);
  }
  // every other rate is clamped to 0; tolerance of five standard deviations
  CHECK_THAT(static_cast<Real>(numZero), WithinAbs(100.0, 5.0 * std::sqrt(50.0)));
}

TEST_CASE("pheromone: a tick in steady state allocates nothing", "[contract][media][allocation]") {
  SSetup setup;
  setup.Layers = Layer("fast", "diffusion=\"1\" evaporation=\"100\"") +
                 Layer("slow", "diffusion=\"0.001\" maximum=\"9\"");
  setup.SensorChildren = "<point offset=\"0,0.1\"/><point offset=\"0,-0.1\"/>";
  std::string arena;
  for (int i = 0; i < 20; ++i) {
    arena += Robot("e-puck", "e" + std::to_string(i),
                   "position=\"" + ToText(CVector3(0.09 * i - 0.4, 0.0, 0.0)) + "\"");
  }
  CRobotWorld world(WithPheromones(arena, setup));
  const auto setRates = [&](Real rate) {
    for (int i = 0; i < 20; ++i) {
      for (auto& interface : Actuator(world, "e" + std::to_string(i)).GetInterfaces()) {
        interface.Rate = rate;
      }
    }
  };
  setRates(1.0);
  world.Step(2);
  CheckAllocatesNothing([&] { world.Step(10); });
}

TEST_CASE("pheromone: invalid experiments are refused with the reason",
          "[contract][media][errors]") {
  SSetup setup;
  const auto error = [&] { return LoadError(WithPheromones(RobotInCell(), setup)); };
  SECTION("without layers") {
    setup.Layers = "";
    CHECK_THAT(error(), Contains("test.argos:") && Contains("needs at least one child <layer"));
  }
  SECTION("invalid layers") {
    setup.Layers = Layer("a") + Layer("a");
    CHECK_THAT(error(), Contains("already a layer with id \"a\""));
    setup.Layers = "<layer/>";
    CHECK_THAT(error(), Contains("id"));
    for (const std::string attribute : {"evaporation", "diffusion"}) {
      setup.Layers = Layer("a", attribute + "=\"-0.1\"");
      CHECK_THAT(error(), Contains("test.argos:") && Contains("<layer>") && Contains(attribute) &&
                              Contains(">= 0, got -0.1"));
      setup.Layers = Layer("a", attribute + "=\"nan\"");
      CHECK_THAT(error(), Contains("<layer>: attribute \"" + attribute + "\""));
    }
    setup.Layers = Layer("a", "maximum=\"0\"");
    CHECK_THAT(error(), Contains("maximum") && Contains("> 0, got 0"));
  }
  SECTION("invalid cells") {
    setup.Medium = "cell_size=\"0\"";
    CHECK_THAT(error(), Contains("cell_size") && Contains("> 0, got 0"));
    setup.Medium = "cell_size=\"-1\"";
    CHECK_THAT(error(), Contains("cell_size") && Contains("> 0, got -1"));
    setup.Medium = "cell_size=\"1e-6\"";
    CHECK_THAT(error(), Contains("test.argos:") && Contains("too small for 10 m x 10 m"));
    setup.Medium = "size=\"1,0\"";
    CHECK_THAT(error(), Contains("\"size\" (m) along y") && Contains("> 0, got 0"));
    setup.Medium = "size=\"-2,1\"";
    CHECK_THAT(error(), Contains("\"size\" (m) along x") && Contains("> 0, got -2"));
    setup.Medium = "center=\"1\"";
    CHECK_THAT(error(), Contains("center"));
  }
  SECTION("invalid devices") {
    for (std::string* device : {&setup.Actuator, &setup.Sensor}) {
      *device = "layers=\"trial\"";
      CHECK_THAT(error(), Contains("no layer \"trial\"") && Contains("trail") &&
                              Contains("test.argos:") && Contains("<pheromone>"));
      *device = "layers=\"trail,trail\"";
      CHECK_THAT(error(), Contains("listed twice"));
      *device = "layers=\"\"";
      CHECK_THAT(error(), Contains("no layer is listed"));
      *device = "";
    }
    setup.SensorChildren = "<point/>";
    CHECK_THAT(error(), Contains("offset"));
    setup.SensorChildren = "<noise on=\"rate\" model=\"uniform\" level=\"1\"/>";
    CHECK_THAT(error(), Contains("rate") && Contains("value"));
  }
  SECTION("a medium that is missing or of the wrong type") {
    SRobotExperiment experiment = WithPheromones(RobotInCell());
    experiment.Media = "<led id=\"scents\"/>";
    CHECK_THAT(LoadError(experiment), Contains("a pheromone medium, got \"scents\""));
    experiment.Media = "<pheromone id=\"scent\"><layer id=\"trail\"/></pheromone>";
    CHECK_THAT(LoadError(experiment), Contains("got \"scents\"") && Contains("scent\""));
    experiment.Sensors = "<pheromone implementation=\"medium\"/>";
    CHECK_THAT(LoadError(experiment), Contains("medium"));
  }
  SECTION("invalid rates of controllers") {
    CRobotWorld world(WithPheromones(RobotInCell()));
    for (const Real wrong : {-1.0, HUGE_VAL, std::nan("")}) {
      CHECK_THROWS_WITH(Actuator(world).SetRate(wrong),
                        Contains("\"trail\" must be a number >= 0"));
    }
    Actuator(world).GetInterfaces()[0].Rate = -2.0;
    CHECK_THROWS_WITH(world.Step(), Contains(">= 0 (amount per second), got -2") && Contains("r"));
  }
}

TEST_CASE("pheromone: a layer that does not exist is noticed", "[contract][media][invariants]") {
  CRobotWorld world(WithPheromones(RobotInCell("e-puck")));
  CPheromoneMedium& medium = Medium(world);
  CheckCaught([&] { medium.GetField(1); }, "there is no layer 1");
  CheckCaught([&] { static_cast<void>(medium.GetLayerId(1)); }, "there is no layer 1");
  CheckCaught([&] { medium.Deposit(1, CVector3(), 1.0); }, "there is no layer 1");
  CheckCaught([&] { static_cast<void>(medium.GetConcentration(1, CVector3())); }, "no layer 1");
}

}  // namespace argos::pheromone_test
