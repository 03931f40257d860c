#include <argos3/testing/support/crowd.h>

#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_measures.h>
#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/support/arena_text.h>

#include <numbers>

namespace argos::testing {

namespace {

constexpr UInt32 kDepth = 20;  // rows
constexpr Real kPitch = 2.0 * epuck::kBodyRadius + 0.003;  // m, between neighbours

UInt32 ComputeRobotsPerRow(UInt32 robots) {
  return (robots + kDepth - 1) / kDepth;
}

}  // namespace

Real ComputeCrowdWidth(UInt32 robots) {
  return kPitch * (ComputeRobotsPerRow(robots) + 0.5);
}

std::string PressingCrowdText(UInt32 robots) {
  constexpr Real kSpeed = 10.0;  // cm/s
  constexpr Real kRowPitch = 0.5 * std::numbers::sqrt3 * kPitch;
  constexpr Real kJitter = 0.0005;  // m
  constexpr Real kWall = 0.1;  // m
  const UInt32 width = ComputeRobotsPerRow(robots);
  const Real halfWidth = 0.5 * ComputeCrowdWidth(robots);
  const Real length = kDepth * kRowPitch + 0.5;
  const CVector3 side(length, kWall, 0.5);
  const Real sideY = halfWidth + 0.5 * kWall;
  std::string arena = BoxText("front", CVector3(kWall, 2.0 * halfWidth + 1.0, 0.5),
                              CVector3(0.5 * kWall, 0.0, 0.0)) +
                      BoxText("left", side, CVector3(-0.5 * length, sideY, 0.0)) +
                      BoxText("right", side, CVector3(-0.5 * length, -sideY, 0.0));
  CRandomStream random(1, "test", "crowd", "places");
  for (UInt32 i = 0; i < robots; ++i) {
    const UInt32 row = i / width;
    const Real shift = row % 2 == 0 ? 0.25 : -0.25;
    const Real x = -0.5 * kPitch - row * kRowPitch + random.Uniform(-kJitter, kJitter);
    const Real y = kPitch * (i % width - 0.5 * (width - 1.0) + shift);
    arena += DriverXml("e-puck", "r" + std::to_string(i), x, y + random.Uniform(-kJitter, kJitter),
                       0.0, kSpeed, kSpeed);
  }
  return arena;
}

}  // namespace argos::testing
