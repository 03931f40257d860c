#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/geometry/shape_overlap.h>
#include <argos3/core/simulator/geometry/solid_overlap.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/testing/support/invariants.h>
#include <argos3/testing/support/polygons.h>
#include <argos3/testing/support/sanitizers.h>
#include <argos3/testing/support/solid_reference.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <tuple>
#include <vector>

namespace body_index_test {

using namespace argos;
using Catch::WithinAbs;

namespace {

// Grazing rays lose half of the digits in a square root; other results are exact to 1e-15.
constexpr Real kGrazing = 1e-7;

class CRandomNumbers {
 public:
  explicit CRandomNumbers(unsigned seed) : m_generator(seed) {}
  Real Real01() { return std::uniform_real_distribution<Real>(0.0, 1.0)(m_generator); }
  Real In(Real min, Real max) { return min + (max - min) * Real01(); }
  size_t Below(size_t count) {
    return std::min(count - 1, static_cast<size_t>(In(0.0, Real(count))));
  }
  CVector3 Point(Real halfSize) {
    return CVector3(In(-halfSize, halfSize), In(-halfSize, halfSize), In(-0.2, 0.4));
  }
  CQuaternion Yaw() { return CQuaternion(CRadians(In(-4.0, 4.0)), CVector3::Z); }
  CQuaternion Rotation() {
    CQuaternion q(In(-1.0, 1.0), In(-1.0, 1.0), In(-1.0, 1.0), In(-1.0, 1.0));
    return q.Normalize();
  }

 private:
  std::mt19937 m_generator;
};

struct SKind {
  std::shared_ptr<const SBodyDescription> Description;
  bool Movable;
  bool Tilts;
};

std::shared_ptr<const SBodyDescription> Describe(std::vector<SShapeDescription> solids) {
  auto description = std::make_shared<SBodyDescription>();
  description->Shapes = std::move(solids);
  description->Mass = 1.0;
  return description;
}

SKind RandomKind(CRandomNumbers& random) {
  const auto upright = [&] {
    return SShapeDescription::Cylinder(random.In(0.02, 0.15), random.In(0.05, 0.3));
  };
  const auto uniform = [&](Real low, Real high) { return random.In(low, high); };
  switch (random.Below(11)) {
    case 0:
    case 1:
      return {Describe({upright()}), true, false};
    case 2:
      return {Describe({SShapeDescription::Box(
                  CVector3(random.In(0.05, 0.3), random.In(0.05, 0.3), random.In(0.05, 0.3)))}),
              true, false};
    case 3:  // a wall
      return {Describe({SShapeDescription::Box(
                  CVector3(random.In(0.5, 8.0), random.In(0.02, 0.3), random.In(0.1, 0.5)))}),
              false, false};
    case 4:  // tilted arbitrarily: taller than wide
      return {Describe({SShapeDescription::Cylinder(random.In(0.02, 0.1), random.In(0.1, 0.6))}),
              true, true};
    case 5:
      return {Describe({SShapeDescription::Sphere(random.In(0.02, 0.2))}), true, true};
    case 6:  // larger than the discs above
      return {Describe({SShapeDescription::Cylinder(random.In(0.4, 1.0), random.In(0.1, 0.5))}),
              true, false};
    case 7:
      return {Describe({SShapeDescription::Prism(RandomPolygon(0.15, uniform), random.In(0.05, 0.3),
                                                 random.Point(0.1))}),
              true, false};
    case 8:  // tilted
      return {Describe({SShapeDescription::Prism(RandomPolygon(0.15, uniform), random.In(0.05, 0.5),
                                                 random.Point(0.1))}),
              true, true};
    case 9:  // a building
      return {
          Describe({SShapeDescription::Prism(RandomPolygon(3.0, uniform), random.In(0.1, 0.5))}),
          false, false};
    default: {
      SShapeDescription arm = SShapeDescription::Box(
          CVector3(random.In(0.05, 0.2), random.In(0.02, 0.1), random.In(0.02, 0.2)),
          CVector3(random.In(-0.1, 0.1), random.In(-0.1, 0.1), random.In(0.0, 0.1)));
      arm.Orientation = random.Below(2) == 0 ? random.Yaw() : random.Rotation();
      SShapeDescription ball = SShapeDescription::Sphere(random.In(0.02, 0.1), random.Point(0.1));
      return {Describe({upright(), arm, ball}), true, false};
    }
  }
}

// the same bodies in an index and, independently, in a list for brute-force reference results
class CBodies {
 public:
  CBodies(unsigned seed, Real areaHalfSize, Real spread)
      : m_random(seed), m_spread(spread), m_pool(0, CreateSchedule("balance_quantity")) {
    m_index.SetArea(CRange<CVector3>(CVector3(-areaHalfSize, -areaHalfSize, 0.0),
                                     CVector3(areaHalfSize, areaHalfSize, 1.0)));
  }

  void Add() {
    const SKind kind = RandomKind(m_random);
    m_bodies.push_back(std::make_unique<CEmbodiedEntity>(
        nullptr, "body", m_random.Point(m_spread),
        kind.Tilts ? m_random.Rotation() : m_random.Yaw(), kind.Movable));
    m_tilts[m_bodies.back().get()] = kind.Tilts;
    m_bodies.back()->SetBodyDescription(kind.Description);
    m_bodies.back()->EnterIndex(m_index);
  }

  void Remove(size_t i) {
    m_bodies[i]->LeaveIndex();
    m_tilts.erase(m_bodies[i].get());
    m_bodies.erase(m_bodies.begin() + static_cast<std::ptrdiff_t>(i));
  }

  void WritePose(size_t i) {
    m_bodies[i]->SetOriginPose(m_random.Point(m_spread),
                               m_tilts[m_bodies[i].get()] ? m_random.Rotation() : m_random.Yaw());
  }

  void Rebuild() { m_index.Rebuild(m_pool); }

  // Makes one random change; the index is up to date afterwards.
  // @param kinds  6: any change; 3: only those that occur between ticks
  void Change(size_t kinds = 6) {
    if (m_bodies.empty()) {
      Add();
      return;
    }
    const size_t i = m_random.Below(m_bodies.size());
    switch (m_random.Below(kinds)) {
      case 0:
        Add();
        break;
      case 1:
        Remove(i);
        break;
      case 2:
        WritePose(i);
        m_index.RefreshNow(m_bodies[i]->GetBodyNumber());
        break;
      case 3:  // as in a tick: all movable bodies move
        for (size_t k = 0; k < m_bodies.size(); ++k) {
          if (m_bodies[k]->IsMovable()) {
            WritePose(k);
          }
        }
        Rebuild();
        break;
      case 4: {
        const SKind kind = RandomKind(m_random);
        m_bodies[i]->SetMovable(kind.Movable);
        m_tilts[m_bodies[i].get()] = kind.Tilts;
        // notifies the index
        m_bodies[i]->SetBodyDescription(kind.Description);
        WritePose(i);
        m_index.RefreshNow(m_bodies[i]->GetBodyNumber());
        break;
      }
      default:  // as in a reset: any body, movable or not, is somewhere else
        WritePose(i);
        Rebuild();
    }
  }

  SReferenceBody Reference(const CEmbodiedEntity& body) const {
    return {body.GetBodyDescription(), body.GetOriginAnchor().Position,
            body.GetOriginAnchor().Orientation};
  }

  CRay3 RandomRay() {
    const CVector3 start = m_random.Point(m_spread);
    const Real angle = m_random.In(-4.0, 4.0);
    const Real length = m_random.Below(4) == 0 ? m_random.In(0.0, 20.0) : m_random.In(0.0, 1.0);
    const Real climb = m_random.Below(2) == 0 ? 0.0 : m_random.In(-1.0, 1.0);
    return CRay3(start, start + CVector3(length * std::cos(angle), length * std::sin(angle),
                                         length * climb));
  }

  void CheckRay(const CRay3& ray) {
    std::map<const CEmbodiedEntity*, Real> expected;
    const CEmbodiedEntity* ignored =
        m_bodies.empty() ? nullptr : m_bodies[m_random.Below(m_bodies.size())].get();
    Real closest = 2.0;
    Real closestBesides = 2.0;
    for (const auto& body : m_bodies) {
      if (const auto hit = ReferenceHit(Reference(*body), ray)) {
        expected[body.get()] = *hit;
        closest = std::min(closest, *hit);
        closestBesides = body.get() == ignored ? closestBesides : std::min(closestBesides, *hit);
      }
    }
    CAPTURE(ray.GetStart(), ray.GetEnd());
    TEmbodiedEntityIntersectionData hits;
    m_index.FindAllHits(hits, ray);
    CHECK(hits.size() == expected.size());
    for (const SEmbodiedEntityIntersectionItem& hit : hits) {
      REQUIRE(expected.count(hit.IntersectedEntity) == 1);
      CHECK_THAT(hit.TOnRay, WithinAbs(expected[hit.IntersectedEntity], kGrazing));
    }
    CheckClosest(ray, nullptr, expected, closest);
    CheckClosest(ray, ignored, expected, closestBesides);
  }

  void CheckNeighbourhood() {
    const CVector3 centre = m_random.Point(m_spread);
    const Real reach = m_random.In(0.0, m_random.Below(3) == 0 ? 5.0 : 0.3);
    std::set<std::pair<UInt32, UInt16>> visited;
    bool onceEach = true;
    m_index.ForShapesNear(centre.GetX(), centre.GetY(), reach, [&](const SIndexedShape& shape) {
      onceEach = visited.insert({shape.Body, shape.Shape}).second && onceEach;
    });
    CHECK(onceEach);
    for (const auto& body : m_bodies) {
      const auto& solids = body->GetBodyDescription()->Shapes;
      for (size_t solid = 0; solid < solids.size(); ++solid) {
        const CVector3 away = body->GetOriginAnchor().Position - centre;
        if (std::hypot(away.GetX(), away.GetY()) >
            reach + solids[solid].Offset.Length() + solids[solid].Size.Length()) {
          continue;
        }
        Real nearest = HUGE_VAL;
        for (const CVector3& point : SurfacePoints(Reference(*body), solid)) {
          nearest = std::min(
              nearest, std::hypot(point.GetX() - centre.GetX(), point.GetY() - centre.GetY()));
        }
        if (nearest <= reach &&
            visited.count({body->GetBodyNumber(), static_cast<UInt16>(solid)}) == 0) {
          CAPTURE(centre, reach, nearest, body->GetOriginAnchor().Position);
          FAIL("a solid within reach was not visited");
        }
      }
    }
  }

  // ListDiscsNear() lists or visits each solid that ForShapesNear() visits, and lists no others
  void CheckListedDiscs() {
    const CVector3 centre = m_random.Point(m_spread);
    const Real reach = m_random.In(0.0, m_random.Below(3) == 0 ? 5.0 : 0.3);
    const Real minZ = m_random.In(-0.2, 0.4);
    const UInt32 ignored = m_bodies.empty()
                               ? CBodyIndex::kNoBody
                               : m_bodies[m_random.Below(m_bodies.size())]->GetBodyNumber();
    const SDiscQuery query{centre.GetX(), centre.GetY(), reach, minZ, minZ + 0.01, ignored};
    std::multiset<std::tuple<Real, Real, Real>> listed;
    std::multiset<std::pair<UInt32, UInt16>> visited;
    SDiscList discs;
    const auto take = [&] {
      CHECK(discs.Size <= SDiscList::kCapacity);
      for (size_t i = 0; i < discs.Size; ++i) {
        listed.insert({discs.X[i], discs.Y[i], discs.Radius[i]});
      }
      discs.Size = 0;
    };
    m_index.ListDiscsNear(query, discs, take, [&](const SIndexedShape& shape) {
      visited.insert({shape.Body, shape.Shape});
    });
    take();
    m_index.ForShapesNear(query.X, query.Y, reach, [&](const SIndexedShape& shape) {
      if (visited.count({shape.Body, shape.Shape}) > 0) {
        CHECK(visited.count({shape.Body, shape.Shape}) == 1);
        return;
      }
      const auto disc = listed.find({shape.X, shape.Y, shape.Radius});
      if (shape.Body == ignored) {
        CHECK(disc == listed.end());
        return;
      }
      CAPTURE(shape.X, shape.Y, shape.Radius, shape.ZMin, shape.ZMax, minZ);
      REQUIRE(disc != listed.end());
      CHECK(shape.Kind == SIndexedShape::EKind::Disc);
      CHECK(shape.ZMin <= query.MinZ);
      CHECK(shape.ZMax >= query.MaxZ);
      listed.erase(disc);
      ++m_numListed;
    });
    CHECK(listed.empty());
  }

  void CheckOverlap() {
    const SKind kind = RandomKind(m_random);
    const CVector3 position = m_random.Point(m_spread);
    const CQuaternion orientation = kind.Tilts ? m_random.Rotation() : m_random.Yaw();
    const UInt32 ignored = m_bodies.empty()
                               ? CBodyIndex::kNoBody
                               : m_bodies[m_random.Below(m_bodies.size())]->GetBodyNumber();
    // an index that holds only the asking body gives its shape as indexed
    CBodyIndex alone;
    CEmbodiedEntity asking(nullptr, "asking", position, orientation, true);
    asking.SetBodyDescription(kind.Description);
    asking.EnterIndex(alone);
    UInt32 expected = CBodyIndex::kNoBody;
    alone.ForShapesNear(0.0, 0.0, 1e6, [&](const SIndexedShape& own) {
      m_index.ForShapesNear(0.0, 0.0, 1e6, [&](const SIndexedShape& other) {
        const SAnchor& origin = m_index.GetBody(other.Body).GetOriginAnchor();
        if (other.Body != ignored && ShapesOverlap(own, other) &&
            SolidsOverlap({&kind.Description->Shapes[own.Shape], position, orientation},
                          {&m_index.GetBody(other.Body).GetBodyDescription()->Shapes[other.Shape],
                           origin.Position, origin.Orientation})) {
          expected = std::min(expected, other.Body);
        }
      });
    });
    CAPTURE(position);
    CHECK(m_index.FindOverlap(*kind.Description, position, orientation, ignored) == expected);
  }

  void CheckAll() {
    CHECK(m_index.GetNumBodies() == m_bodies.size());
    for (const auto& body : m_bodies) {
      REQUIRE(&m_index.GetBody(body->GetBodyNumber()) == body.get());
    }
    for (int i = 0; i < 6; ++i) {
      CheckRay(RandomRay());
      CheckNeighbourhood();
      CheckListedDiscs();
      CheckOverlap();
    }
  }

  CBodyIndex& GetIndex() { return m_index; }
  size_t GetNumBodies() const { return m_bodies.size(); }
  size_t GetNumListedDiscs() const { return m_numListed; }

 private:
  void CheckClosest(const CRay3& ray, const CEmbodiedEntity* ignored,
                    const std::map<const CEmbodiedEntity*, Real>& expected, Real closest) {
    SEmbodiedEntityIntersectionItem item;
    REQUIRE(m_index.FindClosestHit(item, ray, ignored) == (closest <= 1.0));
    if (closest > 1.0) {
      CHECK(item.IntersectedEntity == nullptr);
      return;
    }
    REQUIRE(item.IntersectedEntity != nullptr);
    CHECK(item.IntersectedEntity != ignored);
    CHECK_THAT(item.TOnRay, WithinAbs(closest, kGrazing));
    REQUIRE(expected.count(item.IntersectedEntity) == 1);
    CHECK_THAT(expected.at(item.IntersectedEntity), WithinAbs(closest, kGrazing));
  }

  CRandomNumbers m_random;
  Real m_spread;
  CThreadPool m_pool;
  CBodyIndex m_index;
  std::vector<std::unique_ptr<CEmbodiedEntity>> m_bodies;
  std::map<const CEmbodiedEntity*, bool> m_tilts;
  size_t m_numListed = 0;  // discs that ListDiscsNear() has listed
};

}  // namespace

TEST_CASE("body index: results equal those of brute force, for any area and after any change",
          "[core][space][index]") {
  // half the size of the area: it contains all bodies; only some of them; it has few cells
  const Real area = GENERATE(5.0, 1.0, 200.0);
  const unsigned seed = GENERATE(1U, 2U);
  CAPTURE(area, seed);
  CBodies bodies(seed, area, 4.0);
  for (int i = 0; i < 250; ++i) {
    bodies.Add();
  }
  bodies.CheckAll();
  bodies.Rebuild();
  bodies.CheckAll();
  for (int change = 0; change < static_cast<int>(FewerIfSanitized(150)); ++change) {
    CAPTURE(change);
    bodies.Change();
    bodies.CheckAll();
  }
  bodies.Rebuild();
  for (int query = 0; query < 20; ++query) {
    bodies.CheckAll();
  }
  CHECK(bodies.GetNumListedDiscs() > 100);
}

TEST_CASE("body index: bodies may be added, removed and moved in any number between two ticks",
          "[core][space][index]") {
  const Real area = GENERATE(5.0, 1.0, 200.0);
  // changes between rebuilds: the unsorted overlay outgrows the sorted part, or stays small
  const int changes = GENERATE(40, 3000);
  CAPTURE(area, changes);
  CBodies bodies(3, area, 4.0);
  for (int tick = 0; tick < static_cast<int>(FewerIfSanitized(6000)) / changes + 1; ++tick) {
    CAPTURE(tick);
    for (int change = 0; change < changes; ++change) {
      bodies.Change(3);
      if (change % 29 == 0) {
        bodies.CheckAll();
      }
    }
    bodies.Rebuild();
    bodies.CheckAll();
  }
}

TEST_CASE("body index: a wall that was moved and put back is found in its original place",
          "[core][space][index]") {
  CThreadPool pool(0, CreateSchedule("balance_quantity"));
  CBodyIndex index;
  index.SetArea(CRange<CVector3>(CVector3(-5.0, -5.0, 0.0), CVector3(5.0, 5.0, 1.0)));
  CEmbodiedEntity wall(nullptr, "wall", CVector3(2.0, 0.0, 0.0), CQuaternion(), false);
  wall.SetBodyDescription(Describe({SShapeDescription::Box(CVector3(0.2, 4.0, 1.0))}));
  wall.EnterIndex(index);
  index.Rebuild(pool);
  wall.SetOriginPose(CVector3(3.0, 0.0, 0.0), CQuaternion());
  index.RefreshNow(wall.GetBodyNumber());
  index.Rebuild(pool);
  // what a reset does
  wall.SetOriginPose(CVector3(2.0, 0.0, 0.0), CQuaternion());
  index.Rebuild(pool);
  SEmbodiedEntityIntersectionItem item;
  REQUIRE(index.FindClosestHit(item, CRay3(CVector3(0.0, 0.0, 0.5), CVector3(4.0, 0.0, 0.5))));
  // 1.9 m of 4 m
  CHECK_THAT(item.TOnRay, WithinAbs(0.475, 1e-15));
}

TEST_CASE("body index: a tall body lying on its side is found at its far end",
          "[core][space][index]") {
  CThreadPool pool(0, CreateSchedule("balance_quantity"));
  CBodyIndex index;
  index.SetArea(CRange<CVector3>(CVector3(-5.0, -5.0, 0.0), CVector3(5.0, 5.0, 1.0)));
  // many bodies, so that cells are small
  std::vector<std::unique_ptr<CEmbodiedEntity>> bodies;
  const auto description = Describe({SShapeDescription::Cylinder(0.02, 0.8)});
  for (int i = 0; i < 2500; ++i) {
    const CVector3 position(-4.9 + 0.2 * (i % 50), -4.9 + 0.2 * (i / 50), 0.0);
    bodies.push_back(std::make_unique<CEmbodiedEntity>(nullptr, "body", position));
    bodies.back()->SetBodyDescription(description);
    bodies.back()->EnterIndex(index);
  }
  // its axis along x, 0.3 m above all others
  CEmbodiedEntity& lying = *bodies[25 * 50 + 25];
  const CVector3 base = lying.GetOriginAnchor().Position + CVector3(0.0, 0.05, 1.1);
  lying.SetOriginPose(base, CQuaternion(CRadians::PI_OVER_TWO, CVector3::Y));
  const bool rebuilt = GENERATE(false, true);
  if (rebuilt) {
    index.Rebuild(pool);
  } else {
    index.RefreshNow(lying.GetBodyNumber());
  }
  CAPTURE(rebuilt);
  const CVector3 near = base + CVector3(0.78, 0.0, 0.0);
  SEmbodiedEntityIntersectionItem item;
  REQUIRE(index.FindClosestHit(item, CRay3(near + CVector3(0.0, 0.0, 0.04), near)));
  CHECK(item.IntersectedEntity == &lying);
  // the surface of the cylinder is at half of the ray; the rotation is exact to a few roundings
  CHECK_THAT(item.TOnRay, WithinAbs(0.5, 1e-12));
}

TEST_CASE("body index: an index with no or few bodies can be queried", "[core][space][index]") {
  CBodies bodies(4, 1.0, 1.0);
  bodies.CheckAll();
  for (int change = 0; change < 100; ++change) {
    CAPTURE(change);
    bodies.Change();
    if (bodies.GetNumBodies() > 3) {
      bodies.Remove(0);
    }
    bodies.CheckAll();
  }
}

TEST_CASE("body index: an index without an area can be queried", "[core][space][index]") {
  CBodyIndex index;
  CEmbodiedEntity body(nullptr, "body", CVector3(1.0, 0.0, 0.0));
  body.SetBodyDescription(Describe({SShapeDescription::Cylinder(0.1, 0.2)}));
  body.EnterIndex(index);
  SEmbodiedEntityIntersectionItem item;
  REQUIRE(index.FindClosestHit(item, CRay3(CVector3(0.0, 0.0, 0.1), CVector3(2.0, 0.0, 0.1))));
  CHECK(item.IntersectedEntity == &body);
  // 0.9 m of 2 m
  CHECK_THAT(item.TOnRay, WithinAbs(0.45, 1e-15));
}

TEST_CASE("body index: the order of results does not depend on the threads that sorted it",
          "[core][space][index]") {
  std::vector<std::vector<std::pair<UInt32, UInt16>>> orders;
  for (const UInt32 threads : {0U, 2U, 4U}) {
    CBodies bodies(5, 5.0, 4.0);
    for (int i = 0; i < 3000; ++i) {
      bodies.Add();
    }
    CThreadPool pool(threads, CreateSchedule("balance_length"));
    bodies.GetIndex().Rebuild(pool);
    orders.emplace_back();
    bodies.GetIndex().ForShapesNear(0.0, 0.0, 3.0, [&](const SIndexedShape& shape) {
      orders.back().emplace_back(shape.Body, shape.Shape);
    });
  }
  REQUIRE(orders[0].size() > 1000);
  CHECK(orders[1] == orders[0]);
  CHECK(orders[2] == orders[0]);
}

TEST_CASE("body index: where invariants are checked, a stale number is caught",
          "[core][space][index][invariants]") {
  CBodyIndex index;
  CEmbodiedEntity body(nullptr, "body");
  body.SetBodyDescription(Describe({SShapeDescription::Sphere(0.5)}));
  body.EnterIndex(index);
  const UInt32 number = body.GetBodyNumber();
  CHECK(&index.GetBody(number) == &body);
  body.LeaveIndex();
  CHECK(body.GetBodyNumber() == CBodyIndex::kNoBody);
  CheckCaught([&] { index.GetBody(number); }, "the number is stale");
  CheckCaught([&] { index.Remove(number); }, "the number is stale");
  CheckCaught([&] { index.RefreshNow(number); }, "the number is stale");
  CheckCaught([&] { index.GetBody(CBodyIndex::kNoBody); }, "the number is stale");
}

TEST_CASE("body index: a destroyed body is removed from the index", "[core][space][index]") {
  CBodyIndex index;
  {
    CEmbodiedEntity body(nullptr, "body");
    body.SetBodyDescription(Describe({SShapeDescription::Sphere(0.5)}));
    body.EnterIndex(index);
    CHECK(index.GetNumBodies() == 1);
  }
  CHECK(index.GetNumBodies() == 0);
  SEmbodiedEntityIntersectionItem item;
  CHECK_FALSE(index.FindClosestHit(item, CRay3(CVector3(-2.0, 0.0, 0.5), CVector3(2.0, 0.0, 0.5))));
}

TEST_CASE("body index: of two bodies hit at the same distance the one added first is returned",
          "[core][space][index]") {
  CBodyIndex index;
  index.SetArea(CRange<CVector3>(CVector3(-2.0, -2.0, 0.0), CVector3(2.0, 2.0, 1.0)));
  // a disc and a box as wide as it in the same place, hit along the x axis
  CEmbodiedEntity first(nullptr, "first", CVector3(1.0, 0.0, 0.0));
  CEmbodiedEntity second(nullptr, "second", CVector3(1.0, 0.0, 0.0), CQuaternion(), false);
  first.SetBodyDescription(Describe({SShapeDescription::Cylinder(0.5, 1.0)}));
  second.SetBodyDescription(Describe({SShapeDescription::Box(CVector3(1.0, 1.0, 1.0))}));
  first.EnterIndex(index);
  second.EnterIndex(index);
  SEmbodiedEntityIntersectionItem item;
  REQUIRE(index.FindClosestHit(item, CRay3(CVector3(0.0, 0.0, 0.5), CVector3(1.0, 0.0, 0.5))));
  CHECK(item.IntersectedEntity == &first);
  CHECK(item.TOnRay == 0.5);
}

}  // namespace body_index_test
