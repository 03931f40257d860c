// Extensions that plug-ins attach to a space, and checks that run when it is loaded.

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/toy_world.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <vector>

namespace shared_by_space_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

class CCounter : public CSpaceExtension {
 public:
  CCounter() { ++NumAlive; }
  ~CCounter() override { --NumAlive; }
  int Count = 0;
  static int NumAlive;
};
int CCounter::NumAlive = 0;

class COther : public CSpaceExtension {};

// registers checks while an experiment is loaded
class CCheckingLoopFunctions : public CLoopFunctions {
 public:
  void Init(TConfigurationNode&) override {
    for (int i = 0; i < 2; ++i) {
      GetSimulator().CheckWhenLoaded([this] {
        ++NumChecks;
        if (GetSpace().GetRootEntityVector().size() != 1) {
          THROW_ARGOSEXCEPTION("the arena needs one robot, neither more nor less");
        }
      });
    }
    // no check runs before everything is loaded
    NumChecksInInit = NumChecks;
  }
  int NumChecks = 0;
  int NumChecksInInit = -1;
};

SExperiment WithRobots(int num) {
  SExperiment experiment{.LoopFunctions = "<loop_functions label='checking_loop_functions' />",
                         .Engines = "<toy_engine id='toy' />"};
  if (num > 0) {
    experiment.Controllers = "<toy_controller id='c'/>";
  }
  for (int i = 0; i < num; ++i) {
    experiment.Arena += "<toy-robot id='r" + std::to_string(i) +
                        "'> <body position='0,0,0' /> <controller config='c' /> </toy-robot>";
  }
  return experiment;
}

}  // namespace

REGISTER_LOOP_FUNCTIONS(CCheckingLoopFunctions, "checking_loop_functions")

TEST_CASE("space: an extension is created once per space and destroyed with its content",
          "[core][space]") {
  REQUIRE(CCounter::NumAlive == 0);
  {
    CTestWorld a(SExperiment{});
    CTestWorld b(SExperiment{});
    CCounter& inA = a.GetSpace().GetExtension<CCounter>();
    inA.Count = 3;
    CHECK(&a.GetSpace().GetExtension<CCounter>() == &inA);
    CHECK(a.GetSpace().GetExtension<CCounter>().Count == 3);
    CHECK(b.GetSpace().GetExtension<CCounter>().Count == 0);
    COther& other = a.GetSpace().GetExtension<COther>();
    CHECK(static_cast<CSpaceExtension*>(&other) != &inA);
    CHECK(CCounter::NumAlive == 2);
    // the extension survives a reset
    a.GetSimulator().Reset();
    CHECK(a.GetSpace().GetExtension<CCounter>().Count == 3);
    a.GetSimulator().Destroy();
    CHECK(CCounter::NumAlive == 1);
  }
  CHECK(CCounter::NumAlive == 0);
}

TEST_CASE("simulator: checks of devices run when everything is loaded, later ones at once",
          "[core][simulator]") {
  CTestWorld world(WithRobots(1));
  auto& functions = world.GetLoopFunctions<CCheckingLoopFunctions>();
  CHECK(functions.NumChecksInInit == 0);
  CHECK(functions.NumChecks == 2);
  bool called = false;
  world.GetSimulator().CheckWhenLoaded([&called] { called = true; });
  CHECK(called);
}

TEST_CASE("simulator: an exception thrown by a check is a loading error, reported once",
          "[core][simulator][errors]") {
  const std::string error = LoadError(WithRobots(2));
  CHECK_THAT(error, Contains("one robot"));
  CHECK(error.find("one robot") == error.rfind("one robot"));
}

namespace {

std::unique_ptr<CEmbodiedEntity> MakeCylinder(Real radius, Real height, const CVector3& position,
                                              bool isMovable) {
  auto description = std::make_shared<SBodyDescription>();
  description->Shapes = {SShapeDescription::Cylinder(radius, height)};
  description->Mass = 1.0;
  auto body = std::make_unique<CEmbodiedEntity>(nullptr, "b", position, CQuaternion(), isMovable);
  body->SetBodyDescription(description);
  return body;
}

}  // namespace

TEST_CASE("body index: the solids along a ray are those within reach of it in the plane",
          "[core][space]") {
  CRandomStream random(1, "test", "body index", "corridors");
  CBodyIndex index;
  index.SetArea(CRange<CVector3>(CVector3(-3.0, -3.0, 0.0), CVector3(3.0, 3.0, 1.0)));
  CThreadPool pool(0, CreateSchedule("balance_quantity"));
  std::vector<std::unique_ptr<CEmbodiedEntity>> bodies;
  std::vector<Real> radii;
  for (int i = 0; i < 200; ++i) {
    // some are larger than the limit of small bodies
    radii.push_back(random.Uniform(0.02, 0.5));
    // some are outside the area
    const CVector3 position(random.Uniform(-4.0, 4.0), random.Uniform(-4.0, 4.0), 0.0);
    bodies.push_back(MakeCylinder(radii.back(), 0.1, position, random.Bernoulli(0.8)));
    bodies.back()->EnterIndex(index);
    if (i == 150) {
      // bodies added later are found through the overlay
      index.Rebuild(pool);
    }
  }
  for (int trial = 0; trial < 200; ++trial) {
    const CRay3 ray(CVector3(random.Uniform(-4.0, 4.0), random.Uniform(-4.0, 4.0), 0.05),
                    CVector3(random.Uniform(-4.0, 4.0), random.Uniform(-4.0, 4.0), 0.05));
    const Real reach = random.Uniform(0.0, 0.6);
    std::set<UInt32> visited;
    index.ForShapesAlongRay(ray, {reach, HUGE_VAL},
                            [&](const SIndexedShape& shape) { visited.insert(shape.Body); });
    for (size_t i = 0; i < bodies.size(); ++i) {
      CVector3 along;
      ray.ToVector(along);
      const CVector3 aside = bodies[i]->GetOriginAnchor().Position - ray.GetStart();
      const Real t =
          std::min(1.0, std::max(0.0, (along.GetX() * aside.GetX() + along.GetY() * aside.GetY()) /
                                          along.SquareLength()));
      const Real apart =
          std::hypot(aside.GetX() - t * along.GetX(), aside.GetY() - t * along.GetY());
      if (apart <= reach + radii[i]) {
        CAPTURE(trial, i, apart, reach, radii[i]);
        REQUIRE(visited.count(bodies[i]->GetBodyNumber()) == 1);
      }
    }
  }
}

TEST_CASE("body index: queries of areas and of rays with heights find all solids in reach",
          "[core][space]") {
  CRandomStream random(1, "test", "body index", "heights");
  CBodyIndex index;
  index.SetArea(CRange<CVector3>(CVector3(-3.0, -3.0, 0.0), CVector3(3.0, 3.0, 3.0)));
  CThreadPool pool(0, CreateSchedule("balance_quantity"));
  constexpr Real kHeight = 0.3;  // m, of all solids
  std::vector<std::unique_ptr<CEmbodiedEntity>> bodies;
  std::vector<Real> radii;
  for (int i = 0; i < 100; ++i) {
    radii.push_back(random.Uniform(0.02, 0.4));
    const CVector3 position(random.Uniform(-4.0, 4.0), random.Uniform(-4.0, 4.0),
                            random.Uniform(0.5, 1.5));
    bodies.push_back(MakeCylinder(radii.back(), kHeight, position, random.Bernoulli(0.8)));
    bodies.back()->EnterIndex(index);
    if (i == 80) {
      index.Rebuild(pool);
    }
  }
  const auto place = [&](size_t i) { return bodies[i]->GetOriginAnchor().Position; };
  const auto numberOf = [&](size_t i) { return bodies[i]->GetBodyNumber(); };
  for (int trial = 0; trial < 100; ++trial) {
    SPlanarArea area = SPlanarArea::Empty();
    area.Include(random.Uniform(-4.0, 4.0), random.Uniform(-4.0, 4.0));
    area.Include(random.Uniform(-4.0, 4.0), random.Uniform(-4.0, 4.0));
    std::multiset<UInt32> inArea;
    index.ForShapesInArea(area, [&](const SIndexedShape& shape) { inArea.insert(shape.Body); });

    const CRay3 ray(
        CVector3(random.Uniform(-4.0, 4.0), random.Uniform(-4.0, 4.0), random.Uniform(0.0, 2.5)),
        CVector3(random.Uniform(-4.0, 4.0), random.Uniform(-4.0, 4.0), random.Uniform(0.0, 2.5)));
    const SRayReach reach{random.Uniform(0.0, 0.3), random.Uniform(0.0, 0.2)};
    std::set<UInt32> alongRay;
    index.ForShapesAlongRay(ray, reach,
                            [&](const SIndexedShape& shape) { alongRay.insert(shape.Body); });
    // several rays: the same one, one that crosses few cells, and one above everything
    const CVector3 near = ray.GetStart() + CVector3(0.2, -0.3, 0.1);
    const std::vector<CRay3> rays = {CRay3(ray.GetStart(), near), ray,
                                     CRay3(CVector3(0.0, 0.0, 2.5), CVector3(1.0, 1.0, 2.5))};
    std::set<UInt32> alongRays;
    index.ForShapesAlongRays(
        rays, reach, [&](const SIndexedShape& shape) { alongRays.insert(shape.Body); },
        [] { return false; });
    std::set<UInt32> alongShort;
    index.ForShapesAlongRay(rays[0], reach,
                            [&](const SIndexedShape& shape) { alongShort.insert(shape.Body); });
    const auto isAmong = [&alongRays](UInt32 body) { return alongRays.count(body) == 1; };
    REQUIRE(std::all_of(alongShort.begin(), alongShort.end(), isAmong));
    for (size_t i = 0; i < bodies.size(); ++i) {
      CAPTURE(trial, i);
      const CVector3 center = place(i);
      const Real dx = center.GetX() - std::clamp(center.GetX(), area.MinX, area.MaxX);
      const Real dy = center.GetY() - std::clamp(center.GetY(), area.MinY, area.MaxY);
      if (std::hypot(dx, dy) <= radii[i]) {
        REQUIRE(inArea.count(numberOf(i)) == 1);
      }
      constexpr int kSteps = 200;
      for (int step = 0; step <= kSteps; ++step) {
        CVector3 point;
        ray.GetPoint(point, static_cast<Real>(step) / kSteps);
        const bool isInReach =
            std::hypot(point.GetX() - center.GetX(), point.GetY() - center.GetY()) <=
                reach.Across + radii[i] &&
            point.GetZ() >= center.GetZ() - reach.Vertical &&
            point.GetZ() <= center.GetZ() + kHeight + reach.Vertical;
        if (isInReach) {
          REQUIRE(alongRay.count(numberOf(i)) == 1);
          REQUIRE(alongRays.count(numberOf(i)) == 1);
          break;
        }
      }
    }
  }

  // a ray above everything meets nothing sorted, and visits only what was added since
  std::set<UInt32> above;
  index.ForShapesAlongRay(CRay3(CVector3(-4.0, -4.0, 2.5), CVector3(4.0, 4.0, 2.5)), SRayReach{0.5},
                          [&](const SIndexedShape& shape) { above.insert(shape.Body); });
  for (size_t i = 0; i <= 80; ++i) {
    CHECK(above.count(numberOf(i)) == 0);
  }
}

}  // namespace shared_by_space_test
