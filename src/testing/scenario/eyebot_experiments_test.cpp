// The experiments with eye-bots show the behaviour documented in their files.

#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/paths.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/plugins/dynamic_loading.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <regex>
#include <sstream>

namespace argos::eyebot_experiments_test {

namespace {

// an experiment without its visualization; its libraries are loaded first
std::string TextOf(const std::string& experiment) {
  std::ifstream file(InSourceTree("experiments/" + experiment + ".argos"));
  std::stringstream text;
  text << file.rdbuf();
  REQUIRE(text.str().find("<visualization>") != std::string::npos);
  const std::regex extras("(library=\"[^\"]*\")|(<visualization>[^]*</visualization>)");
  return std::regex_replace(text.str(), extras, "");
}

CVector3 PositionOf(CTestWorld& world, const std::string& id) {
  return world.Get<CComposableEntity>(id)
      .GetComponent<CEmbodiedEntity>("body")
      .GetOriginAnchor()
      .Position;
}

Real HorizontalDistance(const CVector3& a, const CVector3& b) {
  return std::hypot(a.GetX() - b.GetX(), a.GetY() - b.GetY());
}

}  // namespace

TEST_CASE("eye-bot experiments: an eye-bot circles above a driving foot-bot", "[scenario]") {
  CDynamicLoading::LoadLibrary(InBuildTree("experiments/libeyebot_circle"));
  CDynamicLoading::LoadLibrary(InBuildTree("experiments/libfootbot_diffusion"));
  CTestWorld world(TextOf("eyebot_circle"));
  const CVector3 start = PositionOf(world, "fb");
  world.Step(100);
  Real turned = 0.0;  // rotation of the line from the foot-bot to the eye-bot, rad
  Real farthest = 0.0;
  Real last = 0.0;
  for (int tick = 0; tick < 500; ++tick) {
    world.Step();
    const CVector3 below = PositionOf(world, "fb");
    const CVector3 offset = PositionOf(world, "eb") - below;
    // The radius ordered is 0.75 m. The foot-bot moves on at 0.1 m/s. The eye-bot flies along the
    // tangent of about 0.3 s ago, in which the circle has turned by 0.16 rad: 0.064 m/s outwards.
    // It corrects the error at a rate of 2/s, so that half of the sum of both remains.
    CHECK(std::abs(std::hypot(offset.GetX(), offset.GetY()) - 0.75) <= 0.15);
    // 1.5 m above the antenna, which is 0.1 m above the ground
    CHECK(std::abs(offset.GetZ() - 1.6) <= 0.02);
    const Real angle = std::atan2(offset.GetY(), offset.GetX());
    turned += tick == 0 ? 0.0 : std::remainder(angle - last, 2.0 * std::numbers::pi);
    last = angle;
    farthest = std::max(farthest, HorizontalDistance(below, start));
  }
  // 0.4 m/s on that circle for 50 s are 4.2 turns
  CHECK(turned / (2.0 * std::numbers::pi) >= 3.0);
  CHECK(turned / (2.0 * std::numbers::pi) <= 5.5);
  // the foot-bot has moved
  CHECK(farthest >= 1.0);
}

TEST_CASE("eye-bot experiments: a flock flies to a light and stays together", "[scenario]") {
  CDynamicLoading::LoadLibrary(InBuildTree("experiments/libeyebot_flocking"));
  CTestWorld world(TextOf("eyebot_flocking"));
  std::vector<std::string> ids;
  for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
    ids.push_back(robot->GetRootEntity().GetId());
  }
  REQUIRE(ids.size() == 15);
  const auto meanX = [&] {
    Real sum = 0.0;
    for (const std::string& id : ids) {
      sum += PositionOf(world, id).GetX() / static_cast<Real>(ids.size());
    }
    return sum;
  };
  const Real start = meanX();
  world.Step(600);
  // the light adds 0.1 m/s for 57 s, and the forces between robots sum to zero
  CHECK(std::abs(meanX() - start - 5.7) <= 0.6);
  for (const std::string& id : ids) {
    const CVector3 position = PositionOf(world, id);
    std::vector<Real> distances;
    for (const std::string& other : ids) {
      if (other != id) {
        distances.push_back(HorizontalDistance(position, PositionOf(world, other)));
      }
    }
    CAPTURE(id);
    // Robots keep a distance of 1 m, or less in the middle, where the attraction of outer robots
    // adds up; a body is 0.5 m across.
    const Real nearest = *std::min_element(distances.begin(), distances.end());
    CHECK(nearest >= 0.6);
    CHECK(nearest <= 1.2);
    // the flock is connected: 15 discs of 1 m across, close together, are within 5 m
    CHECK(*std::max_element(distances.begin(), distances.end()) <= 6.0);
    CHECK(std::abs(position.GetZ() - 1.0) <= 0.05);
  }
}

}  // namespace argos::eyebot_experiments_test
