// Compares the lines of sight of cameras with rays that are tested one by one.

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/ray_queries.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/generic/simulator/sight_lines.h>
#include <argos3/testing/contract/sensors/scene.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace sight_lines_test {

using namespace argos;

namespace {

constexpr Real kReach = 1.0;  // m, from the middle of the arena

CVector3 DrawPoint(CRandomStream& random, Real maxZ) {
  return CVector3(random.Uniform(-kReach, kReach), random.Uniform(-kReach, kReach),
                  random.Uniform(0.0, maxZ));
}

// solids of several kinds and heights, on the ground and above it, around a robot
std::string MakeArena(CRandomStream& random) {
  std::string xml = Robot("foot-bot", "r", PoseText(CVector3(0.1, -0.2, 0.0), 20.0));
  for (int i = 0; i < 30; ++i) {
    const std::string id = "o" + std::to_string(i);
    CVector3 place = DrawPoint(random, 0.3);
    if (i % 3 == 0) {
      place.SetZ(0.0);
    }
    const CVector3 size(random.Uniform(0.02, 0.2), random.Uniform(0.02, 0.2),
                        random.Uniform(0.02, 0.2));
    if (i % 2 == 0) {
      xml += "<cylinder id='" + id + "' radius='" + ToText(size.GetX()) + "' height='" +
             ToText(size.GetZ()) + "' movable='" + (i % 4 == 0 ? "true' mass='1" : "false") +
             "'><body " + PoseText(place, 0.0) + "/></cylinder>";
    } else {
      xml += "<box id='" + id + "' size='" + ToText(size) + "' movable='false'><body position='" +
             ToText(place) + "' orientation='" + ToText(random.Uniform(0.0, 360.0)) + "," +
             (i % 5 == 0 ? "30" : "0") + ",0'/></box>";
    }
  }
  return xml;
}

bool IsVisible(CEmbodiedEntity& ownBody, const CVector3& eye, const CVector3& point) {
  SEmbodiedEntityIntersectionItem hit;
  const Real length = (point - eye).Length();
  return !GetClosestEmbodiedEntityIntersectedByRay(hit, CRay3(eye, point), ownBody) ||
         hit.TOnRay >= 1.0 - CSightLines::kTouch / length;
}

struct SView {
  CVector3 Eye;  // m
  std::vector<CVector3> Points;  // m, of several groups
  size_t GroupSize;
};

// points that are level with the eye, above it and below it; those of a group are near each other
SView MakeView(CRandomStream& random, size_t groupSize) {
  SView view{DrawPoint(random, 0.5), {}, groupSize};
  for (int group = 0; group < 50; ++group) {
    CVector3 first = DrawPoint(random, 0.5);
    if (group % 5 == 0) {
      first.SetZ(view.Eye.GetZ());
    } else if (group % 5 == 1) {
      // below or above the eye, or nearly so
      first.SetX(view.Eye.GetX() + (group % 2 == 0 ? 0.0 : 1e-3));
      first.SetY(view.Eye.GetY());
    }
    view.Points.push_back(first);
    for (size_t i = 1; i < groupSize; ++i) {
      view.Points.push_back(first + 0.05 * DrawPoint(random, 1.0));
    }
  }
  return view;
}

SBoundingBox Enclose(const SView& view) {
  SBoundingBox box{view.Eye, view.Eye};
  for (const CVector3& point : view.Points) {
    for (UInt32 axis = 0; axis < 3; ++axis) {
      box.MinCorner[axis] = std::min(box.MinCorner[axis], point[axis]);
      box.MaxCorner[axis] = std::max(box.MaxCorner[axis], point[axis]);
    }
  }
  return box;
}

// @return true if something may occlude points between two heights in a square around the middle of
// the arena
bool MayOcclude(const CRayCaster& robot, Real minZ, Real maxZ) {
  CSightLines lines;
  lines.Start(robot, CVector3(0.0, 0.0, minZ));
  return lines.FindOccluders({CVector3(-kReach, -kReach, minZ), CVector3(kReach, kReach, maxZ)});
}

// @return the number of visible groups, after a comparison of each
size_t CountVisible(const CRayCaster& robot, const SView& view, bool all) {
  CSightLines lines;
  lines.Start(robot, view.Eye, view.GroupSize);
  lines.FindOccluders(Enclose(view));
  for (const CVector3& point : view.Points) {
    lines.Add(point);
  }
  lines.Trace(all);
  size_t numVisible = 0;
  for (size_t group = 0; group < view.Points.size() / view.GroupSize; ++group) {
    bool isVisible = true;
    for (size_t i = group * view.GroupSize; i < (group + 1) * view.GroupSize; ++i) {
      const bool isClear = IsVisible(robot.GetBody(), view.Eye, view.Points[i]);
      CAPTURE(view.Eye, view.Points[i]);
      CHECK((!all || lines.IsClear(i) == isClear));
      isVisible = isVisible && isClear;
    }
    CHECK(lines.IsGroupClear(group) == isVisible);
    numVisible += isVisible ? 1 : 0;
  }
  return numVisible;
}

}  // namespace

TEST_CASE("sight lines: see what single rays see", "[contract][cameras]") {
  const size_t groupSize = GENERATE(1, 5);
  const bool all = GENERATE(true, false);
  CAPTURE(groupSize, all);
  CRandomStream random(1, "test", "sight lines", std::to_string(groupSize));
  size_t numVisible = 0;
  size_t numGroups = 0;
  for (int trial = 0; trial < 8; ++trial) {
    SRobotExperiment experiment;
    experiment.Arena = MakeArena(random);
    CRobotWorld world(experiment);
    CRayCaster robot;
    robot.SetRobot(dynamic_cast<CComposableEntity&>(world.GetRobot("r").GetRootEntity()));
    world.Step();
    for (int i = 0; i < 10; ++i) {
      const SView view = MakeView(random, groupSize);
      numVisible += CountVisible(robot, view, all);
      numGroups += view.Points.size() / groupSize;
    }
  }
  // both cases occur often
  CHECK(numVisible > numGroups / 20);
  CHECK(numVisible < numGroups - numGroups / 20);
}

TEST_CASE("sight lines: without bodies between the heights of eye and points, all are clear",
          "[contract][cameras]") {
  SRobotExperiment experiment;
  experiment.Arena = Robot("foot-bot", "r", PoseText(CVector3(), 0.0)) +
                     Robot("foot-bot", "other", PoseText(CVector3(0.5, 0.0, 0.0), 0.0));
  CRobotWorld world(experiment);
  CRayCaster robot;
  robot.SetRobot(dynamic_cast<CComposableEntity&>(world.GetRobot("r").GetRootEntity()));
  world.Step();
  CHECK_FALSE(MayOcclude(robot, 0.15, 0.3));
  CHECK(MayOcclude(robot, 0.14, 0.3));
  CHECK_FALSE(MayOcclude(robot, -0.3, -0.01));
  // a body that has been moved since the last tick is found where it is now
  auto& other = world.GetRobot("other").GetParent().GetComponent<CEmbodiedEntity>("body");
  REQUIRE(other.MoveTo(CVector3(0.5, 0.2, 0.1), CQuaternion()));
  CHECK(MayOcclude(robot, 0.15, 0.3));
  CHECK_FALSE(MayOcclude(robot, 0.25, 0.3));
  REQUIRE(other.MoveTo(CVector3(1.5, 0.2, 0.0), CQuaternion()));
  CHECK_FALSE(MayOcclude(robot, 0.1, 0.3));
}

}  // namespace sight_lines_test
