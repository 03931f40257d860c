// Add-ons of dynamics3d: magnets, defaults, and errors in files.

#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_plugin.h>
#include <argos3/testing/contract/physics_engines/rigid_scene.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/robot_sizes.h>

#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/query_plugins.h>
#include <argos3/core/utility/math/angles.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace argos::rigid_addons_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

// A foot-bot with a magnet at its centre of mass, at the height of its axle.
std::string MagnetXml(const std::string& id, Real x, const std::string& field) {
  std::ostringstream xml;
  xml << "<foot-bot id='" << id << "'><body position='" << x
      << ",0,0'/><controller config='driver'/><magnets><magnet id='m' anchor='origin' "
      << "offset='0,0,0.029112741' passive_field='" << field << "'/></magnets></foot-bot>";
  return xml.str();
}

}  // namespace

/** "test_probe": turns the last body that was added, and stores its motion before each substep. */
class CProbe : public CDynamics3DPlugin {
 public:
  static constexpr Real kTorque = 0.01;  // N m

  void RegisterModel(CDynamics3DModel& model) override { m_model = &model; }
  void Update() override {
    Engine = &GetEngine();
    Velocities.push_back(m_model->GetVelocity());
    Rotations.push_back(m_model->GetAngularVelocity());
    m_model->AddTorque(CVector3(0.0, 0.0, kTorque));
  }

  inline static CDynamics3DEngine* Engine = nullptr;
  inline static std::vector<CVector3> Velocities, Rotations;  // m/s, rad/s

 private:
  CDynamics3DModel* m_model = nullptr;
};

REGISTER_DYNAMICS3D_PLUGIN(CProbe, "test_probe", "tests", "1.0", "For tests.", "For tests.",
                           "Usable")

TEST_CASE("rigid add-ons: they read the motion of bodies, and change the engine during a run",
          "[contract][engine][rigid]") {
  CProbe::Velocities.clear();
  CProbe::Rotations.clear();
  CRigidScene world(
      RigidEngine("default_friction='0.25' iterations='5'", "<test_probe/><gravity g='2'/>"),
      SBoxXml{"b", CVector3(0.2, 0.4, 0.2), CVector3(0, 0, 1), CVector3(), 3.0}.ToXml());
  world.Step(2);
  CHECK(CProbe::Engine->GetDefaultFriction() == 0.25);
  CHECK(CProbe::Engine->GetNumSubsteps() == 5);
  REQUIRE(CProbe::Velocities.size() == 10);
  constexpr Real kSubstep = 0.02;  // s
  const Real inertia = 3.0 / 12.0 * (0.04 + 0.16);
  for (size_t i = 0; i < 10; ++i) {
    CHECK_THAT(CProbe::Velocities[i].GetZ(), WithinAbs(-2.0 * kSubstep * i, 1e-12));
    CHECK_THAT(CProbe::Rotations[i].GetZ(),
               WithinAbs(CProbe::kTorque / inertia * kSubstep * i, 1e-12));
  }
  // up again, to a plane that was not there
  CProbe::Engine->SetGravity(CVector3(0.0, 0.0, 4.0));
  world.Step();
  CHECK_THAT(CProbe::Velocities.back().GetZ(), WithinAbs((-20.0 + 16.0) * kSubstep, 1e-12));
  CProbe::Engine->SetGravity(CVector3(0.0, 0.0, -4.0));
  CProbe::Engine->AddGroundPlane(0.9, 1.0);
  world.Step(30);
  CHECK_THAT(world.Position("b").GetZ(), WithinAbs(0.9, 1e-3));
  // there is no world before the next tick
  CProbe::Engine->Reset();
  CHECK(CProbe::Engine->GetNumSubsteps() == 5);
}

namespace {

// Carriers of magnets in an engine without gravity, which it warns of.
class CMagnetScene : public CRigidScene {
 public:
  CMagnetScene(const std::string& magnetism, const std::string& arena)
      : CRigidScene(RigidEngine("", "<magnetism " + magnetism + "/>"), arena) {
    CHECK_THAT(TakeLogErr(), Contains("\"e\" has no gravity"));
  }
};

}  // namespace

TEST_CASE("rigid magnets: two collinear dipoles attract each other with 2 K a b / r^4",
          "[contract][engine][rigid]") {
  const Real sign = GENERATE(1.0, -1.0);
  CAPTURE(sign);
  // 2 * 1e-4 * 2 * 3 / 0.5^4 = 0.0192 N on 1.6 kg
  CMagnetScene world(
      "force_constant='1e-4'",
      MagnetXml("a", 0.0, "2,0,0") + MagnetXml("b", 0.5, sign > 0.0 ? "3,0,0" : "-3,0,0"));
  world.Step(5);
  const Real acceleration = 2.0 * 1e-4 * 6.0 / std::pow(0.5, 4) / 1.6;
  const Real path = acceleration * 1e-4 * 50.0 * 51.0 / 2.0;
  CHECK_THAT(world.Position("a").GetX(), WithinRel(sign * path, 0.03));
  CHECK_THAT(world.Position("b").GetX() - 0.5, WithinRel(-sign * path, 0.03));
}

TEST_CASE("rigid magnets: a dipole perpendicular to another one's field is turned into it",
          "[contract][engine][rigid]") {
  CMagnetScene world("force_constant='1e-3'",
                     MagnetXml("a", 0.0, "2,0,0") + MagnetXml("b", 0.5, "0,3,0"));
  world.Step(3);
  // Jackson's field at b is (2 K / (3 r^3)) a along x; torque b x B is along -z
  const Real torqueB = -3.0 * 2.0 * 1e-3 / 3.0 / 0.125 * 2.0;
  // and that of b at a is (K / (3 r^3)) (-b) along -y: the torque on a is along -z, half as large
  const Real inertia = 0.5 * 1.6 * std::pow(2.0 * kFootBotRadius, 2);
  const Real turned = torqueB / inertia * 1e-4 * 30.0 * 31.0 / 2.0;
  CHECK_THAT(world.Yaw("b"), WithinRel(turned, 0.05));
  CHECK_THAT(world.Yaw("a"), WithinRel(0.5 * turned, 0.05));
}

TEST_CASE("rigid magnets: beyond the greatest distance they have no effect",
          "[contract][engine][rigid]") {
  CMagnetScene world("force_constant='1e-4' max_distance='0.4'",
                     MagnetXml("a", 0.0, "2,0,0") + MagnetXml("b", 0.5, "3,0,0"));
  world.Step(20);
  CHECK(world.Position("a").Length() < 1e-12);
}

TEST_CASE("rigid magnets: those of one body, and those at one place, exert nothing",
          "[contract][engine][rigid]") {
  CMagnetScene world(
      "force_constant='1e-2'",
      "<foot-bot id='a'><body position='0,0,0'/><controller config='driver'/><magnets>"
      "<magnet id='m' anchor='origin' offset='0.05,0,0.1' passive_field='2,0,0'/>"
      "<magnet id='n' anchor='origin' offset='-0.05,0,0.02' passive_field='0,3,1'/>"
      "<magnet id='o' anchor='origin' offset='-0.05,0,0.02' passive_field='1,0,1'/>"
      "</magnets></foot-bot>");
  world.Step(20);
  CHECK(world.Position("a").Length() < 1e-12);
  CHECK_THAT(world.Yaw("a"), WithinAbs(0.0, 1e-12));
}

TEST_CASE("rigid magnets: after a reset the run repeats, whatever was removed before",
          "[contract][engine][rigid]") {
  CMagnetScene world("force_constant='1e-4'",
                     MagnetXml("a", 0.0, "2,0,0") + MagnetXml("b", 0.5, "3,1,0") +
                         MagnetXml("c", 0.9, "1,2,0") + MagnetXml("d", 1.4, "2,-1,0"));
  const auto end = [&world] {
    world.Step(10);
    return std::array{world.Position("a"), world.Position("b"), world.Position("d")};
  };
  // the first of the carriers becomes the last one
  world.GetSimulator().GetSpace().RemoveEntityFromPhysicsEngines(world.Body("a"));
  world.GetSimulator().GetSpace().AddEntityToPhysicsEngine(world.Body("a"));
  world.GetSimulator().Reset();
  const auto first = end();
  world.GetSimulator().Reset();
  CHECK(end() == first);
  CHECK(first[0].GetX() > 1e-3);
}

TEST_CASE("rigid add-ons: a query for the engine lists them", "[contract][engine][rigid]") {
  const std::string engine = DescribePlugins("dynamics3d");
  CHECK_THAT(engine, Contains("ADD-ONS OF DYNAMICS3D") && Contains("[ floor ]") &&
                         Contains("[ gravity ]") && Contains("[ magnetism ]"));
  CHECK_THAT(DescribePlugins("all"), Contains(DescribePlugins("dynamics3d_add_ons")));
  CHECK_THAT(DescribePlugins("magnetism"), Contains("force_constant"));
}

TEST_CASE("rigid defaults: an engine without add-ons has gravity and a floor, and logs it",
          "[contract][engine][rigid]") {
  const std::string children = GENERATE(
      "", "<solver stepper='direct'/>",
      "<boundaries><bottom height='-1'/><sides><vertex point='-9,-9'/><vertex point='9,-9'/>"
      "<vertex point='9,9'/><vertex point='-9,9'/></sides></boundaries>");
  CAPTURE(children);
  CRigidScene world(RigidEngine("", children),
                    SBoxXml{"b", CVector3(0.2, 0.2, 0.2), CVector3(1, 0, 0.5)}.ToXml() +
                        DriverXml("foot-bot", "r", 0, 1, 0, 10, 10));
  CHECK_THAT(TakeLog(), Contains("[INFO] dynamics3d without add-ons (\"e\"): gravity of 9.81 m/s^2 "
                                 "and a floor"));
  CHECK(TakeLogErr().empty());
  // 20 substeps of 0.01 s
  world.Step(2);
  CHECK_THAT(world.Position("b").GetZ(), WithinAbs(0.5 - 9.81 * 1e-4 * 20 * 21 / 2, 1e-10));
  world.Step(49);
  CHECK_THAT(world.Position("b").GetZ(), WithinAbs(0.0, 1e-3));
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(0.5, 5e-3));
}

TEST_CASE("rigid defaults: an engine with an add-on has exactly the add-ons listed",
          "[contract][engine][rigid]") {
  const std::string box = SBoxXml{"b", CVector3(0.2, 0.2, 0.2), CVector3(0, 0, 0.5)}.ToXml();
  for (const char* children : {"<gravity g='0'/>", "<floor/>", "<magnetism/>"}) {
    CAPTURE(children);
    CRigidScene world(RigidEngine("", children), box);
    world.Step(10);
    CHECK(world.Position("b") == CVector3(0, 0, 0.5));
    CHECK_THAT(TakeLog(), !Contains("without add-ons"));
  }
  // gravity without a floor
  CRigidScene world(RigidEngine("", "<gravity g='9.81'/>"), box);
  world.Step(10);
  CHECK_THAT(world.Position("b").GetZ(), WithinAbs(0.5 - 9.81 * 1e-4 * 100 * 101 / 2, 1e-9));
}

TEST_CASE("rigid defaults: the engines of a partition have them, logged once",
          "[contract][engine][rigid][partition]") {
  CRigidScene world("<auto_partition engine='dynamics3d' count='4' id='p'/>",
                    DriverXml("e-puck", "r", -0.25, -0.3, 45, 10, 10));
  CHECK_THAT(TakeLog(), Contains("(\"p_0_0\", \"p_1_0\", \"p_0_1\", \"p_1_1\"): gravity"));
  world.Step(101);
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(-0.25 + std::sqrt(0.5), 5e-3));
  CHECK(world.Body("r").GetPhysicsModel(0).GetEngine().GetId() == "p_1_1");
}

TEST_CASE("rigid defaults: files with elements of dynamics2d run with a warning",
          "[contract][engine][rigid]") {
  CRigidScene world(RigidEngine("", "<friction box_linear_friction='1'/>"),
                    SBoxXml{"b", CVector3(0.2, 0.2, 0.2), CVector3(0, 0, 0.5)}.ToXml());
  CHECK_THAT(TakeLogErr(), Contains("friction") && Contains("WARNING"));
  CHECK_THAT(TakeLog(), Contains("gravity of 9.81"));
}

TEST_CASE("rigid errors: invalid elements are reported with their place",
          "[contract][engine][rigid][errors]") {
  const auto load = [](const std::string& attributes, const std::string& children,
                       const std::string& arena = "") {
    const CRigidScene world(RigidEngine(attributes, children), arena);
  };
  CHECK_THROWS_WITH(load("", "<gravty/>"), Contains("test.argos:") &&
                                               Contains("<dynamics3d> has no add-on <gravty>") &&
                                               Contains("gravity"));
  CHECK_THROWS_WITH(load("", "<gravity g='1' vector='0,0,1'/>"), Contains("either \"g\""));
  CHECK_THROWS_WITH(load("", "<gravity g='inf'/>"), Contains("gravity"));
  CHECK_THROWS_WITH(load("", "<floor friction='-1'/>"),
                    Contains("\"friction\" must be a number >= 0, got -1"));
  CHECK_THROWS_WITH(load("", "<magnetism max_distance='0'/>"), Contains("\"max_distance\" (m)"));
  CHECK_THROWS_WITH(load("iterations='0'", ""), Contains("\"iterations\" must be at least 1"));
  CHECK_THROWS_WITH(load("iterations='10001'", ""),
                    Contains("\"iterations\" must be at most 10000, found 10001"));
  CHECK_THROWS_WITH(load("default_friction='-0.1'", ""),
                    Contains("\"default_friction\" must be a number in [0,1000], found -0.1"));
  CHECK_THROWS_WITH(load("", "<solver stepper='quick'/>"),
                    Contains("must be \"mixed\", \"direct\" or \"iterative\", found \"quick\""));
  CHECK_THROWS_WITH(load("", "<solver iterations='0'/>"), Contains("[1,1000], found 0"));
  CHECK_THROWS_WITH(load("", "<solver erp='1.5'/>"), Contains("\"erp\"") && Contains("found 1.5"));
  CHECK_THROWS_WITH(load("", "<solver erp='0.009'/>"),
                    Contains("\"erp\"") && Contains("found 0.009"));
  CHECK_NOTHROW(load("", "<solver erp='0.01'/>"));
  CHECK_NOTHROW(load("", "<solver erp='1'/>"));
  CHECK_THROWS_WITH(load("", "<solver cfm='0'/>"), Contains("\"cfm\""));
  CHECK_THROWS_WITH(load("", "<contacts restitution='2'/>"), Contains("\"restitution\""));
  CHECK_THROWS_WITH(load("", "", DriverXml("e-puck", "r", 1e7, 0, 0, 0, 0)),
                    Contains("\"r\" at (1e+07,0,0) is farther than 1e+06 m from the origin"));
  CHECK_NOTHROW(load("debug_file='x'", ""));
}

TEST_CASE("rigid errors: the ends of a range are in it", "[contract][engine][rigid][errors]") {
  struct SCase {
    const char* Before;  // of the value
    const char* After;
    const char* Least;
    const char* Most;
    const char* TooLittle;
    const char* TooMuch;
  };
  const SCase c =
      GENERATE(SCase{"<solver iterations='", "'/>", "1", "1000", "0", "1001"},
               SCase{"<solver erp='", "'/>", "0.01", "1", "0.0099", "1.01"},
               SCase{"<solver cfm='", "'/>", "1e-10", "1", "0.9e-10", "1.01"},
               SCase{"<contacts restitution='", "'/>", "0", "1", "-0.01", "1.01"},
               SCase{"<contacts bounce_speed='", "'/>", "0", "1000", "-0.01", "1001"},
               SCase{"<contacts surface_layer='", "'/>", "0", "0.1", "-0.001", "0.101"},
               SCase{"<contacts max_correcting_speed='", "'/>", "0.001", "1000", "0.0009", "1001"});
  CAPTURE(c.Before);
  const auto load = [&c](const char* value) {
    const CRigidScene world(RigidEngine("", std::string(c.Before) + value + c.After), "");
  };
  for (const char* const value : {c.Least, c.Most}) {
    CAPTURE(value);
    CHECK_NOTHROW(load(value));
  }
  for (const char* const value : {c.TooLittle, c.TooMuch}) {
    CAPTURE(value);
    CHECK_THROWS_WITH(load(value), Contains("must be") && Contains("found "));
  }
}

TEST_CASE("rigid errors: a body too far from the origin is reported",
          "[contract][engine][rigid][errors]") {
  CRigidScene world(RigidEngine("", "<gravity g='1e4'/>"),
                    SBoxXml{"b", CVector3(1, 1, 1), CVector3(0, 0, 0)}.ToXml());
  CHECK_THROWS_WITH(world.Step(200), Contains("\"b\" is now at (") &&
                                         Contains("farther than 1e+06 m from the origin"));
}

}  // namespace argos::rigid_addons_test
