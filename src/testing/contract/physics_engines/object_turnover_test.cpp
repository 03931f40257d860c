// Foot-bots that push objects, and grip and drag them where the engine has grips, while objects are
// added, removed and moved.

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/plugins/simulator/entities/box_entity.h>
#include <argos3/plugins/simulator/entities/cylinder_entity.h>
#include <argos3/plugins/simulator/physics_engines/planar/separation.h>
#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/contract/physics_engines/grip_world.h>
#include <argos3/testing/contract/physics_engines/turnover.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace argos::object_turnover_test {

namespace {

constexpr Real kHalf = 3.0;  // of the side of the pen, m
constexpr int kRobots = 50;
constexpr int kObjects = 40;

bool HasGrips(const SEngineType& engine) {
  return std::any_of(kEnginesWithGrips.begin(), kEnginesWithGrips.end(),
                     [&engine](const SEngineType& other) { return other.Tag == engine.Tag; });
}

std::string MakeArena(const SEngineType& engine) {
  std::ostringstream arena;
  for (const int side : {-1, 1}) {
    const Real at = side * (kHalf + 0.1);
    arena << "<box id='x" << side << "' size='0.2," << 2.0 * kHalf + 0.4
          << ",0.2' movable='false'><body position='" << at << ",0,0'/></box><box id='y" << side
          << "' size='" << 2.0 * kHalf << ",0.2,0.2' movable='false'><body position='0," << at
          << ",0'/></box>";
  }
  arena << "<distribute><position method='uniform' min='-2.5,-2.5,0' max='2.5,2.5,0'/>"
           "<orientation method='uniform' min='0,0,0' max='360,0,0'/><entity quantity='"
        << kRobots
        << "' max_trials='1000'><foot-bot id='r'><controller config='gripper'><params "
           "random='true' grip='"
        << (HasGrips(engine) ? "true" : "false")
        << "'/></controller></foot-bot></entity></distribute>";
  return arena.str();
}

/** Adds, removes and moves objects at random. */
class CObjectTurnover {
 public:
  explicit CObjectTurnover(CGripWorld& world) : m_world(world), m_scope(world.GetSimulator()) {
    m_fixed = CountModels();
    while (m_ids.size() < kObjects) {
      Add();
    }
  }

  void Tick() {
    if (m_random.Bernoulli(0.1)) {
      GetFunctions().RemoveEntity(TakeOne());
      Add();
      MoveToFreePlace(m_ids[DrawObject()]);
    }
    m_world.Step();
    ++m_ticks;
    m_held += static_cast<UInt64>(CountHeld());
  }

  /** None is lost, and none is deeper in another one than 1 % of its size. */
  void Check() {
    REQUIRE(CountModels() == m_fixed + m_ids.size());
    m_solids.clear();
    m_owners.clear();
    for (CEmbodiedEntity* body : ListBodies()) {
      const SAnchor& origin = body->GetOriginAnchor();
      CAPTURE(body->GetRootEntity().GetId(), origin.Position, m_ticks);
      REQUIRE(body->GetPhysicsModelsNum() == 1);
      REQUIRE(std::max(std::abs(origin.Position.GetX()), std::abs(origin.Position.GetY())) <
              kHalf + 0.2);
      if (!IsUpright(origin)) {
        ++m_tilted;
        continue;
      }
      ++m_upright;
      const size_t first = m_solids.size();
      AppendFootprints(*body->GetBodyDescription(), ComputePlanarPose(origin), m_solids);
      for (size_t i = first; i < m_solids.size(); ++i) {
        m_owners.push_back(body);
        for (size_t j = 0; j < first; ++j) {
          Measure(i, j);
        }
      }
    }
  }

  /** Of the size of the smaller one. */
  Real GetDeepest() const { return m_deepest; }
  /** Which ones these were, and when. */
  const std::string& GetDeepestPair() const { return m_deepestPair; }
  /** Of the bodies that were checked, the share that lean or are off the floor: not measured. */
  Real GetShareTilted() const {
    return static_cast<Real>(m_tilted) / static_cast<Real>(m_tilted + m_upright);
  }
  UInt64 GetNumAdded() const { return m_added; }
  /** Sum over ticks of the robots that hold something. */
  UInt64 GetNumHeld() const { return m_held; }

 private:
  CLoopFunctions& GetFunctions() { return m_world.GetSimulator().GetLoopFunctions(); }

  std::vector<CEmbodiedEntity*> ListBodies() {
    std::vector<CEmbodiedEntity*> bodies;
    for (const auto& [id, pose] : m_world.GetPoses()) {
      bodies.push_back(&m_world.Body(id));
    }
    return bodies;
  }

  // Others are not seen from above as their footprints.
  static bool IsUpright(const SAnchor& origin) {
    CVector3 up = CVector3::Z;
    up.Rotate(origin.Orientation);
    return up.GetZ() > std::cos(0.01) && std::abs(origin.Position.GetZ()) < 2e-3;
  }
  static SPlanarPose ComputePlanarPose(const SAnchor& origin) {
    CRadians yaw;
    CRadians pitch;
    CRadians roll;
    origin.Orientation.ToEulerAngles(yaw, pitch, roll);
    SPlanarPose pose;
    pose.X = origin.Position.GetX();
    pose.Y = origin.Position.GetY();
    pose.HalfCos = std::cos(0.5 * yaw.GetValue());
    pose.HalfSin = std::sin(0.5 * yaw.GetValue());
    return pose;
  }

  void Measure(size_t i, size_t j) {
    const SFootprint& a = m_solids[i];
    const SFootprint& b = m_solids[j];
    if (std::hypot(a.X - b.X, a.Y - b.Y) < ComputeExtent(a) + ComputeExtent(b)) {
      const auto sizeOf = [](const SFootprint& solid) {
        return 2.0 * (solid.Radius + std::min(solid.HalfX, solid.HalfY));
      };
      const Real depth = -ComputeGap(a, b) / std::min(sizeOf(a), sizeOf(b));
      if (depth > m_deepest) {
        m_deepest = depth;
        m_deepestPair = m_owners[i]->GetRootEntity().GetId() + " and " +
                        m_owners[j]->GetRootEntity().GetId() + " after tick " +
                        std::to_string(m_ticks);
      }
    }
  }

  size_t CountModels() {
    size_t count = 0;
    for (CPhysicsEngine* engine : m_world.GetSimulator().GetPhysicsEngines()) {
      count += engine->GetNumPhysicsModels();
    }
    return count;
  }

  int CountHeld() {
    int held = 0;
    for (int i = 0; i < kRobots; ++i) {
      held += m_world.Gripper("r" + std::to_string(i)).IsGripping() ? 1 : 0;
    }
    return held;
  }

  size_t DrawObject() { return m_random.UniformInteger(static_cast<UInt64>(m_ids.size())); }

  std::string TakeOne() {
    std::swap(m_ids[DrawObject()], m_ids.back());
    const std::string id = m_ids.back();
    m_ids.pop_back();
    return id;
  }

  void Add() {
    const std::string id = "o" + std::to_string(m_added++);
    const Real mass = std::pow(10.0, m_random.Uniform(-2.0, 1.0));  // kg
    const Real size = m_random.Uniform(0.1, 0.3);  // m
    // beside the pen, from where it is moved to a free place
    const CVector3 place(0.0, kHalf + 1.0, 0.0);
    if (m_random.Bernoulli(0.5)) {
      auto* box = new CBoxEntity(id, place, CQuaternion(), true, {size, 0.15, 0.1}, mass);
      GetFunctions().AddEntity(*box);
    } else {
      auto* cylinder = new CCylinderEntity(id, place, CQuaternion(), true, 0.5 * size, 0.1, mass);
      GetFunctions().AddEntity(*cylinder);
    }
    m_ids.push_back(id);
    MoveToFreePlace(id);
  }

  void MoveToFreePlace(const std::string& id) {
    for (int trial = 0; trial < 10000; ++trial) {
      const CVector3 place(m_random.Uniform(-kHalf, kHalf), m_random.Uniform(-kHalf, kHalf), 0.0);
      const CQuaternion heading(CRadians(m_random.Uniform(-3.0, 3.0)), CVector3::Z);
      if (GetFunctions().MoveEntity(m_world.Body(id), place, heading)) {
        return;
      }
    }
    FAIL("no free place for an object");
  }

  CGripWorld& m_world;
  CSimulator::CScope m_scope;
  CRandomStream m_random{1, "test", "turnover", "objects"};
  std::vector<std::string> m_ids;
  std::vector<SFootprint> m_solids;
  std::vector<CEmbodiedEntity*> m_owners;  // of the solids
  size_t m_fixed = 0;  // models of robots and walls
  UInt64 m_added = 0;
  UInt64 m_held = 0;
  UInt64 m_ticks = 0;
  UInt64 m_tilted = 0, m_upright = 0;
  Real m_deepest = 0.0;
  std::string m_deepestPair;
};

CGripWorld::SOptions MakeOptions(const SEngineType& engine) {
  CGripWorld::SOptions options;
  options.Engine = engine.ToXml();
  return options;
}

}  // namespace

TEST_CASE("objects: none is lost or enters another while they are gripped, added and removed",
          "[contract][engine][grip]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  CGripWorld world(MakeArena(engine), MakeOptions(engine));
  CObjectTurnover turnover(world);
  const UInt32 ticks = FewerIfSanitized(300);
  for (UInt32 tick = 0; tick < ticks; ++tick) {
    turnover.Tick();
    turnover.Check();
  }
  CHECK(turnover.GetNumHeld() >= (HasGrips(engine) ? ticks * kRobots / 100 : 0));
  CHECK(turnover.GetDeepest() <= 0.01);
}

// an hour of simulated time
TEST_CASE("objects: memory stays flat while they are gripped, added, removed and moved",
          "[.][soak][objects]") {
  for (const SEngineType& engine : kEnginesWithContacts) {
    // choose one section with -c
    DYNAMIC_SECTION(engine) {
      CGripWorld world(MakeArena(engine), MakeOptions(engine));
      CObjectTurnover turnover(world);
      UInt64 ticks = 0;
      const auto tick = [&] {
        turnover.Tick();
        turnover.Check();
        ++ticks;
      };
      SoakSimulated(10, tick);
      WARN(engine << ": " << turnover.GetNumAdded() << " objects added; "
                  << turnover.GetNumHeld() / ticks << " robots hold something; at most "
                  << 100.0 * turnover.GetDeepest()
                  << " % of the size: " << turnover.GetDeepestPair() << "; "
                  << 100.0 * turnover.GetShareTilted() << " % of bodies not measured");
      CHECK(turnover.GetNumHeld() >= (HasGrips(engine) ? ticks * kRobots / 100 : 0));
      // in dynamics3d 1.6 % was seen: a robot's turret turns an object that it holds against the
      // robot that holds it
      CHECK(turnover.GetDeepest() <= (engine.HasSlopes ? 0.02 : 0.01));
    }
  }
}

}  // namespace argos::object_turnover_test
