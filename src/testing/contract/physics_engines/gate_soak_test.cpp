// A thousand robots in sixteen engines with a gate in every border, for ten minutes.

#include <argos3/testing/contract/physics_engines/board.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/rooms.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace argos::gate_soak_test {

using testing::SRoomsWorld;

namespace {

constexpr UInt32 kRobots = 1000;
constexpr UInt32 kMinutes = 10;
// m: a robot within this distance of its place for a minute counts as stuck; it drives 10 cm/s
constexpr Real kStuck = 0.01;
// m: an engine keeps a lying or tilted robot up to this distance beyond a border
constexpr Real kBeyond = 0.2;

std::string ExperimentOf(const SBoard& board) {
  SRoomsWorld rooms;
  rooms.Robots = kRobots;
  rooms.Side = SRoomsWorld::SideAtSameDensity(kRobots);
  // in engines without contacts, a robot that has entered a wall could leave it on the other side
  const bool areAllStopped = std::all_of(board.Types.begin(), board.Types.end(),
                                         [](const SEngineType& type) { return type.HasContacts; });
  rooms.RoomsPerSide = areAllStopped ? 3 : 1;
  rooms.Threads = 2;
  return board.ToXml(rooms);
}

/** Checks the robots every second. */
class CGateWatch {
 public:
  explicit CGateWatch(CTestWorld& world) : m_world(world) {
    for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
      m_bodies.push_back(&robot->GetParent().GetComponent<CEmbodiedEntity>("body"));
    }
    REQUIRE(m_bodies.size() == kRobots);
    m_models = CountModels();
    for (CEmbodiedEntity* body : m_bodies) {
      m_where.push_back(&body->GetPhysicsModel(size_t(0)).GetEngine());
    }
  }

  // called after each second
  void Check() {
    // no robot is duplicated or lost
    Expect(CountModels() == m_models, "bodies in all engines");
    for (size_t i = 0; i < m_bodies.size(); ++i) {
      Expect(m_bodies[i]->GetPhysicsModelsNum() == 1, "engines of a robot");
      const CVector3& place = m_bodies[i]->GetOriginAnchor().Position;
      Expect(std::isfinite(place.Length()), "place of a robot");
      CPhysicsEngine& now = m_bodies[i]->GetPhysicsModel(size_t(0)).GetEngine();
      if (!now.IsPointContained(place)) {
        ++Late;
        Expect(now.GetVolume().ComputeDistance(place) <= kBeyond, "distance from its region");
      }
      Crossings += &now != m_where[i] ? 1 : 0;
      m_where[i] = &now;
      if (!m_starts.empty()) {
        m_ways[i] = std::max(m_ways[i], Distance(place, m_starts[i]));
      }
    }
  }

  // called after each minute
  void CountStuck() {
    for (size_t i = 0; i < m_bodies.size(); ++i) {
      Stuck += !m_starts.empty() && m_ways[i] <= kStuck ? 1 : 0;
    }
    m_starts.clear();
    for (const CEmbodiedEntity* body : m_bodies) {
      m_starts.push_back(body->GetOriginAnchor().Position);
    }
    m_ways.assign(m_bodies.size(), 0.0);
  }

  int Crossings = 0;  // detected every second
  int Stuck = 0;  // robots, summed over minutes
  int Late = 0;  // robots beyond the region of their engine, summed over seconds

 private:
  // REQUIRE would take longer than the simulation for millions of checks
  static void Expect(bool holds, const char* what) {
    if (!holds) {
      FAIL("wrong: " << what);
    }
  }

  size_t CountModels() {
    size_t count = 0;
    for (CPhysicsEngine* engine : m_world.GetSimulator().GetPhysicsEngines()) {
      count += engine->GetNumPhysicsModels();
    }
    return count;
  }

  CTestWorld& m_world;
  std::vector<CEmbodiedEntity*> m_bodies;
  std::vector<CPhysicsEngine*> m_where;
  std::vector<CVector3> m_starts;  // m, positions at the start of the minute
  std::vector<Real> m_ways;  // m, greatest distances from there since
  size_t m_models = 0;
};

void Roam(const SBoard& board) {
  CTestWorld world(ExperimentOf(board));
  REQUIRE(world.GetSimulator().GetPhysicsEngines().size() ==
          size_t(SBoard::kPerSide) * SBoard::kPerSide);
  CGateWatch watch(world);
  watch.CountStuck();
  for (UInt32 minute = 0; minute < kMinutes; ++minute) {
    CAPTURE(minute);
    for (UInt32 second = 0; second < 60; ++second) {
      world.Step(10);
      watch.Check();
    }
    watch.CountStuck();
  }
  // on average each robot crosses a border every minute
  CHECK(watch.Crossings >= static_cast<int>(kRobots * kMinutes));
  CHECK(watch.Stuck == 0);
  // one robot in a thousand waits until it stands upright
  const bool mayBeLate = std::any_of(board.Types.begin(), board.Types.end(),
                                     [](const SEngineType& type) { return type.HasSlopes; }) &&
                         board.Types.size() > 1;
  CHECK(watch.Late <= (mayBeLate ? static_cast<int>(kRobots * kMinutes * 60) / 1000 : 0));
}

}  // namespace

TEST_CASE("gates: of a thousand robots roaming for ten minutes none is lost, duplicated or stuck",
          "[.][soak][partition][gates]") {
  for (const SBoard& board : ListBoards()) {
    // choose one section with -c
    DYNAMIC_SECTION(board.Name) {
      Roam(board);
    }
  }
}

}  // namespace argos::gate_soak_test
