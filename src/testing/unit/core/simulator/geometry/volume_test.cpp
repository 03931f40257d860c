#include <argos3/core/simulator/geometry/volume.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/utility/math/angles.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace volume_test {

using namespace argos;
using Catch::Contains;

namespace {

// two 2 m squares side by side, with a common border on the line from (0,-1) to (0,1)
constexpr char kWest[] =
    "<boundaries><sides><vertex point=\"-2,-1\"/><vertex point=\"0,-1\"/>"
    "<vertex point=\"0,1\"/><vertex point=\"-2,1\"/></sides></boundaries>";
constexpr char kSlab[] = "<boundaries><top height=\"1\"/><bottom height=\"-0.5\"/></boundaries>";

void Read(SVolume& volume, const std::string& xml) {
  CConfigurationDocument document;
  document.Parse(xml, "region.xml");
  volume.Init(document.GetRoot());
}

std::string ErrorOf(const std::string& xml) {
  SVolume volume;
  try {
    Read(volume, xml);
  } catch (const CARGoSException& ex) {
    return ex.what();
  }
  return "";
}

std::string Sides(const std::vector<std::string>& vertices) {
  std::string xml = "<boundaries><sides>";
  for (const std::string& vertex : vertices) {
    xml += "<vertex point=\"" + vertex + "\"/>";
  }
  return xml + "</sides></boundaries>";
}

}  // namespace

TEST_CASE("volume: without faces it contains the whole space", "[core][volume]") {
  const SVolume volume;
  CHECK_FALSE(volume.IsActive());
  CHECK(volume.Contains(CVector3(1e6, -1e6, 1e6)));
}

TEST_CASE("volume: top and bottom limit the height and belong to the region", "[core][volume]") {
  SVolume volume;
  Read(volume, kSlab);
  REQUIRE(volume.IsActive());
  REQUIRE(volume.TopFace != nullptr);
  REQUIRE(volume.BottomFace != nullptr);
  CHECK(volume.TopFace->Height == 1.0);
  CHECK(volume.BottomFace->Height == -0.5);
  CHECK(volume.Contains(CVector3(1e6, 1e6, 1.0)));
  CHECK(volume.Contains(CVector3(0.0, 0.0, -0.5)));
  CHECK_FALSE(volume.Contains(CVector3(0.0, 0.0, std::nextafter(1.0, 2.0))));
  CHECK_FALSE(volume.Contains(CVector3(0.0, 0.0, std::nextafter(-0.5, -1.0))));
}

TEST_CASE("volume: sides limit the plane, the border included", "[core][volume]") {
  SVolume volume;
  Read(volume, kWest);
  REQUIRE(volume.SideFaces.size() == 4);
  CHECK(volume.TopFace == nullptr);
  CHECK(volume.SideFaces[1]->BaseSegment.GetStart() == CVector2(0.0, -1.0));
  CHECK(volume.SideFaces[3]->BaseSegment.GetEnd() == CVector2(-2.0, -1.0));
  CHECK(volume.Contains(CVector3(-1.0, 0.0, 0.0)));
  CHECK(volume.Contains(CVector3(0.0, 0.5, 7.0)));
  CHECK(volume.Contains(CVector3(-2.0, -1.0, 0.0)));
  CHECK_FALSE(volume.Contains(CVector3(1e-12, 0.5, 0.0)));
  CHECK_FALSE(volume.Contains(CVector3(-1.0, 1.0 + 1e-12, 0.0)));
}

TEST_CASE("volume: a point on a slanted common border belongs to one of the regions",
          "[core][volume]") {
  SVolume left;
  SVolume right;
  Read(left, Sides({"-5,-5", "0.1,-0.3", "0.7,5.9"}));
  Read(right, Sides({"0.1,-0.3", "9,0", "0.7,5.9"}));
  for (int i = 0; i <= 1000; ++i) {
    const Real t = i / 1000.0;
    CAPTURE(t);
    const CVector3 onBorder(0.1 + t * 0.6, -0.3 + t * 6.2, 0.0);
    CHECK((left.Contains(onBorder) || right.Contains(onBorder)));
  }
}

TEST_CASE("volume: NaN is outside every limited region", "[core][volume]") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  SVolume sides;
  Read(sides, kWest);
  CHECK_FALSE(sides.Contains(CVector3(nan, 0.0, 0.0)));
  SVolume slab;
  Read(slab, kSlab);
  CHECK_FALSE(slab.Contains(CVector3(0.0, 0.0, nan)));
}

TEST_CASE("volume: a triangle may repeat its first vertex", "[core][volume]") {
  SVolume volume;
  Read(volume, Sides({"0,0", "1,0", "0,1", "0,0"}));
  CHECK(volume.SideFaces.size() == 3);
  CHECK(volume.Contains(CVector3(0.5, 0.5, 0.0)));
  CHECK_FALSE(volume.Contains(CVector3(0.5, 0.5 + 1e-9, 0.0)));
}

TEST_CASE("volume: vertices in the middle of a side are accepted", "[core][volume]") {
  SVolume volume;
  Read(volume, Sides({"0,0", "0.1,0.1", "0.3,0.3", "0,1"}));
  CHECK(volume.Contains(CVector3(0.1, 0.5, 0.0)));
}

TEST_CASE("volume: invalid polygons are refused with their coordinates", "[core][volume]") {
  CHECK_THAT(ErrorOf(Sides({"0,0", "1,0"})), Contains("at least 3"));
  CHECK_THAT(ErrorOf(Sides({"0,0", "0,1", "1,0"})), Contains("clockwise"));
  CHECK_THAT(ErrorOf(Sides({"0,0", "2,0", "0.5,0.5", "0,2"})),
             Contains("not convex") && Contains("0.5,0.5"));
  CHECK_THAT(ErrorOf(Sides({"0,0", "1,0", "1,0", "0,1"})), Contains("twice in a row"));
  CHECK_THAT(ErrorOf(Sides({"0,0", "1,1", "2,2"})), Contains("one line"));
  // a pentagram turns left at every vertex
  CHECK_THAT(ErrorOf(Sides({"1,0", "-0.8,0.6", "0.3,-0.95", "0.3,0.95", "-0.8,-0.6"})),
             Contains("crosses itself"));
  // a square whose last two corners are swapped: the diagonals cross in its centre
  CHECK_THAT(ErrorOf(Sides({"0,0", "2,0", "0,2", "2,2"})),
             Contains("crosses itself") && Contains("from \"2,0\" to \"0,2\"") &&
                 Contains("from \"2,2\" to \"0,0\"") && Contains("meet at \"1,1\""));
  // a triangle whose boundary is traversed twice
  CHECK_THAT(ErrorOf(Sides({"0,0", "1,0", "0,1", "0,0", "1,0", "0,1"})),
             Contains("\"0,0\" is given twice"));
  CHECK_THAT(ErrorOf(Sides({"0,0", "1,x", "0,1"})), Contains("region.xml:1") && Contains("1,x"));
}

TEST_CASE("volume: a bottom above the top is refused", "[core][volume]") {
  CHECK_THAT(ErrorOf("<boundaries><top height=\"0\"/><bottom height=\"1\"/></boundaries>"),
             Contains("above the top"));
  CHECK_THAT(ErrorOf("<boundaries><top height=\"1\"/><bottom height=\"1\"/></boundaries>"),
             Contains("not below the top"));
}

TEST_CASE("volume: a face is open, a wall or a gate", "[core][volume]") {
  SVolume volume;
  Read(volume,
       "<boundaries><top height=\"1\" gate=\"up\"/><bottom height=\"0\" wall=\"true\"/><sides>"
       "<vertex point=\"0,0\" wall=\"true\"/><vertex point=\"2,0\" gate=\"e\"/><vertex "
       "point=\"2,1\"/>"
       "<vertex point=\"0,1\" wall=\"false\"/></sides></boundaries>");
  CHECK(volume.HasWalls());
  CHECK(volume.TopFace->Gate == "up");
  CHECK(volume.BottomFace->IsWall);
  CHECK((volume.SideFaces[0]->IsWall && volume.SideFaces[0]->Gate.empty()));
  CHECK((!volume.SideFaces[1]->IsWall && volume.SideFaces[1]->Gate == "e"));
  CHECK((!volume.SideFaces[2]->IsWall && !volume.SideFaces[3]->IsWall));
  // the exit is the nearest face that the point lies beyond
  CHECK(volume.FindExit(CVector3(1, 0.5, 0.5)) == nullptr);
  CHECK(volume.FindExit(CVector3(2.1, 0.5, 0.5)) == volume.SideFaces[1]);
  CHECK(volume.FindExit(CVector3(2.2, 1.1, 0.5)) == volume.SideFaces[1]);
  CHECK(volume.FindExit(CVector3(1, 0.5, 1.5)) == volume.TopFace);
  CHECK(volume.FindExit(CVector3(1, -0.1, -0.5)) == volume.SideFaces[0]);
  CHECK_THAT(ErrorOf("<boundaries><top height=\"1\" gate=\"up\" wall=\"true\"/></boundaries>"),
             Contains("<top>") && Contains("a wall or a gate, not both"));
}

TEST_CASE("volume: collinear sides are distinguished by position", "[core][volume]") {
  // a wall with a door in its middle
  SVolume volume;
  Read(volume,
       "<boundaries><sides><vertex point=\"0,0\"/><vertex point=\"2,0\" wall=\"true\"/>"
       "<vertex point=\"2,1\" gate=\"door\"/><vertex point=\"2,2\" wall=\"true\"/>"
       "<vertex point=\"2,3\"/><vertex point=\"0,3\"/></sides></boundaries>");
  CHECK(volume.FindExit(CVector3(2.01, 0.9, 0)) == volume.SideFaces[1]);
  CHECK(volume.FindExit(CVector3(2.01, 1.1, 0)) == volume.SideFaces[2]);
  CHECK(volume.FindExit(CVector3(2.01, 2.1, 0)) == volume.SideFaces[3]);
  const std::vector<SWallSlab> walls = volume.DescribeWalls();
  REQUIRE(walls.size() == 2);
  // wall slabs are centred outside the region and on their side
  CHECK_THAT(walls[0].Position.GetX(), Catch::WithinAbs(2.05, 1e-12));
  CHECK_THAT(walls[0].Position.GetY(), Catch::WithinAbs(0.5, 1e-12));
}

TEST_CASE("volume: distances are measured to the nearest point of the region", "[core][volume]") {
  SVolume volume;
  Read(
      volume,
      "<boundaries><top height=\"1\"/><bottom height=\"0\"/><sides><vertex point=\"0,0\"/>"
      "<vertex point=\"2,0\"/><vertex point=\"2,1\"/><vertex point=\"0,1\"/></sides></boundaries>");
  CHECK(volume.ComputeDistance(CVector3(1, 0.5, 0.5)) == 0.0);
  CHECK_THAT(volume.ComputeDistance(CVector3(5, 0.5, 0.5)), Catch::WithinAbs(3.0, 1e-12));
  CHECK_THAT(volume.ComputeDistance(CVector3(5, 5, 1)), Catch::WithinAbs(5.0, 1e-12));
  CHECK_THAT(volume.ComputeDistance(CVector3(1, 4, 5)), Catch::WithinAbs(5.0, 1e-12));
}

TEST_CASE("volume: a refused description leaves the region unchanged", "[core][volume]") {
  SVolume volume;
  Read(volume, kSlab);
  CHECK_THROWS_AS(Read(volume, Sides({"0,0", "1,0"})), CARGoSException);
  CHECK(volume.TopFace != nullptr);
  CHECK(volume.SideFaces.empty());
}

TEST_CASE("volume: walls hold a body inside by its radius and height", "[core][volume]") {
  SVolume volume;
  // the northern half of the western side is a wall
  Read(volume,
       "<boundaries><sides><vertex point=\"-2,-2\"/><vertex point=\"2,-2\"/>"
       "<vertex point=\"2,2\"/><vertex point=\"-2,2\" wall=\"true\"/><vertex point=\"-2,0\"/>"
       "</sides><top height=\"3\" wall=\"true\"/><bottom height=\"1\" wall=\"true\"/>"
       "</boundaries>");
  struct SCase {
    CVector3 Position, Velocity, HeldPosition, HeldVelocity;
  };
  const SCase held = GENERATE(
      // the ground and the ceiling, and a velocity away from them, which remains
      SCase{{-1.0, -1.0, 0.8}, {0.1, 0.0, -1.0}, {-1.0, -1.0, 1.0}, {0.1, 0.0, 0.0}},
      SCase{{-1.0, -1.0, 0.8}, {0.1, 0.0, 1.0}, {-1.0, -1.0, 1.0}, {0.1, 0.0, 1.0}},
      SCase{{-1.0, -1.0, 2.7}, {0.0, 0.1, 1.0}, {-1.0, -1.0, 2.5}, {0.0, 0.1, 0.0}},
      SCase{{-1.0, -1.0, 2.7}, {0.0, 0.1, -1.0}, {-1.0, -1.0, 2.5}, {0.0, 0.1, -1.0}},
      // a wall that is touched, and one that was passed
      SCase{{-1.9, 1.0, 2.0}, {-1.0, 1.0, 0.0}, {-1.75, 1.0, 2.0}, {0.0, 1.0, 0.0}},
      SCase{{-2.1, 1.0, 2.0}, {1.0, 1.0, 0.0}, {-1.75, 1.0, 2.0}, {1.0, 1.0, 0.0}},
      // the end of the wall
      SCase{{-1.94, -0.08, 2.0}, {-3.0, 4.0, 1.0}, {-1.85, -0.2, 2.0}, {0.0, 0.0, 1.0}});
  CAPTURE(held.Position, held.Velocity);
  CVector3 position = held.Position, velocity = held.Velocity;
  CHECK(volume.HoldInside(position, velocity, 0.25, 0.5));
  CHECK(Distance(position, held.HeldPosition) <= 1e-12);
  CHECK(Distance(velocity, held.HeldVelocity) <= 1e-12);
}

TEST_CASE("volume: only walls hold a body", "[core][volume]") {
  SVolume volume;
  Read(volume,
       "<boundaries><sides><vertex point=\"-2,-2\"/><vertex point=\"2,-2\"/>"
       "<vertex point=\"2,2\"/><vertex point=\"-2,2\" wall=\"true\"/><vertex point=\"-2,0\"/>"
       "</sides><top height=\"3\"/><bottom height=\"1\"/></boundaries>");
  // through the top, the bottom, a side, behind the line of the wall, and near the wall
  const CVector3 place =
      GENERATE(CVector3(0.0, 0.0, 2.9), CVector3(0.0, 0.0, 0.5), CVector3(1.9, 0.0, 2.0),
               CVector3(-2.1, -0.1, 2.0), CVector3(-1.749, 1.0, 2.0));
  CAPTURE(place);
  CVector3 position = place, velocity(-1.0, 1.0, 1.0);
  CHECK_FALSE(volume.HoldInside(position, velocity, 0.25, 0.5));
  CHECK(position == place);
  CHECK(velocity == CVector3(-1.0, 1.0, 1.0));
}

TEST_CASE("volume: it is touched by bodies within reach of it", "[core][volume]") {
  // of 0.2 m x 0.4 m x 0.6 m
  SBodyDescription body;
  body.Shapes = {SShapeDescription::Box(CVector3(0.2, 0.4, 0.6))};
  const CQuaternion upright;
  const auto touches = [&](const SVolume& volume, const CVector3& place, const CQuaternion& turn) {
    return volume.IsTouchedBy(body, place, turn, 0.1);
  };
  SVolume slab;
  Read(slab, kSlab);  // from -0.5 m to 1 m
  CHECK(touches(slab, CVector3(9, 9, 1.09), upright));
  CHECK_FALSE(touches(slab, CVector3(9, 9, 1.11), upright));
  CHECK(touches(slab, CVector3(9, 9, -1.19), upright));
  CHECK_FALSE(touches(slab, CVector3(9, 9, -1.21), upright));
  SVolume west;
  Read(west, kWest);  // from (-2,-1) to (0,1)
  CHECK(touches(west, CVector3(0.19, 0.0, 9.0), upright));
  CHECK_FALSE(touches(west, CVector3(0.21, 0.0, 9.0), upright));
  CHECK(touches(west, CVector3(-1.0, 1.29, 9.0), upright));
  CHECK_FALSE(touches(west, CVector3(-1.0, 1.31, 9.0), upright));
  // it lies on its side: from its origin it reaches 0.6 m along x
  const CQuaternion tilted(CRadians::PI_OVER_TWO, CVector3(0.0, -1.0, 0.0));
  CHECK(touches(west, CVector3(0.69, 0.0, 9.0), tilted));
  CHECK_FALSE(touches(west, CVector3(5.0, 0.0, 9.0), tilted));
  CHECK(touches(SVolume(), CVector3(1e6, 0.0, -1e6), tilted));
}

}  // namespace volume_test
