// <pointmass3d motion="argos3">: flight as in ARGoS 3, against a second implementation of its law.

#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/contract/physics_engines/flight_world.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

namespace argos::flight_of_argos3_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kGravity = -9.81;  // m/s^2
constexpr Real kMax = 1000.0;  // N and N m

/** One axis of an eye-bot under the law of ARGoS 3. */
struct SOldAxis {
  Real Inertia, PlaceGain, PlaceDerivative, SpeedGain, SpeedDerivative;
  Real Lowest, Highest;  // m
  Real Weight = 0.0;  // N
  bool IsAngle = false;
  Real Place = 0.0, Speed = 0.0, Force = 0.0, LastError = 0.0;

  void Step(Real target, bool onPlace, Real dt) {
    Place += Speed * dt;
    if (IsAngle) {
      Place = std::fmod(std::fmod(Place, 2.0 * std::numbers::pi) + 2.0 * std::numbers::pi,
                        2.0 * std::numbers::pi);
    } else {
      Place = std::clamp(Place, Lowest, Highest);
    }
    Speed += Force * dt / Inertia;
    Real error = target - (onPlace ? Place : Speed);
    if (IsAngle && onPlace) {
      error = std::remainder(error, 2.0 * std::numbers::pi);
    }
    const Real proportional = onPlace ? PlaceGain : SpeedGain;
    const Real derivative = onPlace ? PlaceDerivative : SpeedDerivative;
    const Real wanted = proportional * error + derivative * (error - LastError) / dt - Weight;
    Force = std::clamp(wanted, -kMax, kMax) + Weight;
    LastError = error;
  }
};

/** x, y, z and yaw of an eye-bot in an arena of 40 m around (0, 0, 20). */
std::array<SOldAxis, 4> OldEyeBot() {
  const SOldAxis linear{1.0, 20.0, 10.0, 20.0, 0.0, -19.75, 19.75};
  SOldAxis z = linear;
  z.Weight = kGravity;
  SOldAxis yaw{0.01, 0.5, 0.1, 0.5, 0.1, 0.0, 0.0};
  yaw.IsAngle = true;
  return {linear, linear, z, yaw};
}

CFlightWorld MakeWorld(const std::string& actuator, const std::string& attributes) {
  SFlightExperiment experiment;
  experiment.Actuator = actuator;
  experiment.Engines = "<pointmass3d id='e' " + attributes + "/>";
  experiment.Arena = EyeBotXml("r", CVector3(1.0, -2.0, 3.0));
  return CFlightWorld(experiment);
}

}  // namespace

TEST_CASE("flight of ARGoS 3: positions and yaw follow its law", "[contract][flight]") {
  const UInt32 iterations = GENERATE(10U, 3U);
  CAPTURE(iterations);
  CFlightWorld world = MakeWorld("quadrotor_position",
                                 "motion='argos3' iterations='" + std::to_string(iterations) + "'");
  std::array<SOldAxis, 4> axes = OldEyeBot();
  const std::array<Real, 4> start{1.0, -2.0, 3.0, 0.0};
  const std::array<Real, 4> target{1.4, -2.3, 3.2, 1.0};
  for (size_t i = 0; i < 4; ++i) {
    axes[i].Place = start[i];
  }
  world.Places().SetAbsolutePosition(CVector3(target[0], target[1], target[2]));
  world.Places().SetAbsoluteYaw(CRadians(target[3]));
  for (int tick = 0; tick < 400; ++tick) {
    world.Step();
    for (size_t i = 0; i < 4; ++i) {
      axes[i].Step(target[i], true, 0.1 / iterations);
    }
    const CVector3 expected(axes[0].Place, axes[1].Place, axes[2].Place);
    REQUIRE_THAT(Distance(world.Position(), expected), WithinAbs(0.0, 1e-11));
    REQUIRE_THAT(std::remainder(world.Yaw() - axes[3].Place, 2.0 * std::numbers::pi),
                 WithinAbs(0.0, 1e-11));
  }
}

TEST_CASE("flight of ARGoS 3: velocities follow its law, beyond the arena's border, too",
          "[contract][flight]") {
  CFlightWorld world = MakeWorld("quadrotor_speed", "motion='argos3'");
  std::array<SOldAxis, 4> axes = OldEyeBot();
  axes[0].Place = 1.0;
  axes[1].Place = -2.0;
  axes[2].Place = 3.0;
  axes[2].Lowest = 0.0;
  axes[2].Highest = 40.0 - 0.566;
  // 5 m/s at a tenth of the speed reach the border after 38 s, and come back from it
  for (int tick = 0; tick < 500; ++tick) {
    const Real speed = tick < 420 ? 5.0 : -5.0;
    world.Speeds().SetLinearVelocity(CVector3(speed, 0.5, 0.2));
    world.Step();
    const std::array<Real, 3> targets{speed, 0.5, 0.2};
    for (size_t i = 0; i < 3; ++i) {
      axes[i].Step(targets[i], false, 0.01);
    }
    const CVector3 expected(axes[0].Place, axes[1].Place, axes[2].Place);
    REQUIRE_THAT(Distance(world.Position(), expected), WithinAbs(0.0, 1e-10));
  }
  CHECK(world.Position().GetX() < 19.0);
}

TEST_CASE("flight of ARGoS 3: a robot on wheels moves at a tenth of its speed",
          "[contract][flight]") {
  CDriveWorld world(kPointMass3D.ToXml("e", "motion='argos3'"),
                    DriverXml("foot-bot", "r", 0, 0, 0, 10, 10));
  world.Step(101);
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(0.1, 1e-12));
}

TEST_CASE("flight of ARGoS 3: an unknown kind of motion is an error", "[contract][flight]") {
  CHECK_THROWS_WITH(
      MakeWorld("quadrotor_position", "motion='fast'"),
      Contains("\"motion\"") && Contains("\"exact\" or \"argos3\"") && Contains("fast"));
}

// prints the table of doc/from_argos3.md
TEST_CASE("flight of ARGoS 3: table", "[.table]") {
  for (const std::string motion : {"exact", "argos3"}) {
    CFlightWorld world = MakeWorld("quadrotor_position", "motion='" + motion + "'");
    const CVector3 target(2.0, -2.0, 3.0);
    world.Places().SetAbsolutePosition(target);
    world.Places().SetAbsoluteYaw(CRadians(1.0));
    Real settled = 0.0;  // s
    Real turned = 0.0;
    Real farthest = 0.0;  // m
    for (int tick = 1; tick <= 2000; ++tick) {
      world.Step();
      farthest = std::max(farthest, world.Position().GetX() - target.GetX());
      if (Distance(world.Position(), target) > 0.02) {
        settled = 0.1 * tick;
      }
      if (std::abs(world.Yaw() - 1.0) > 0.02) {
        turned = 0.1 * tick;
      }
    }
    CFlightWorld cruising = MakeWorld("quadrotor_speed", "motion='" + motion + "'");
    cruising.Speeds().SetLinearVelocity(CVector3(0.5, 0.0, 0.0));
    cruising.Speeds().SetRotationalSpeed(CRadians(0.1));
    cruising.Step(100);
    std::ostringstream row;
    row << "| " << motion << " | " << settled << " s | " << farthest << " m | " << turned << " s | "
        << cruising.Position().GetX() - 1.0 << " m | " << cruising.Yaw() << " rad |";
    WARN(row.str());
  }
}

}  // namespace argos::flight_of_argos3_test
