#ifndef ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_ARC_AND_PUSH_H
#define ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_ARC_AND_PUSH_H

#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/support/closed_form/differential_drive.h>

#include <catch2/catch.hpp>

namespace argos {

/**
 * Checks the motion of two foot-bots of another shape: "free", which starts at (3,3) m and 30
 * degrees with 9 and 10 cm/s, and "pusher", which pushes the cylinder "c" of a radius of 5 cm.
 * @param front  of the shape, m from the centre.
 * @param late   by which the first command takes effect, s.
 */
inline void CheckArcAndPush(CDriveWorld& world, const SEngineType& engine,
                            const SShapeDescription& shape, Real front, Real late) {
  using Catch::Matchers::WithinAbs;
  world.Reshape("free", shape);
  world.Reshape("pusher", shape);
  world.Step();
  const testing::SPose start{3, 3, 30.0 / 180.0 * ARGOS_PI};
  for (int tick = 1; tick <= 100; ++tick) {
    world.Step();
    const testing::SPose exact =
        testing::IntegrateDifferentialDrive(start, 0.09, 0.10, 0.14, 0.1 * tick - late);
    // it is always in the crowd, and keeps the exact pose while nothing pushes it
    const Real tolerance = 1e-9 + engine.Slip * 0.0095 * tick + engine.Slack;
    REQUIRE_THAT(world.Position("free").GetX(), WithinAbs(exact.X, tolerance));
    REQUIRE_THAT(world.Position("free").GetY(), WithinAbs(exact.Y, tolerance));
  }
  CHECK_THAT(world.Position("c").GetX() - world.Position("pusher").GetX(),
             WithinAbs(front + 0.05, 1e-3 + engine.Slack));
  CHECK(world.Position("c").GetX() > 0.9);
}

}  // namespace argos

#endif
