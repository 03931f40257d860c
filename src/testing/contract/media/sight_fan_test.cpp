// Compares the lines of sight of a fan with those that are tested one by one.

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/plugins/simulator/media/line_of_sight.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/simulator/media/sight_fan.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace sight_fan_test {

using namespace argos;

namespace {

// e-pucks on a regular grid, where many lines graze bodies or end at their surface; among them
// walls, turned boxes and a low cylinder
std::string MakeArena(UInt32 side, Real spacing) {
  std::ostringstream xml;
  xml.precision(17);
  for (UInt32 i = 0; i < side; ++i) {
    for (UInt32 j = 0; j < side; ++j) {
      std::ostringstream pose;
      pose.precision(17);
      pose << "position='" << (i + 0.5) * spacing << "," << (j + 0.5) * spacing
           << ",0' orientation='" << 10 * i + j << ",0,0'";
      xml << Robot("e-puck", "e" + std::to_string(i) + "_" + std::to_string(j), pose.str());
    }
  }
  const Real width = side * spacing;
  xml << "<box id='wall' size='0.01," << width << ",0.5' movable='false'><body position='-0.05,"
      << 0.5 * width << ",0'/></box>"
      << "<box id='turned' size='0.3,0.02,0.06' movable='false'><body position='" << 0.5 * width
      << ",-0.25,0' orientation='30,0,0'/></box>"
      << "<box id='moved' size='0.1,0.1,0.04' movable='true' mass='1'><body position='" << width
      << ",-0.25,0' orientation='50,0,0'/></box>"
      << "<cylinder id='low' radius='0.08' height='0.02' movable='false'><body position='-0.25,"
      << "-0.25,0'/></cylinder>";
  return xml.str();
}

// two points of each body: the middle of its base, raised to a common height, and another one
std::vector<CSightFan::SEnd> MakeEnds(CRobotWorld& world, bool isLevel) {
  CRandomStream random(1, "test", "sight fan", "ends");
  const CLineOfSight sight(world.GetSpace());
  std::vector<CSightFan::SEnd> ends;
  world.GetSpace().GetBodyIndex().ForEachBody([&](const CEmbodiedEntity& body) {
    const CVector3& base = body.GetOriginAnchor().Position;
    for (const bool isCentral : {true, false}) {
      const Real x = base.GetX() + (isCentral ? 0.0 : random.Uniform(-0.03, 0.03));
      const Real y = base.GetY() + (isCentral ? 0.0 : random.Uniform(-0.03, 0.03));
      const Real z = isLevel ? 0.03 : random.Uniform(0.0, 0.2);
      const CLineOfSight::SEnd end = CLineOfSight::MakeEnd(body);
      ends.push_back({x, y, z, CSightFan::ComputeReach(sight, end, x, y), end});
    }
  });
  return ends;
}

// the number of clear lines from one end to all, or to a few, after a comparison of each
size_t CountClear(const CLineOfSight& sight, const std::vector<CSightFan::SEnd>& ends, size_t eye,
                  size_t step) {
  CSightFan fan;
  std::vector<size_t> others;
  fan.Start(ends[eye]);
  for (size_t end = eye % step; end < ends.size(); end += step) {
    fan.Add(ends[end], end > eye);
    others.push_back(end);
  }
  fan.Trace(sight);
  size_t numClear = 0;
  for (size_t line = 0; line < others.size(); ++line) {
    const CSightFan::SEnd& from = ends[std::min(eye, others[line])];
    const CSightFan::SEnd& to = ends[std::max(eye, others[line])];
    const bool isClear = sight.IsClear(
        CRay3(CVector3(from.X, from.Y, from.Z), CVector3(to.X, to.Y, to.Z)), from.Body, to.Body);
    CAPTURE(eye, others[line]);
    CHECK(fan.IsClear(line) == isClear);
    numClear += isClear ? 1 : 0;
  }
  return numClear;
}

}  // namespace

TEST_CASE("sight fan: sees what single lines of sight see", "[media]") {
  // at 0.07 m, e-pucks would touch
  const Real spacing = GENERATE(0.0701, 0.12);
  const bool isLevel = GENERATE(true, false);
  const bool isMoved = GENERATE(true, false);
  CAPTURE(spacing, isLevel, isMoved);
  SRobotExperiment experiment;
  experiment.Arena = MakeArena(9, spacing);
  CRobotWorld world(experiment);
  world.GetSimulator().UpdateSpace();
  if (isMoved) {
    // found through the overlay of the index
    CEmbodiedEntity& body =
        world.GetRobot("e3_4").GetParent().GetComponent<CEmbodiedEntity>("body");
    REQUIRE(body.MoveTo(CVector3(-0.15, 0.4, 0.0), CQuaternion()));
  }
  const CLineOfSight sight(world.GetSpace());
  REQUIRE_FALSE(sight.HasBodiesOutsideIndex());
  REQUIRE(world.GetSpace().GetBodyIndex().HasMovedBodies() == isMoved);
  const std::vector<CSightFan::SEnd> ends = MakeEnds(world, isLevel);
  const size_t step = GENERATE(1U, 29U);
  size_t numClear = 0;
  size_t numLines = 0;
  for (size_t eye = 0; eye < ends.size(); ++eye) {
    numClear += CountClear(sight, ends, eye, step);
    numLines += (ends.size() - eye % step + step - 1) / step;
  }
  // both cases occur often
  CHECK(numClear > numLines / 50);
  CHECK(numClear < numLines - numLines / 50);
}

}  // namespace sight_fan_test
