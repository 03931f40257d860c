// Compares rigid bodies with mechanics: free fall, friction, impact.

#include <argos3/testing/contract/physics_engines/rigid_scene.h>

#include <argos3/core/utility/math/angles.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace argos::rigid_motion_test {

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr Real kSubstep = 0.01;  // s, of the default

std::string Stepper(const std::string& name) {
  return "<solver stepper='" + name + "'/>";
}

// a slope about the y axis, falling towards x, with a box on it
struct SSlope {
  Real Angle;  // rad

  CVector3 OnTop(Real along) const {
    return CVector3(along * std::cos(Angle) + 0.2 * std::sin(Angle), 0.0,
                    -along * std::sin(Angle) + 0.2 * std::cos(Angle));
  }
  std::string ToXml() const {
    const CVector3 degrees(0.0, Angle * 180.0 / ARGOS_PI, 0.0);
    return SBoxXml{"slope", CVector3(8, 2, 0.2), CVector3(), degrees, 0.0}.ToXml() +
           SBoxXml{"box", CVector3(0.3, 0.2, 0.1), OnTop(0.0), degrees}.ToXml();
  }
};

}  // namespace

TEST_CASE(
    "rigid motion: a falling body follows the integrator, and the exact parabola to first order",
    "[contract][engine][rigid]") {
  const std::string stepper = GENERATE("mixed", "direct", "iterative");
  CRigidScene world(RigidEngine("", "<gravity g='9.81'/>" + Stepper(stepper)),
                    SBoxXml{"b", CVector3(1, 1, 1), CVector3(0, 0, 1)}.ToXml());
  for (int tick = 1; tick <= 20; ++tick) {
    world.Step();
    // v += g h, then x += v h: after n substeps g h^2 n (n + 1) / 2
    const Real n = 10.0 * tick;
    const Real fallen = 9.81 * kSubstep * kSubstep * n * (n + 1.0) / 2.0;
    CHECK_THAT(world.Position("b").GetZ(), WithinAbs(1.0 - fallen, 1e-10));
    // the integrator differs from g t^2 / 2 by g h t / 2
    const Real time = 0.1 * tick;
    CHECK_THAT(fallen, WithinAbs(0.5 * 9.81 * time * time, 0.5 * 9.81 * kSubstep * time + 1e-9));
  }
  CHECK(world.Position("b").GetX() == 0.0);
  CHECK(world.Tilt("b") == 0.0);
}

TEST_CASE("rigid motion: gravity is a vector, and without gravity a body keeps its velocity",
          "[contract][engine][rigid]") {
  CRigidScene world(RigidEngine("", "<gravity vector='0.1,-0.2,0.3'/>"),
                    SBoxXml{"b", CVector3(1, 1, 1), CVector3(0, 0, 1)}.ToXml());
  world.Step(10);
  const Real path = kSubstep * kSubstep * 100.0 * 101.0 / 2.0;
  CHECK_THAT(world.Position("b").GetX(), WithinAbs(0.1 * path, 1e-12));
  CHECK_THAT(world.Position("b").GetY(), WithinAbs(-0.2 * path, 1e-12));
  CHECK_THAT(world.Position("b").GetZ(), WithinAbs(1.0 + 0.3 * path, 1e-12));

  CRigidScene weightless(RigidEngine("", KickXml("b", CVector3(0.3, 0.0, 0.0005))),
                         SBoxXml{"b", CVector3(1, 1, 1), CVector3(0, 0, 1)}.ToXml());
  weightless.Step(100);
  // slow motion goes on too: bodies without contact to fixed bodies do not fall asleep
  CHECK_THAT(weightless.Position("b").GetX(), WithinAbs(3.0, 1e-9));
  CHECK_THAT(weightless.Position("b").GetZ(), WithinAbs(1.005, 1e-9));
}

TEST_CASE("rigid motion: a body on a floor of any height stays on the floor",
          "[contract][engine][rigid]") {
  const Real height = GENERATE(0.0, 0.5, -0.25);
  const std::string stepper = GENERATE("mixed", "direct", "iterative");
  CAPTURE(height, stepper);
  std::ostringstream floor;
  floor << "<floor height='" << height << "'/><gravity g='9.81'/>" << Stepper(stepper);
  CRigidScene world(
      RigidEngine("sleep='false'", floor.str()),
      SBoxXml{"b", CVector3(0.2, 0.3, 0.1), CVector3(1, 2, height), CVector3(30, 0, 0)}.ToXml());
  world.Step(100);
  CHECK_THAT(world.Position("b").GetX(), WithinAbs(1.0, 1e-5));
  CHECK_THAT(world.Position("b").GetY(), WithinAbs(2.0, 1e-5));
  // the surface layer, and the compliance of 4 contacts under 10 N
  CHECK_THAT(world.Position("b").GetZ(), WithinAbs(height, 2e-5));
  CHECK(world.Tilt("b") < 1e-4);
}

TEST_CASE("rigid friction: on a slope a box slides beyond the angle of friction and rests below it",
          "[contract][engine][rigid]") {
  const std::string stepper = GENERATE("mixed", "direct", "iterative");
  const Real mu = GENERATE(0.25, 0.5);
  CAPTURE(stepper, mu);
  // both bodies have this friction, and the contact has the product
  std::ostringstream attributes;
  attributes << "sleep='false' default_friction='" << std::sqrt(mu) << "'";
  const std::string engine =
      RigidEngine(attributes.str(), "<gravity g='9.81'/>" + Stepper(stepper));

  const SSlope gentle{std::atan(mu) - 0.03};
  CRigidScene resting(engine, gentle.ToXml());
  resting.Step(50);
  CHECK(Distance(resting.Position("box"), gentle.OnTop(0.0)) < 1e-3);

  const SSlope steep{std::atan(mu) + 0.1};
  CRigidScene sliding(engine, steep.ToXml());
  const Real acceleration = 9.81 * (std::sin(steep.Angle) - mu * std::cos(steep.Angle));
  sliding.Step(10);
  const Real n = 100.0;
  const Real path = acceleration * kSubstep * kSubstep * n * (n + 1.0) / 2.0;
  const CVector3 slid = sliding.Position("box") - steep.OnTop(0.0);
  CHECK_THAT(slid.Length(), WithinRel(path, 0.02));
  // the motion is along the slope
  CHECK_THAT(slid.GetZ() / slid.GetX(), WithinAbs(-std::tan(steep.Angle), 1e-3));
}

TEST_CASE("rigid impact: momentum is conserved, and restitution is as specified",
          "[contract][engine][rigid]") {
  const std::string stepper = GENERATE("mixed", "direct", "iterative");
  const Real restitution = GENERATE(0.0, 0.5, 1.0);
  const Real mass = GENERATE(1.0, 3.0);
  CAPTURE(stepper, restitution, mass);
  std::ostringstream contacts;
  contacts << "<contacts restitution='" << restitution << "'/>" << Stepper(stepper)
           << KickXml("a", CVector3(1, 0, 0));
  CRigidScene world(
      RigidEngine("", contacts.str()),
      SBoxXml{"a", CVector3(0.2, 0.2, 0.2), CVector3(0, 0, 0)}.ToXml() +
          SBoxXml{"b", CVector3(0.2, 0.2, 0.2), CVector3(0.5, 0, 0), {}, mass}.ToXml());
  world.Step(10);
  const CVector3 a = world.Position("a");
  const CVector3 b = world.Position("b");
  world.Step(10);
  const Real speedA = (world.Position("a") - a).GetX();
  const Real speedB = (world.Position("b") - b).GetX();
  // iterations leave a residual
  const Real tolerance = stepper == "iterative" ? 1e-4 : 1e-6;
  CHECK_THAT(speedA + mass * speedB, WithinAbs(1.0, tolerance));
  // Newton's law of impact; the penetration is corrected over some time
  CHECK_THAT(speedB - speedA, WithinAbs(restitution, 0.01));
  CHECK_THAT(world.Position("a").GetY(), WithinAbs(0.0, tolerance));
}

TEST_CASE("rigid impact: a crowd of colliding boxes conserves its momentum",
          "[contract][engine][rigid]") {
  const std::string stepper = GENERATE("mixed", "iterative");
  CAPTURE(stepper);
  std::string boxes;
  std::string kicks = Stepper(stepper);
  CVector3 momentum;
  for (int i = 0; i < 27; ++i) {
    const CVector3 place(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    const std::string id = "b" + std::to_string(i);
    const Real mass = 0.5 + 0.1 * (i % 7);
    boxes +=
        SBoxXml{id, CVector3(0.2, 0.3, 0.25), place * 0.5, CVector3(20.0 * i, 10.0 * i, 0.0), mass}
            .ToXml();
    // all towards a point off the middle
    const CVector3 impulse = (CVector3(0.1, 0.2, -0.1) - place) * 0.4;
    kicks += KickXml(id, impulse);
    momentum += impulse;
  }
  CRigidScene world(RigidEngine("", kicks), boxes);
  world.Step(30);
  // the centre of mass of rotating bodies, from the centre of each box
  const auto middle = [&world] {
    CVector3 sum;
    for (int i = 0; i < 27; ++i) {
      const std::string id = "b" + std::to_string(i);
      CVector3 half(0.0, 0.0, 0.125);
      sum += (world.Position(id) + half.Rotate(world.Orientation(id))) * (0.5 + 0.1 * (i % 7));
    }
    return sum;
  };
  const CVector3 before = middle();
  world.Step(10);
  const CVector3 change = middle() - before;
  for (UInt32 axis = 0; axis < 3; ++axis) {
    CHECK_THAT(change[axis], WithinAbs(momentum[axis], 1e-9));
  }
}

}  // namespace argos::rigid_motion_test
