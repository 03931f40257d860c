// Pairs of bodies from the broad phase, and contact points of cylinders and prisms.

#include <argos3/plugins/simulator/physics_engines/dynamics3d/broad_phase.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/contact_spread.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/cylinder_contacts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/hull_geom.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/ode_session.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/prism_geom.h>

#include <argos3/core/simulator/geometry/convex_solid.h>
#include <argos3/core/simulator/geometry/solid_overlap.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/testing/support/polygons.h>

#include <catch2/catch.hpp>

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <set>
#include <vector>

namespace contacts_test {

using namespace argos;
using Catch::Matchers::WithinAbs;

namespace {

// bodies of one box each
struct SBoxes {
  std::vector<std::unique_ptr<SRigidBody>> All;
  std::vector<SRigidBody*> Movables, Fixed;
  dWorldID World = dWorldCreate();

  SBoxes() = default;
  SBoxes(const SBoxes&) = delete;
  SBoxes& operator=(const SBoxes&) = delete;
  ~SBoxes() {
    for (const auto& body : All) {
      dGeomDestroy(body->Solids[0]);
    }
    dWorldDestroy(World);
  }

  void Add(const CVector3& size, const CVector3& position, bool movable) {
    All.push_back(std::make_unique<SRigidBody>());
    SRigidBody& body = *All.back();
    body.Solids.push_back(dCreateBox(nullptr, size.GetX(), size.GetY(), size.GetZ()));
    if (movable) {
      body.Body = dBodyCreate(World);
      dGeomSetBody(body.Solids[0], body.Body);
    }
    dGeomSetPosition(body.Solids[0], position.GetX(), position.GetY(), position.GetZ());
    auto& list = movable ? Movables : Fixed;
    body.Number = static_cast<UInt32>(list.size());
    list.push_back(&body);
    UpdateBounds(body);
  }
};

using TPairs = std::set<std::pair<const SRigidBody*, const SRigidBody*>>;

TPairs ToSet(const std::vector<SRigidPair>& pairs) {
  TPairs set;
  for (const SRigidPair& pair : pairs) {
    set.insert(std::minmax<const SRigidBody*>(pair.First, pair.Second));
  }
  // no pair occurs twice
  CHECK(set.size() == pairs.size());
  return set;
}

TPairs FindByForce(const SBoxes& boxes) {
  TPairs set;
  for (const auto& a : boxes.All) {
    for (const auto& b : boxes.All) {
      const bool overlap = a->Low <= b->High && b->Low <= a->High;
      if (a < b && overlap && (a->IsMovable() || b->IsMovable())) {
        set.insert(std::minmax<const SRigidBody*>(a.get(), b.get()));
      }
    }
  }
  return set;
}

dGeomID Cylinder(Real radius, Real length, const CVector3& centre, Real tilt = 0.0) {
  const dGeomID geom = dCreateCylinder(nullptr, radius, length);
  dGeomSetPosition(geom, centre.GetX(), centre.GetY(), centre.GetZ());
  dMatrix3 rotation;
  dRFromAxisAndAngle(rotation, 0.0, 1.0, 0.0, tilt);
  dGeomSetRotation(geom, rotation);
  return geom;
}

// a solid, and its geom at a pose
struct SPlacedGeom {
  SShapeDescription Shape;
  CVector3 Position;
  CQuaternion Orientation;
  dGeomID Geom;

  SPlacedGeom(SShapeDescription shape, const CVector3& position, const CQuaternion& orientation)
      : Shape(std::move(shape)), Position(position), Orientation(orientation) {
    using EKind = SShapeDescription::EKind;
    const Real height = Shape.Size.GetZ();
    Geom = Shape.Kind == EKind::Box
               ? dCreateBox(nullptr, Shape.Size.GetX(), Shape.Size.GetY(), height)
           : Shape.Kind == EKind::Cylinder ? dCreateCylinder(nullptr, Shape.Radius, height)
           : Shape.Kind == EKind::Sphere   ? dCreateSphere(nullptr, Shape.Radius)
                                           : CreatePrism(*Shape.Vertices, height);
    CVector3 middle = Shape.ComputeMiddle();
    middle.Rotate(orientation);
    middle += position;
    dGeomSetPosition(Geom, middle.GetX(), middle.GetY(), middle.GetZ());
    const dQuaternion quaternion = {orientation.GetW(), orientation.GetX(), orientation.GetY(),
                                    orientation.GetZ()};
    dGeomSetQuaternion(Geom, quaternion);
  }
  SPlacedGeom(const SPlacedGeom&) = delete;
  SPlacedGeom& operator=(const SPlacedGeom&) = delete;
  ~SPlacedGeom() { dGeomDestroy(Geom); }

  bool Overlaps(const SPlacedGeom& other, const CVector3& shift = CVector3()) const {
    return SolidsOverlap({&Shape, Position + shift, Orientation},
                         {&other.Shape, other.Position, other.Orientation});
  }
};

}  // namespace

TEST_CASE("broad phase: finds the pairs that brute force finds while bodies move", "[dynamics3d]") {
  UseODEInThisThread();
  // bodies spread along x, along y, and over a square
  const CVector3 spread = GENERATE(CVector3(5, 0.5, 1), CVector3(0.5, 5, 1), CVector3(2, 2, 1));
  CAPTURE(spread);
  CRandomStream random(3, "test", "boxes", "places");
  const auto anywhere = [&] {
    return CVector3(random.Uniform(-1.0, 1.0) * spread.GetX(),
                    random.Uniform(-1.0, 1.0) * spread.GetY(),
                    random.Uniform(-1.0, 1.0) * spread.GetZ());
  };
  SBoxes boxes;
  for (int i = 0; i < 120; ++i) {
    const Real side = random.Uniform(0.05, 0.4);
    boxes.Add(CVector3(side, side * 2.0, side), anywhere(), i % 5 != 0);
  }
  boxes.Add(CVector3(10, 0.1, 3), CVector3(), false);
  CBroadPhase phase;
  size_t most = 0;
  for (int step = 0; step < 30; ++step) {
    const TPairs found = ToSet(phase.FindPairs(boxes.Movables, boxes.Fixed));
    REQUIRE(found == FindByForce(boxes));
    most = std::max(most, found.size());
    for (SRigidBody* body : boxes.Movables) {
      const dReal* const position = dGeomGetPosition(body->Solids[0]);
      dGeomSetPosition(body->Solids[0], position[0] + random.Uniform(-0.1, 0.1),
                       position[1] + random.Uniform(-0.1, 0.1),
                       position[2] + random.Uniform(-0.1, 0.1));
    }
  }
  CHECK(most > 50);
}

TEST_CASE("cylinder contacts: cylinders side by side touch at both ends of a line",
          "[dynamics3d]") {
  UseODEInThisThread();
  // radii 0.3 and 0.2, the axes 0.4 apart along the diagonal of a 3-4-5 triangle: 0.1 deep
  const dGeomID a = Cylinder(0.3, 1.0, CVector3(0, 0, 0.5));
  const dGeomID b = Cylinder(0.2, 0.4, CVector3(0.24, 0.32, 0.7));
  dContactGeom contacts[4];
  REQUIRE(FindContacts(a, b, 4, contacts, sizeof(dContactGeom)) == 2);
  for (int i = 0; i < 2; ++i) {
    CHECK_THAT(contacts[i].depth, WithinAbs(0.1, 1e-12));
    // the normal points into the first cylinder
    CHECK_THAT(contacts[i].normal[0], WithinAbs(-0.6, 1e-12));
    CHECK_THAT(contacts[i].normal[1], WithinAbs(-0.8, 1e-12));
    CHECK_THAT(contacts[i].normal[2], WithinAbs(0.0, 1e-12));
    // between both surfaces: 0.25 from the axis of the first
    CHECK_THAT(contacts[i].pos[0], WithinAbs(0.15, 1e-12));
    CHECK_THAT(contacts[i].pos[1], WithinAbs(0.2, 1e-12));
    // at the lower and the upper end of the second cylinder
    CHECK_THAT(contacts[i].pos[2], WithinAbs(i == 0 ? 0.5 : 0.9, 1e-12));
  }
  CHECK(FindContacts(a, b, 1, contacts, sizeof(dContactGeom)) == 1);
  dGeomDestroy(a);
  dGeomDestroy(b);
}

TEST_CASE(
    "cylinder contacts: a tilted cylinder touches more at one end, separate ones do not touch",
    "[dynamics3d]") {
  UseODEInThisThread();
  const Real tilt = 0.01;
  const dGeomID a = Cylinder(0.1, 0.4, CVector3(0, 0, 0));
  const dGeomID leaning = Cylinder(0.1, 0.4, CVector3(0.2, 0, 0), tilt);
  dContactGeom contacts[4];
  // the lower end of the tilted one is 0.2 sin(tilt) inside the first
  REQUIRE(FindContacts(a, leaning, 4, contacts, sizeof(dContactGeom)) == 1);
  CHECK_THAT(contacts[0].depth, WithinAbs(0.2 * std::sin(tilt), 1e-4));
  CHECK_THAT(contacts[0].pos[2], WithinAbs(-0.2, 1e-3));
  const dGeomID apart = Cylinder(0.1, 0.4, CVector3(0.21, 0, 0));
  CHECK(FindContacts(a, apart, 4, contacts, sizeof(dContactGeom)) == 0);
  // one above the other with a gap
  const dGeomID above = Cylinder(0.1, 0.4, CVector3(0, 0, 0.41));
  CHECK(FindContacts(a, above, 4, contacts, sizeof(dContactGeom)) == 0);
  for (const dGeomID geom : {a, leaning, apart, above}) {
    dGeomDestroy(geom);
  }
}

TEST_CASE("cylinder contacts: cylinders that lean against each other touch where they are nearest",
          "[dynamics3d]") {
  UseODEInThisThread();
  // beside each other along y, and the second one is tilted along x: nearest in the middle
  const Real tilt = GENERATE(0.05, 0.1, 0.2);
  const Real depth = GENERATE(1e-3, -5e-4);
  CAPTURE(tilt, depth);
  const dGeomID a = Cylinder(0.1, 0.4, CVector3(0, 0, 0));
  const dGeomID b = Cylinder(0.1, 0.4, CVector3(0, 0.2 - depth, 0), tilt);
  dContactGeom contacts[4];
  const int count = FindContacts(a, b, 4, contacts, sizeof(dContactGeom), 1e-3);
  REQUIRE(count >= 1);
  const dContactGeom& deepest =
      *std::max_element(contacts, contacts + count,
                        [](const auto& one, const auto& next) { return one.depth < next.depth; });
  CHECK_THAT(deepest.depth, WithinAbs(depth, 1e-9));
  CHECK_THAT(deepest.pos[2], WithinAbs(0.0, 1e-9));
  CHECK_THAT(deepest.normal[1], WithinAbs(-1.0, 1e-9));
  dGeomDestroy(a);
  dGeomDestroy(b);
}

TEST_CASE("cylinder contacts: one that leans slightly on a plane or a box touches at four points",
          "[dynamics3d]") {
  UseODEInThisThread();
  const Real tilt = GENERATE(0.0, 1e-3, 9e-3);
  CAPTURE(tilt);
  const dGeomID cylinder = Cylinder(0.1, 0.3, CVector3(0.2, 0.1, 0.149), tilt);
  const dGeomID plane = dCreatePlane(nullptr, 0.0, 0.0, 1.0, 0.0);
  const dGeomID box = dCreateBox(nullptr, 1.0, 1.0, 0.5);
  dGeomSetPosition(box, 0.0, 0.0, -0.25);
  for (const dGeomID ground : {plane, box}) {
    dContactGeom contacts[4];
    REQUIRE(FindContacts(cylinder, ground, 4, contacts, sizeof(dContactGeom)) == 4);
    for (const dContactGeom& contact : contacts) {
      // 0.1 m from the middle of its base, and below the ground
      CHECK_THAT(std::hypot(contact.pos[0] - 0.2, contact.pos[1] - 0.1), WithinAbs(0.1, 2e-3));
      CHECK_THAT(contact.depth, WithinAbs(-contact.pos[2], 1e-12));
      CHECK_THAT(contact.depth, WithinAbs(1e-3, 0.11 * tilt + 1e-12));
      CHECK(contact.normal[2] == 1.0);
    }
    REQUIRE(FindContacts(ground, cylinder, 4, contacts, sizeof(dContactGeom)) == 4);
    CHECK(contacts[0].g1 == ground);
    CHECK(contacts[0].normal[2] == -1.0);
  }
  for (const dGeomID geom : {cylinder, plane, box}) {
    dGeomDestroy(geom);
  }
}

TEST_CASE("ODE session: the random numbers of a sequence are those that ODE would draw",
          "[dynamics3d]") {
  UseODEInThisThread();
  // otherwise worlds could not make iterative steps concurrently
  REQUIRE(IsODERandomReplaced());
  // ODE's own function, which this program's calls do not reach
  Dl_info library;
  REQUIRE(dladdr(dlsym(RTLD_DEFAULT, "dRandSetSeed"), &library) != 0);
  void* const handle = dlopen(library.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
  REQUIRE(handle != nullptr);
  auto* const drawFromODE = reinterpret_cast<unsigned long (*)()>(dlsym(handle, "dRand"));
  REQUIRE((drawFromODE != nullptr));
  REQUIRE((drawFromODE != &dRand));

  const SBoxes empty;
  const UInt32 sequence = GENERATE(0U, 5U, 4000000000U);
  StepODEIteratively(empty.World, 0.01, sequence);
  dRandSetSeed((sequence + 1U) * 0x9E3779B9U);
  for (int i = 0; i < 1000; ++i) {
    REQUIRE(dRand() == drawFromODE());
  }
  StepODEIteratively(empty.World, 0.01, sequence);
  const unsigned long first = dRand();
  StepODEIteratively(empty.World, 0.01, sequence + 1U);
  CHECK(dRand() != first);
  dlclose(handle);
}

TEST_CASE("prism contacts: their greatest depth along the normal separates the solids",
          "[dynamics3d]") {
  UseODEInThisThread();
  CRandomStream random(4, "test", "prisms", "contacts");
  const auto uniform = [&](Real low, Real high) { return random.Uniform(low, high); };
  const auto point = [&](Real half) {
    return CVector3(uniform(-half, half), uniform(-half, half), uniform(-half, half));
  };
  const int kind = GENERATE(0, 1, 2, 3);
  const bool upright = GENERATE(false, true);
  CAPTURE(kind, upright);
  const auto turn = [&] {
    return upright ? CQuaternion(CRadians(uniform(-3, 3)), CVector3::Z)
                   : CQuaternion(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1))
                         .Normalize();
  };
  int touching = 0;
  int apart = 0;
  int tooShallow = 0;
  for (int scene = 0; scene < 1000; ++scene) {
    const SPlacedGeom prism(
        SShapeDescription::Prism(RandomPolygon(0.3, uniform), uniform(0.1, 0.5)), point(0.2),
        turn());
    SShapeDescription shape = SShapeDescription::Sphere(uniform(0.05, 0.2));
    if (kind == 0) {
      shape = SShapeDescription::Prism(RandomPolygon(0.3, uniform), uniform(0.1, 0.5));
    } else if (kind == 1) {
      shape = SShapeDescription::Box(CVector3(uniform(0.1, 0.5), uniform(0.1, 0.5), 0.3));
    } else if (kind == 2) {
      shape = SShapeDescription::Cylinder(uniform(0.05, 0.2), uniform(0.1, 0.5));
    }
    const SPlacedGeom other(shape, point(0.3), turn());
    // a skew cylinder is replaced by one with 24 sides
    const Real error = kind == 2 ? 0.02 * shape.Radius : 1e-6;
    dContactGeom contacts[4];
    const int count = FindContacts(prism.Geom, other.Geom, 4, contacts, sizeof(dContactGeom));
    REQUIRE(count <= 4);
    CAPTURE(scene, count);
    if (count == 0) {
      ++apart;
      // overlaps of a rounding are missed
      if (kind != 2) {
        REQUIRE_FALSE(prism.Overlaps(other));
      }
      continue;
    }
    const auto findDeepest = [](const dContactGeom* all, int number) {
      return *std::max_element(all, all + number, [](const auto& one, const auto& next) {
        return one.depth < next.depth;
      });
    };
    const dContactGeom deepest = findDeepest(contacts, count);
    const Real depth = deepest.depth;
    const CVector3 normal = FromODE(deepest.normal);
    REQUIRE_THAT(normal.Length(), WithinAbs(1.0, 1e-9));
    // the same in the other order
    dContactGeom reverse[4];
    const int back = FindContacts(other.Geom, prism.Geom, 4, reverse, sizeof(dContactGeom));
    REQUIRE(back > 0);
    REQUIRE_THAT(findDeepest(reverse, back).depth, WithinAbs(depth, 1e-4));
    REQUIRE(reverse[0].g1 == other.Geom);
    ++touching;
    if (prism.Overlaps(other, normal * (depth + error))) {
      // deep inside each other, the deepest point may be outside of the faces that touch
      ++tooShallow;
      REQUIRE_FALSE(prism.Overlaps(other, normal * (1.3 * depth)));
      continue;
    }
    if (depth > 2.0 * error) {
      REQUIRE(prism.Overlaps(other, normal * (0.9 * depth - error)));
    }
  }
  CHECK(touching > 200);
  CHECK(500 * tooShallow <= touching);
  CHECK(apart > 50);
}

TEST_CASE("prism contacts: at rest on a plane or a table there is one at each of four corners",
          "[dynamics3d]") {
  UseODEInThisThread();
  const SPlacedGeom prism(SShapeDescription::Prism(RegularPolygon(8, 0.2), 0.1),
                          CVector3(0.3, 0.1, -0.001), CQuaternion(CRadians(0.4), CVector3::Z));
  const dGeomID plane = dCreatePlane(nullptr, 0.0, 0.0, 1.0, 0.0);
  const SPlacedGeom table(SShapeDescription::Box(CVector3(1, 1, 0.5)), CVector3(0, 0, -0.5),
                          CQuaternion());
  const SPlacedGeom prismatic(SShapeDescription::Prism(RegularPolygon(3, 2.0), 0.5),
                              CVector3(0, 0, -0.5), CQuaternion());
  const SPlacedGeom drum(SShapeDescription::Cylinder(1.0, 0.5), CVector3(0, 0, -0.5),
                         CQuaternion());
  for (const dGeomID ground : {plane, table.Geom, prismatic.Geom, drum.Geom}) {
    CAPTURE(dGeomGetClass(ground));
    dContactGeom contacts[4];
    REQUIRE(FindContacts(prism.Geom, ground, 4, contacts, sizeof(dContactGeom)) == 4);
    CVector3 sum;
    for (const dContactGeom& contact : contacts) {
      CHECK_THAT(contact.depth, WithinAbs(0.001, 1e-9));
      CHECK_THAT(contact.normal[2], WithinAbs(1.0, 1e-12));
      const Real radius = std::hypot(contact.pos[0] - 0.3, contact.pos[1] - 0.1);
      CHECK_THAT(radius, WithinAbs(0.2, 1e-9));
      sum += FromODE(contact.pos);
    }
    // they surround the centre
    CHECK(std::hypot(0.25 * sum.GetX() - 0.3, 0.25 * sum.GetY() - 0.1) < 0.1);
  }
  dGeomDestroy(plane);
}

TEST_CASE("prism contacts: a prism and a cylinder side by side touch along a line",
          "[dynamics3d]") {
  UseODEInThisThread();
  // the side of the hexagon faces along y, at 0.1 sqrt(3) / 2; the cylinder is higher than it
  const Real apothem = 0.1 * std::sqrt(0.75);
  const SPlacedGeom hexagon(SShapeDescription::Prism(RegularPolygon(6, 0.1), 0.3), CVector3(),
                            CQuaternion());
  const Real depth = GENERATE(0.001, -0.001);
  CAPTURE(depth);
  const dGeomID cylinder = Cylinder(0.05, 0.6, CVector3(0.01, apothem + 0.05 - depth, 0.2));
  dContactGeom contacts[4];
  CHECK(FindContacts(hexagon.Geom, cylinder, 4, contacts, sizeof(dContactGeom)) ==
        (depth > 0.0 ? 2 : 0));
  REQUIRE(FindContacts(hexagon.Geom, cylinder, 4, contacts, sizeof(dContactGeom), 0.002) == 2);
  for (int i = 0; i < 2; ++i) {
    CHECK_THAT(contacts[i].depth, WithinAbs(depth, 1e-12));
    CHECK_THAT(contacts[i].normal[1], WithinAbs(-1.0, 1e-12));
    CHECK_THAT(contacts[i].pos[0], WithinAbs(0.01, 1e-12));
    CHECK_THAT(contacts[i].pos[1], WithinAbs(apothem - 0.5 * depth, 1e-12));
    CHECK_THAT(contacts[i].pos[2], WithinAbs(i == 0 ? 0.0 : 0.3, 1e-12));
  }
  dGeomDestroy(cylinder);
}

TEST_CASE("hull contacts: a hull that sinks into an upright solid has the depth of its overlap",
          "[dynamics3d]") {
  UseODEInThisThread();
  std::vector<CVector3> corners;
  for (const Real x : {-0.1, 0.1}) {
    for (const Real y : {-0.05, 0.05}) {
      for (const Real z : {-0.03, 0.03}) {
        corners.emplace_back(x, y, z);
      }
    }
  }
  const CConvexSolid solid(corners);
  SHullArrays arrays;
  const dGeomID hull = MakeHullGeom(solid, arrays);
  const bool isPrism = GENERATE(true, false);
  CAPTURE(isPrism);
  // 0.4 m wide and 0.2 m high, with its middle at (1,2,3); the geom refers to its base
  const std::vector<CVector2> base = RectanglePolygon(0.4, 0.4);
  const dGeomID upright = isPrism ? CreatePrism(base, 0.2) : dCreateCylinder(nullptr, 0.2, 0.2);
  dGeomSetPosition(upright, 1.0, 2.0, 3.0);
  constexpr Real kDepth = 0.004;  // m
  struct SCase {
    CVector3 Normal;  // from the upright solid to the hull
    Real Distance;  // of the middles, m
  };
  for (const SCase& c : {SCase{CVector3::Z, 0.13}, SCase{-CVector3::Z, 0.13},
                         SCase{CVector3::X, 0.3}, SCase{-CVector3::X, 0.3}}) {
    CAPTURE(c.Normal);
    const CVector3 place = CVector3(1.0, 2.0, 3.0) + c.Normal * (c.Distance - kDepth);
    dGeomSetPosition(hull, place.GetX(), place.GetY(), place.GetZ());
    std::array<dContactGeom, 32> contacts;
    const int count = FindHullContacts(hull, upright, 32, contacts.data(), sizeof(dContactGeom));
    REQUIRE(count > 0);
    // as for any pair of geoms, in any order
    std::array<dContactGeom, 32> same;
    CHECK(FindContacts(hull, upright, 32, same.data(), sizeof(dContactGeom)) == count);
    CHECK(same[0].depth == contacts[0].depth);
    CHECK(FindContacts(upright, hull, 32, same.data(), sizeof(dContactGeom)) == count);
    CHECK(same[0].depth == contacts[0].depth);
    Real deepest = 0.0;
    for (int i = 0; i < count; ++i) {
      const dContactGeom& contact = contacts[static_cast<size_t>(i)];
      deepest = std::max<Real>(deepest, contact.depth);
      CHECK((contact.g1 == upright || contact.g2 == upright));
      // along the axis of the overlap
      const CVector3 normal(contact.normal[0], contact.normal[1], contact.normal[2]);
      CHECK_THAT(std::abs(normal.DotProduct(c.Normal)), WithinAbs(1.0, 1e-9));
      const CVector3 at = CVector3(contact.pos[0], contact.pos[1], contact.pos[2]) - place;
      CHECK(std::abs(at.GetX()) <= 0.1 + kDepth);
      CHECK(std::abs(at.GetY()) <= 0.05 + kDepth);
      CHECK(std::abs(at.GetZ()) <= 0.03 + kDepth);
    }
    // a side of the cylinder's polygon lies across x, so that both are exact
    CHECK_THAT(deepest, WithinAbs(kDepth, isPrism || c.Normal.GetX() == 0.0 ? 1e-9 : 0.002));
  }
  dGeomSetPosition(hull, 1.0, 2.0, 3.14);
  std::array<dContactGeom, 32> contacts;
  CHECK(FindHullContacts(hull, upright, 32, contacts.data(), sizeof(dContactGeom)) == 0);
  dGeomDestroy(hull);
  dGeomDestroy(upright);
}

TEST_CASE(
    "cylinder contacts: parallel cylinders that do not reach each other's height do not touch",
    "[dynamics3d]") {
  UseODEInThisThread();
  const dGeomID low = Cylinder(0.1, 0.2, CVector3());
  const Real lift = GENERATE(0.199, 0.201);  // m
  CAPTURE(lift);
  const dGeomID high = Cylinder(0.1, 0.2, CVector3(0.199, 0.0, lift));
  std::array<dContactGeom, 8> contacts;
  const int count = FindContacts(low, high, 8, contacts.data(), sizeof(dContactGeom));
  CHECK((count > 0) == (lift < 0.2));
  dGeomDestroy(low);
  dGeomDestroy(high);
}

TEST_CASE("contact spread: of many contacts those are kept that support as all do",
          "[dynamics3d]") {
  // the deepest, three beside it, the farthest, and one to a side; x, y, depth
  constexpr std::array<std::array<double, 3>, 6> kAll = {{{0.0, 0.0, 0.01},
                                                          {0.1, 0.0, 0.0},
                                                          {0.2, 0.0, 0.0},
                                                          {0.3, 0.0, 0.0},
                                                          {1.0, 0.0, 0.0},
                                                          {0.5, 0.5, 0.0}}};
  std::array<dContactGeom, 6> all = {};
  for (size_t i = 0; i < all.size(); ++i) {
    all[i].pos[0] = kAll[i][0];
    all[i].pos[1] = kAll[i][1];
    all[i].normal[2] = 1.0;
    all[i].depth = kAll[i][2];
  }
  const auto keep = [&](int first, int count, int most) {
    std::array<dContactGeom, 6> kept = {};
    const int number = KeepSpread(&all[static_cast<size_t>(first)], count, most, kept.data(),
                                  sizeof(dContactGeom));
    std::vector<double> xs;
    for (int i = 0; i < number; ++i) {
      xs.push_back(kept[static_cast<size_t>(i)].pos[0]);
    }
    return xs;
  };
  // nothing is on the other side, where the deepest would come twice
  CHECK(keep(0, 6, 8) == std::vector<double>{0.0, 1.0, 0.5});
  CHECK(keep(0, 5, 2) == std::vector<double>{0.0, 1.0});
  // there is room for all
  CHECK(keep(0, 4, 8) == std::vector<double>{0.0, 0.1, 0.2, 0.3});
  CHECK(keep(0, 4, 2) == std::vector<double>{0.0, 0.3});
}

}  // namespace contacts_test
