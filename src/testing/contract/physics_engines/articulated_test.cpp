// Compares prototypes, whose joints dynamics3d moves, with mechanics.

#include <argos3/testing/contract/physics_engines/rigid_scene.h>

#include <argos3/core/simulator/geometry/articulation.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/prototype/simulator/prototype_entity.h>
#include <argos3/plugins/simulator/entities/joint_equipped_entity.h>
#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace argos::articulated_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using EMode = CJointEquippedEntity::EMode;

namespace {

constexpr Real kSubstep = 0.01;  // s, of the default
constexpr Real kGravity = 9.81;  // m/s^2

std::string Prototype(const std::string& attributes, const std::string& position,
                      const std::string& links, const std::string& joints) {
  return "<prototype id='p' " + attributes + "><body position='" + position +
         "'/><links ref='base'>" + links + "</links><joints>" + joints + "</joints></prototype>";
}

std::string Joint(const std::string& attributes, const std::string& parent,
                  const std::string& child) {
  return "<joint " + attributes + "><parent " + parent + "/><child " + child + "/></joint>";
}

const std::string kBase = "<link id='base' geometry='box' size='0.1,0.1,0.1' mass='1'/>";
const std::string kRod = "<link id='rod' geometry='box' size='0.02,0.02,0.5' mass='0.4'/>";

/** A world with the prototype "p". */
class CJointWorld : public CRigidScene {
 public:
  using CRigidScene::CRigidScene;

  CJointEquippedEntity& Joints() { return Get<CPrototypeEntity>("p").GetJointEquippedEntity(); }
  Real Coordinate(size_t joint = 0) { return Joints().GetJoint(joint).Position; }
  Real Speed(size_t joint = 0) { return Joints().GetJoint(joint).Velocity; }
  // a point of a link, given in the frame of its anchor, m, world frame
  CVector3 Locate(const std::string& link, const CVector3& point) {
    SAnchor& anchor = Body("p").GetAnchor(link);
    if (anchor.InUseCount == 0) {
      anchor.Enable();
    }
    CVector3 place = point;
    place.Rotate(anchor.Orientation);
    return anchor.Position + place;
  }
};

// a rod on a fixed base. @param joint, onBase, onRod  attributes
std::string FixedArm(const std::string& position, const std::string& joint,
                     const std::string& onBase, const std::string& onRod) {
  return Prototype("movable='false'", position, kBase + kRod,
                   Joint(joint, "link='base' " + onBase, "link='rod' " + onRod));
}

// a rod that hangs from a fixed base, 0.1 rad from the vertical
std::string Pendulum(const std::string& type, Real angle = 0.1) {
  std::ostringstream child;
  child << "position='0,0,0.5' orientation='0," << -angle * 180.0 / ARGOS_PI << ",0'";
  return FixedArm("0,0,2", "id='j' type='" + type + "' axis='0,1,0'", "", child.str());
}

}  // namespace

TEST_CASE("joints: a rod on a hinge swings with the period of a physical pendulum",
          "[contract][engine][rigid][joints]") {
  const std::string stepper = GENERATE("mixed", "direct", "iterative");
  CAPTURE(stepper);
  CJointWorld world(
      RigidEngine("iterations='100'", "<gravity g='9.81'/><solver stepper='" + stepper +
                                          "' iterations='100' cfm='1e-9'/>"),
      Pendulum("revolute"));
  const Real start = 0.1;
  // about the hinge: m (L^2 + w^2) / 12 + m (L / 2)^2, per m; lever L / 2
  const Real inertia = (0.25 + 0.0004) / 12.0 + 0.0625;
  // the period of a pendulum grows with the angle by 1 + angle^2 / 16
  const Real rate = std::sqrt(kGravity * 0.25 / inertia) / (1.0 + start * start / 16.0);
  for (int tick = 1; tick <= 40; ++tick) {
    world.Step();
    // the integrator lags by half a substep of 1 ms and loses amplitude by less than 2 %; the
    // iterative solver leaves a hundredth more
    const Real margin = stepper == "iterative" ? 0.03 : 0.02;
    CHECK_THAT(world.Coordinate(),
               WithinAbs(start * (std::cos(rate * 0.1 * tick) - 1.0), margin * 2.0 * start));
  }
}

TEST_CASE("joints: a slider falls freely along its axis as far as its limit",
          "[contract][engine][rigid][joints]") {
  CJointWorld world(RigidEngine("", "<gravity g='9.81'/>"),
                    FixedArm("0,0,2", "id='j' type='prismatic' axis='0,0,1' limit='-0.4:0.1'", "",
                             "position='0,0,0.5'"));
  world.Step(2);
  const Real fallen = 0.5 * kGravity * 0.2 * 0.2;
  // the integrator differs by g h t / 2, or less in shorter substeps
  const Real margin = 0.5 * kGravity * kSubstep * 0.2 + 1e-9;
  CHECK_THAT(world.Coordinate(), WithinAbs(-fallen, margin));
  CHECK_THAT(world.Speed(), WithinAbs(-kGravity * 0.2, 1e-6));
  CHECK_THAT(world.Locate("rod", CVector3()).GetZ(), WithinAbs(1.5 + world.Coordinate(), 1e-9));
  world.Step(20);
  // the stop is as soft as the other constraints
  CHECK_THAT(world.Coordinate(), WithinAbs(-0.4, 2e-3));
  CHECK_THAT(world.Speed(), WithinAbs(0.0, 1e-3));
}

TEST_CASE("joints: a double pendulum on ball joints keeps its lengths and gains no energy",
          "[contract][engine][rigid][joints]") {
  const std::string tip = "<link id='tip' geometry='sphere' radius='0.05' mass='0.2'/>";
  CJointWorld world(
      RigidEngine("iterations='100'", "<gravity g='9.81'/><solver stepper='direct' cfm='1e-9'/>"),
      Prototype("movable='false'", "0,0,2", kBase + kRod + tip,
                Joint("id='a' type='spherical'", "link='base'",
                      "link='rod' position='0,0,0.5' orientation='0,-60,0'") +
                    Joint("id='b' type='spherical'", "link='rod'",
                          "link='tip' position='0,0,0.3' orientation='0,40,20'")));
  const auto potential = [&world] {
    return kGravity * (0.4 * world.Locate("rod", CVector3(0, 0, 0.25)).GetZ() +
                       0.2 * world.Locate("tip", CVector3(0, 0, 0.05)).GetZ());
  };
  const Real start = potential();
  Real lowest = start;
  for (int tick = 0; tick < 50; ++tick) {
    world.Step();
    const CVector3 pivot(0, 0, 2);
    // drift that the error reduction leaves: 1e-4 m was measured
    CHECK_THAT((world.Locate("rod", CVector3(0, 0, 0.5)) - pivot).Length(), WithinAbs(0.0, 2e-4));
    CHECK_THAT(
        (world.Locate("tip", CVector3(0, 0, 0.3)) - world.Locate("rod", CVector3())).Length(),
        WithinAbs(0.0, 2e-4));
    lowest = std::min(lowest, potential());
    // it never rises above the start by more than 1 % of the energy of the swing
    CHECK(potential() < start + 0.01 * (start - lowest) + 1e-9);
  }
  CHECK(start - lowest > 0.5);
}

TEST_CASE("joints: a link of a thousand times the mass does not open them",
          "[contract][engine][rigid][joints]") {
  const std::string stepper = GENERATE("mixed", "direct");
  const std::string mass = GENERATE("0.4", "400", "4000");
  CAPTURE(stepper, mass);
  const std::string tip = "<link id='tip' geometry='sphere' radius='0.05' mass='" + mass + "'/>";
  CJointWorld world(RigidEngine("", "<gravity g='9.81'/><solver stepper='" + stepper + "'/>"),
                    Prototype("movable='false'", "0,0,2", kBase + kRod + tip,
                              Joint("id='a' type='spherical'", "link='base'",
                                    "link='rod' position='0,0,0.5' orientation='0,-60,0'") +
                                  Joint("id='b' type='spherical'", "link='rod'",
                                        "link='tip' position='0,0,0.3' orientation='0,40,20'")));
  Real open = 0.0;
  for (int tick = 0; tick < 50; ++tick) {
    world.Step();
    const CVector3 pivot(0, 0, 2);
    open = std::max(
        {open, Distance(world.Locate("rod", CVector3(0, 0, 0.5)), pivot),
         Distance(world.Locate("tip", CVector3(0, 0, 0.3)), world.Locate("rod", CVector3()))});
  }
  // as far as the light ones: what ten substeps in 0.1 s leave of a swing of 2 m/s
  CHECK(open < 0.02);
}

TEST_CASE("joints: a prototype of fixed joints is one rigid body in any engine",
          "[contract][engine][rigid][joints]") {
  const std::string halves =
      "<link id='base' geometry='box' size='0.2,0.3,0.1' mass='0.5' position='-0.1,0,0'/>"
      "<link id='other' geometry='box' size='0.2,0.3,0.1' mass='0.5'/>";
  const std::string fixed = Joint("type='fixed'", "link='base' position='0.2,0,0'", "link='other'");
  const std::string engine = RigidEngine("", KickXml("p", CVector3(0.5, 0.2, 1.5)) + "<floor/>");
  CRigidScene two(engine + "", Prototype("", "0,0,1", halves, fixed));
  CRigidScene one(engine, SBoxXml{"p", CVector3(0.4, 0.3, 0.1), CVector3(0, 0, 1)}.ToXml());
  CHECK(two.Body("p").GetBodyDescription()->Articulation == nullptr);
  CHECK_THAT(two.Body("p").GetBodyDescription()->ComputePlanarInertia(),
             WithinRel(one.Body("p").GetBodyDescription()->ComputePlanarInertia(), 1e-12));
  for (int tick = 0; tick < 20; ++tick) {
    two.Step();
    one.Step();
    // roundings
    CHECK_THAT((two.Position("p") - one.Position("p")).Length(), WithinAbs(0.0, 1e-9));
  }
  for (const std::string tag : {"dynamics2d", "kinematics2d"}) {
    CRigidScene flat("<" + tag + " id='e'/>", Prototype("", "0,0,0", halves, fixed));
    flat.Step();
    CHECK(flat.Position("p") == CVector3());
  }
}

TEST_CASE("joints: connected links are solved directly up to max_direct_rows, six for each",
          "[contract][engine][rigid][joints]") {
  const int numRods = GENERATE(1, 2, 4);
  CAPTURE(numRods);
  std::string links = kBase;
  std::string joints;
  for (int i = 0; i < numRods; ++i) {
    const std::string rod = "rod" + std::to_string(i);
    links += "<link id='" + rod + "' geometry='box' size='0.02,0.02,0.2' mass='0.4'/>";
    joints += Joint("type='revolute' axis='0,1,0'",
                    i == 0 ? "link='base'" : "link='rod" + std::to_string(i - 1) + "'",
                    "link='" + rod + "' position='0,0,0.2' orientation='0,10,0'");
  }
  const auto run = [&](int mostRows) {
    CRigidScene world(
        RigidEngine("", "<solver max_direct_rows='" + std::to_string(mostRows) + "'/>"),
        Prototype("movable='false'", "0,0,2", links, joints));
    world.Step(5);
    return world.ComputeDigest();
  };
  const int rows = 6 * numRods;
  CHECK(run(rows) == run(1000));
  CHECK(run(rows - 1) == run(1));
  CHECK(run(rows) != run(rows - 1));
}

TEST_CASE("joints: a motor accelerates with its greatest torque up to its speed",
          "[contract][engine][rigid][joints]") {
  const std::string arm = "<link id='arm' geometry='box' size='0.4,0.02,0.02' mass='0.3'/>";
  CJointWorld world(RigidEngine("", "<gravity g='0'/>"),
                    Prototype("movable='false'", "0,0,1", kBase + arm,
                              Joint("id='j' type='revolute' axis='0,0,1'",
                                    "link='base' position='0,0,0.2'", "link='arm'")));
  const Real maxImpulse = 2e-5;  // N m s
  const Real inertia = 0.3 * (0.16 + 0.0004) / 12.0;
  world.Joints().SetCommand(0, {EMode::Velocity, 1.5, maxImpulse});
  world.Step();
  CHECK_THAT(world.Speed(), WithinRel(maxImpulse / kSubstep * 0.1 / inertia, 1e-3));
  world.Step(200);
  CHECK_THAT(world.Speed(), WithinAbs(1.5, 1e-4));
  const Real before = world.Coordinate();
  world.Step(50);
  // more than a turn, which the coordinate does not wrap
  CHECK_THAT(world.Coordinate() - before, WithinAbs(7.5, 1e-3));
  world.Joints().SetCommand(0, {EMode::Disabled, 0.0, 0.0});
  world.Step(5);
  CHECK_THAT(world.Speed(), WithinAbs(1.5, 1e-4));
}

TEST_CASE("joints: a motor in position mode arrives and holds against gravity",
          "[contract][engine][rigid][joints]") {
  CJointWorld world(RigidEngine("", "<gravity g='9.81'/>"), Pendulum("revolute", 0.0));
  world.Joints().SetCommand(0, {EMode::Position, -1.0, 0.1});
  world.Step(30);
  CHECK_THAT(world.Coordinate(), WithinAbs(-1.0, 0.01));
  // 0.4 kg at 0.25 m need 0.83 N m to be held at 1 rad
  world.Joints().SetCommand(0, {EMode::Position, -1.0, 0.004});
  world.Step(1);
  CHECK(world.Coordinate() > -0.999);
}

TEST_CASE("joints: forces between links leave the momentum of a free body alone",
          "[contract][engine][rigid][joints]") {
  CJointWorld world(
      RigidEngine("", KickXml("p", CVector3(0.7, 0.14, 0.0)) + "<gravity g='0'/>"),
      Prototype("", "0,0,1", kBase + kRod,
                Joint("id='j' type='revolute' axis='0,1,0'", "link='base' position='0.05,0,0.05'",
                      "link='rod' position='0,0,0.5'")));
  const auto centre = [&world] {
    return (world.Locate("base", CVector3(0, 0, 0.05)) +
            world.Locate("rod", CVector3(0, 0, 0.25)) * 0.4) /
           1.4;
  };
  const CVector3 start = centre();
  world.Joints().SetCommand(0, {EMode::Velocity, 3.0, 0.01});
  for (int tick = 1; tick <= 20; ++tick) {
    world.Step();
    // the compliance of the constraints acts on both links alike; roundings remain
    const CVector3 path = CVector3(0.7, 0.14, 0.0) / 1.4 * (0.1 * tick);
    CHECK_THAT((centre() - start - path).Length(), WithinAbs(0.0, 1e-9));
  }
}

TEST_CASE("joints: rays, overlaps and bounds see links where they are now",
          "[contract][engine][rigid][joints]") {
  CJointWorld world(
      RigidEngine("", "<gravity g='0'/>"),
      FixedArm("0,0,1", "id='j' type='revolute' axis='0,1,0'", "position='0,0,0.2'", ""));
  const auto hit = [&world](const CVector3& from, const CVector3& to) {
    SEmbodiedEntityIntersectionItem item;
    return world.GetSpace().GetBodyIndex().FindClosestHit(item, CRay3(from, to)) ? item.TOnRay
                                                                                 : 2.0;
  };
  const CVector3 left(-1, 0, 1.6);
  const CVector3 right(1, 0, 1.6);
  CHECK_THAT(hit(left, right), WithinAbs(0.495, 1e-12));
  world.Joints().SetCommand(0, {EMode::Position, ARGOS_PI / 2.0, 0.1});
  world.Step(40);
  REQUIRE_THAT(world.Coordinate(), WithinAbs(ARGOS_PI / 2.0, 1e-3));
  CHECK(hit(left, right) == 2.0);
  // it now points along x at the height of the hinge
  CHECK_THAT(hit(CVector3(0.45, 0, 2), CVector3(0.45, 0, 0)), WithinAbs(0.395, 1e-3));
  CHECK_THAT(world.Body("p").GetBoundingBox().MaxCorner.GetX(), WithinAbs(0.5, 1e-3));
  // a move takes all links along
  world.Body("p").MoveTo(CVector3(0, 1, 1), CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z));
  CHECK(hit(CVector3(0.45, 0, 2), CVector3(0.45, 0, 0)) == 2.0);
  CHECK_THAT(hit(CVector3(0, 1.45, 2), CVector3(0, 1.45, 0)), WithinAbs(0.395, 1e-3));
  world.Step();
  CHECK_THAT(hit(CVector3(0, 1.45, 2), CVector3(0, 1.45, 0)), WithinAbs(0.395, 1e-3));
  CHECK_THAT(world.Coordinate(), WithinAbs(ARGOS_PI / 2.0, 1e-3));
}

TEST_CASE("joints: links collide with objects, and with each other if they may",
          "[contract][engine][rigid][joints]") {
  // the rod turns down into a box, or into the base
  const bool hasBox = GENERATE(true, false);
  const std::string box =
      SBoxXml{"b", CVector3(0.4, 0.4, 0.4), CVector3(0.5, 0, 1), CVector3(), 0.0}.ToXml();
  CJointWorld world(RigidEngine("", "<gravity g='9.81'/>"),
                    Prototype("movable='false'", "0,0,1",
                              "<link id='base' geometry='box' size='1,0.1,0.1' mass='1'/>" + kRod,
                              Joint("id='j' type='revolute' axis='0,1,0' disable_collision='false'",
                                    "link='base' position='0,0,0.2'", "link='rod'")) +
                        (hasBox ? box : ""));
  world.Joints().SetCommand(0, {EMode::Velocity, 0.5, 0.001});
  world.Step(100);
  const CVector3 end = world.Locate("rod", CVector3(0, 0, 0.5));
  // the tip of the rod, 1 cm above its lower side, lies on the top of what it has met
  CHECK_THAT(end.GetZ(), WithinAbs(hasBox ? 1.45 : 1.11, hasBox ? 0.08 : 0.01));
  CHECK_THAT(world.Speed(), WithinAbs(0.0, 0.01));
}

TEST_CASE("convex hulls: a hull of the corners of a box rests and slides as that box",
          "[contract][engine][rigid][joints]") {
  const std::string corners =
      "(-0.1,-0.1,0)(0.1,-0.1,0)(-0.1,0.1,0)(0.1,0.1,0)"
      "(-0.1,-0.1,0.2)(0.1,-0.1,0.2)(-0.1,0.1,0.2)(0.1,0.1,0.2)(0,0,0.1)";
  const std::string hull = "<link id='base' geometry='convex_hull' mass='1'>" + corners + "</link>";
  const std::string links =
      "<prototype id='p'><body position='0,0,0.3' orientation='20,0,0'/>"
      "<links ref='base'>" +
      hull + "</links></prototype>";
  CRigidScene world(GroundedEngine(), links);
  CRigidScene box(
      GroundedEngine(),
      SBoxXml{"p", CVector3(0.2, 0.2, 0.2), CVector3(0, 0, 0.3), CVector3(20, 0, 0)}.ToXml());
  const SBodyDescription& description = *world.Body("p").GetBodyDescription();
  CHECK_THAT(description.ComputePlanarInertia(), WithinRel(0.02 / 3.0, 1e-12));
  CHECK_THAT(description.Shapes.front().ComputeVolume(), WithinRel(0.008, 1e-12));
  world.Step(20);
  box.Step(20);
  CHECK_THAT(world.Position("p").GetZ(), WithinAbs(0.0, 1e-3));
  CHECK_THAT((world.Position("p") - box.Position("p")).Length(), WithinAbs(0.0, 2e-3));
  CHECK(world.Tilt("p") < 0.01);
  // a ray from the side and one across a corner
  SEmbodiedEntityIntersectionItem item;
  const CBodyIndex& index = world.GetSpace().GetBodyIndex();
  REQUIRE(index.FindClosestHit(item, CRay3(CVector3(0, 0, 1), CVector3(0, 0, 0))));
  CHECK_THAT(item.TOnRay, WithinAbs(0.8, 1e-3));
  CHECK(!index.FindClosestHit(item, CRay3(CVector3(0.14, -1, 0.1), CVector3(0.14, 1, 0.1))));
}

TEST_CASE("joints: a run repeats after a reset, and with any number of threads",
          "[contract][engine][rigid][joints]") {
  const std::string arena =
      Prototype("", "0,0,0.5", kBase + kRod,
                Joint("id='j' type='revolute' axis='0,1,0'", "link='base' position='0.05,0,0.05'",
                      "link='rod' position='0,0,0.5' orientation='0,20,0'")) +
      SBoxXml{"b", CVector3(0.2, 0.2, 0.2), CVector3(0.2, 0.05, 0)}.ToXml();
  std::vector<UInt64> digests;
  for (const UInt32 threads : {0U, 1U, 4U}) {
    CJointWorld world(GroundedEngine(), arena, threads);
    world.Step(30);
    const UInt64 first = world.ComputeDigest();
    world.GetSimulator().Reset();
    CHECK(world.Coordinate() == 0.0);
    world.Step(30);
    CHECK(world.ComputeDigest() == first);
    digests.push_back(first);
  }
  CHECK(digests[0] == digests[1]);
  CHECK(digests[0] == digests[2]);
}

TEST_CASE("joints: engines that cannot move joints refuse with a message",
          "[contract][engine][rigid][joints]") {
  const std::string tag = GENERATE("dynamics2d", "kinematics2d", "pointmass3d");
  SExperiment experiment;
  experiment.Engines = "<" + tag + " id='e'/>";
  experiment.Arena = Prototype("", "0,0,0", kBase + kRod,
                               Joint("id='j' type='spherical'", "link='base'", "link='rod'"));
  CHECK_THAT(LoadError(experiment),
             Contains("add an engine for jointed bodies") && Contains("<dynamics3d>"));
}

TEST_CASE("joints: what a motor cannot do is an error, and changes nothing",
          "[contract][engine][joints]") {
  CJointWorld world(
      RigidEngine("", "<gravity g='0'/>"),
      FixedArm("0,0,0", "id='j' type='revolute' axis='0,1,0'", "", "position='0,0,0.3'"));
  CJointEquippedEntity& joints = world.Joints();
  const CJointEquippedEntity::SCommand turn{EMode::Velocity, 1.0, 2.0};
  joints.SetCommand(0, turn);
  for (const auto& [target, impulse] : {std::pair<Real, Real>{std::nan(""), 1.0},
                                        {HUGE_VAL, 1.0},
                                        {1.0, -1e-9},
                                        {1.0, std::nan("")}}) {
    CHECK_THROWS_WITH(joints.SetCommand(0, {EMode::Velocity, target, impulse}),
                      Contains("joint \"j\" of \"p\"") && Contains("must be finite"));
  }
  CHECK(joints.GetJoint(0).Command == turn);
  for (const auto& use : std::vector<std::function<void()>>{
           [&] { joints.SetCommand(1, turn); }, [&] { joints.SetState(1, 0.0, 0.0); },
           [&] { static_cast<void>(joints.GetJoint(1)); },
           [&] { static_cast<void>(joints.GetDescription(1)); }}) {
    CHECK_THROWS_WITH(use(), Contains("no joint 1; there are 1, numbered from 0"));
  }
  CHECK_THROWS_WITH(joints.FindJoint("i"), Contains("joint \"i\"; known: j"));
}

TEST_CASE("joints: a ball joint has neither a motor nor an encoder", "[contract][engine][joints]") {
  CJointWorld world(RigidEngine("", "<gravity g='0'/>"),
                    FixedArm("0,0,0", "id='ball' type='spherical'", "", "position='0,0,0.3'"));
  CHECK_THROWS_WITH(world.Joints().FindJoint("ball"),
                    Contains("joint \"ball\" of \"p\" is spherical"));
  // it is not proposed, either
  CHECK_THROWS_WITH(world.Joints().FindJoint("bal"), !Contains("did you mean"));
}

TEST_CASE("prototype: mistakes are reported with their line", "[contract][engine][joints]") {
  struct SMistake {
    std::string Links, Joints, Message;
  };
  const std::string ball = Joint("id='j' type='spherical'", "link='base'", "link='rod'");
  const auto mistake = GENERATE_COPY(
      SMistake{"<link id='base' geometry='cube' size='1,1,1' mass='1'/>", "",
               "unknown geometry \"cube\""},
      SMistake{"<link id='base' geometry='box' size='1,1,1' mass='0'/>", "",
               "\"mass\" must be a number from"},
      SMistake{"<link id='base' geometry='convex_hull' mass='1'>(0,0,0)(1,0,0)(0,1,0)</link>", "",
               "needs at least 4 points"},
      SMistake{kBase + kBase, "", "there is already a link \"base\""},
      SMistake{kRod, "", "there is no link \"base\""},
      SMistake{kBase + kRod, "", "no joint connects link \"rod\""},
      SMistake{kBase + kRod, ball + Joint("id='k' type='fixed'", "link='base'", "link='rod'"),
               "closes a loop"},
      SMistake{kBase + kRod, ball + ball, "there is already a joint \"j\""},
      SMistake{kBase + kRod, Joint("type='screw'", "link='base'", "link='rod'"),
               "unknown type \"screw\""},
      SMistake{kBase + kRod, Joint("type='revolute'", "link='base'", "link='rod'"), "axis"},
      SMistake{kBase + kRod, Joint("type='revolute' axis='0,0,0'", "link='base'", "link='rod'"),
               "must not be zero"},
      SMistake{kBase + kRod, Joint("type='revolute' axis='0,1e300,0'", "link='base'", "link='rod'"),
               "axis"},
      SMistake{"", "", "needs at least one child <link>"},
      SMistake{kBase + kRod,
               Joint("type='revolute' axis='0,0,1' limit='-200:0'", "link='base'", "link='rod'"),
               "within -180:180"},
      SMistake{kBase + kRod, Joint("type='fixed'", "link='base'", "link='rot'"),
               "there is no link \"rot\""});
  SExperiment experiment;
  experiment.Engines = "<dynamics3d id='e'/>";
  experiment.Arena = Prototype("", "0,0,0", mistake.Links, mistake.Joints);
  CHECK_THAT(LoadError(experiment), Contains(mistake.Message));
}

TEST_CASE("prototype: a link that its joint puts elsewhere is warned of",
          "[contract][engine][joints]") {
  CRigidScene world(
      RigidEngine("", ""),
      Prototype("", "0,0,0",
                kBase + "<link id='rod' geometry='sphere' radius='0.1' mass='1' position='1,0,0'/>",
                Joint("type='spherical'", "link='base' position='0.5,0,0'", "link='rod'")));
  CHECK_THAT(TakeLogErr(), Contains("the joints put link \"rod\" at \"0.5,0,0\""));
  // at its place, but turned
  const std::string turn = GENERATE("0,0,0", "0.05,0,0", "30,0,0");
  CRigidScene turned(
      RigidEngine("", ""),
      Prototype("", "0,0,0",
                kBase +
                    "<link id='rod' geometry='sphere' radius='0.1' mass='1' "
                    "position='0.5,0,0' orientation='" +
                    turn + "'/>",
                Joint("type='spherical'", "link='base' position='0.5,0,0'", "link='rod'")));
  const std::string warnings = TakeLogErr();
  CAPTURE(turn, warnings);
  CHECK((warnings.find("the joints put link") != std::string::npos) == (turn == "30,0,0"));
}

}  // namespace argos::articulated_test
