// Where cylinders touch what they stand on and what stands beside them, at exact places.

#include <argos3/plugins/simulator/physics_engines/dynamics3d/contact_spread.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/cylinder_contacts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/ode_session.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace contact_places_test {

using namespace argos;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kBit = 1.0 / 64.0;  // m

/* A geom that is destroyed with it. */
class CGeom {
 public:
  explicit CGeom(dGeomID geom) : m_geom(geom) {}
  CGeom(dGeomID geom, const CVector3& place) : m_geom(geom) {
    dGeomSetPosition(geom, place.GetX(), place.GetY(), place.GetZ());
  }
  CGeom(const CGeom&) = delete;
  CGeom& operator=(const CGeom&) = delete;
  ~CGeom() { dGeomDestroy(m_geom); }

  dGeomID Get() const { return m_geom; }
  void Turn(const CVector3& axis, Real angle) {
    dMatrix3 rotation;
    dRFromAxisAndAngle(rotation, axis.GetX(), axis.GetY(), axis.GetZ(), angle);
    dGeomSetRotation(m_geom, rotation);
  }

 private:
  dGeomID m_geom;
};

dGeomID Cylinder(Real length = 1.0) {
  return dCreateCylinder(nullptr, 0.25, length);
}

std::vector<dContactGeom> Find(const CGeom& first, const CGeom& second, Real reach = 0.0,
                               int most = 4) {
  std::vector<dContactGeom> contacts(static_cast<size_t>(most));
  const int count =
      FindContacts(first.Get(), second.Get(), most, contacts.data(), sizeof(dContactGeom), reach);
  contacts.resize(static_cast<size_t>(count));
  return contacts;
}

// of contacts in places along x, whose side1 is their number
std::vector<int> Keep(const std::vector<CVector3>& places, int most) {
  std::vector<dContactGeom> all(places.size());
  for (size_t i = 0; i < places.size(); ++i) {
    for (UInt32 axis = 0; axis < 3; ++axis) {
      all[i].pos[axis] = places[i][axis];
      all[i].normal[axis] = axis == 2 ? 1.0 : 0.0;
    }
    all[i].depth = 1.0;
    all[i].side1 = static_cast<int>(i);
  }
  std::array<dContactGeom, 4> kept{};
  const int count =
      KeepSpread(all.data(), static_cast<int>(all.size()), most, kept.data(), sizeof(dContactGeom));
  std::vector<int> numbers;
  for (int i = 0; i < count; ++i) {
    numbers.push_back(kept[static_cast<size_t>(i)].side1);
  }
  return numbers;
}

}  // namespace

TEST_CASE("contact places: cylinders beside each other touch where both are, and no farther",
          "[dynamics3d]") {
  UseODEInThisThread();
  // of the second one: place, and how far apart they may be; contacts at these heights
  const auto [x, z, reach, depth, heights] =
      GENERATE(table<Real, Real, Real, Real, std::vector<Real>>(
          {{0.5 - kBit, 0.0, 0.0, kBit, {-0.25, 0.25}},
           {0.5, 0.0, 0.0, 0.0, {-0.25, 0.25}},
           {0.5 + kBit, 0.0, 0.0, 0.0, {}},
           {0.5 + kBit, 0.0, kBit, -kBit, {-0.25, 0.25}},
           {0.5 + kBit, 0.0, 0.99 * kBit, 0.0, {}},
           // higher, up to the end of the first one, and beyond
           {0.5, 0.5, 0.0, 0.0, {0.25, 0.5}},
           {0.5, 0.75, 0.0, 0.0, {0.5, 0.5}},
           {0.5, 0.75 + kBit, 0.0, 0.0, {}},
           {0.5, -0.75, 0.0, 0.0, {-0.5, -0.5}},
           {0.5, -0.75 - kBit, 0.0, 0.0, {}},
           // as deep in each other along the axes as across them
           {0.5 - kBit, 0.75 - kBit, 0.0, kBit, {0.5 - kBit, 0.5}}}));
  CAPTURE(x, z, reach);
  const CGeom a(Cylinder(), CVector3());
  const CGeom b(Cylinder(0.5), CVector3(x, 0, z));
  const std::vector<dContactGeom> contacts = Find(a, b, reach);
  REQUIRE(contacts.size() == heights.size());
  for (size_t i = 0; i < heights.size(); ++i) {
    // between both surfaces; the normal points into the first one
    CHECK(contacts[i].pos[0] == 0.25 - 0.5 * depth);
    CHECK(contacts[i].pos[2] == heights[i]);
    CHECK(contacts[i].depth == depth);
    CHECK(contacts[i].normal[0] == -1.0);
  }
  CHECK(Find(a, b, reach, 1).size() == std::min<size_t>(1, heights.size()));
}

TEST_CASE("contact places: of cylinders with one axis the way out is across it", "[dynamics3d]") {
  UseODEInThisThread();
  const CVector3 axis = GENERATE(CVector3::X, CVector3::Y, CVector3::Z);
  CAPTURE(axis);
  CGeom a(Cylinder(), CVector3());
  CGeom b(Cylinder(0.5), CVector3());
  for (CGeom* const geom : {&a, &b}) {
    if (axis != CVector3::Z) {
      geom->Turn(axis == CVector3::X ? CVector3::Y : CVector3::X, 0.5 * std::numbers::pi);
    }
  }
  const std::vector<dContactGeom> contacts = Find(a, b);
  REQUIRE(contacts.size() == 2);
  for (const dContactGeom& contact : contacts) {
    // twice the radius, at the ends of the shorter one
    CHECK_THAT(contact.depth, WithinAbs(0.5, 1e-9));
    CHECK_THAT(std::abs(CVector3(contact.pos[0], contact.pos[1], contact.pos[2]).DotProduct(axis)),
               WithinAbs(0.25, 1e-9));
    const CVector3 normal(contact.normal[0], contact.normal[1], contact.normal[2]);
    const CVector3 expected = axis == CVector3::X ? CVector3::Y : CVector3::X;
    CHECK_THAT(normal.DotProduct(expected), WithinAbs(1.0, 1e-9));
  }
}

TEST_CASE("contact places: a cylinder that just touches a plane or a box stands on four points",
          "[dynamics3d]") {
  UseODEInThisThread();
  const CGeom plane(dCreatePlane(nullptr, 0.0, 0.0, 1.0, 0.0));
  // on a box also where its rim is just above the border of the face
  const CGeom box(dCreateBox(nullptr, 1.0, 1.0, 0.5), CVector3(0, 0, -0.25));
  const auto [x, y] = GENERATE(
      table<Real, Real>({{0.0, 0.0}, {0.25, 0.0}, {-0.25, 0.0}, {0.0, 0.25}, {0.25, -0.25}}));
  const Real depth = GENERATE(0.0, 1.0 / 128.0);
  CAPTURE(x, y, depth);
  const CGeom cylinder(Cylinder(), CVector3(x, y, 0.5 - depth));
  for (const CGeom* const ground : {&plane, &box}) {
    const std::vector<dContactGeom> contacts = Find(cylinder, *ground);
    REQUIRE(contacts.size() == 4);
    Real sumX = 0.0;
    Real sumY = 0.0;
    for (const dContactGeom& contact : contacts) {
      CHECK(contact.depth == depth);
      CHECK(contact.normal[2] == 1.0);
      CHECK_THAT(std::hypot(contact.pos[0] - x, contact.pos[1] - y), WithinAbs(0.25, 1e-12));
      sumX += contact.pos[0] - x;
      sumY += contact.pos[1] - y;
    }
    // all around
    CHECK_THAT(sumX, WithinAbs(0.0, 1e-12));
    CHECK_THAT(sumY, WithinAbs(0.0, 1e-12));
  }
  const CGeom above(Cylinder(), CVector3(x, y, 0.5 + 1.0 / 128.0));
  CHECK(Find(above, plane).empty());
}

TEST_CASE("contact places: a cylinder that leans by more than 0.01 touches at its lowest point",
          "[dynamics3d]") {
  UseODEInThisThread();
  const CGeom plane(dCreatePlane(nullptr, 0.0, 0.0, 1.0, 0.0));
  const auto [tilt, isLowest] = GENERATE(table<Real, bool>({{0.0099, false}, {0.0101, true}}));
  CAPTURE(tilt);
  // it is turned by an eighth of a turn about its axis, and leans along x
  dMatrix3 turn;
  dMatrix3 lean;
  dMatrix3 both;
  dRFromAxisAndAngle(turn, 0, 0, 1, 0.25 * std::numbers::pi);
  dRFromAxisAndAngle(lean, 0, 1, 0, tilt);
  dMultiply0_333(both, lean, turn);
  const CGeom cylinder(Cylinder(), CVector3(0, 0, 0.4));
  dGeomSetRotation(cylinder.Get(), both);
  int numLowest = 0;
  for (const dContactGeom& contact : Find(cylinder, plane)) {
    numLowest += std::abs(contact.pos[1]) < 1e-9 && contact.pos[0] > 0.2 ? 1 : 0;
  }
  CHECK(numLowest == (isLowest ? 1 : 0));
}

TEST_CASE("contact spread: of contacts that are as far the first ones are kept", "[dynamics3d]") {
  using TNumbers = std::vector<int>;
  // the corners and the middles of the sides of a square, each twice
  std::vector<CVector3> square;
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(2, 0), std::pair(2, 1),
                             std::pair(2, 2), std::pair(1, 2), std::pair(0, 2), std::pair(0, 1)}) {
    square.insert(square.end(), 2, CVector3(x, y, 0));
  }
  CHECK(Keep(square, 4) == TNumbers{0, 8, 4, 12});
  CHECK(Keep(square, 3) == TNumbers{0, 8, 4});
  CHECK(Keep(square, 2) == TNumbers{0, 8});
  CHECK(Keep(square, 1) == TNumbers{0});
  // of a line, the ends
  std::vector<CVector3> line;
  for (int i = 0; i < 5; ++i) {
    line.emplace_back(i, 0, 0);
  }
  CHECK(Keep(line, 4) == TNumbers{0, 4});
  // as many as may be kept stay as they are
  CHECK(Keep({line.begin(), line.begin() + 4}, 4) == TNumbers{0, 1, 2, 3});
  CHECK(Keep({line.begin(), line.begin() + 3}, 4) == TNumbers{0, 1, 2});
  CHECK(Keep({line.begin(), line.begin() + 3}, 3) == TNumbers{0, 1, 2});
  CHECK(Keep({line.begin(), line.begin() + 4}, 3) == TNumbers{0, 3});
}

}  // namespace contact_places_test
