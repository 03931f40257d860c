#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/plugins/simulator/entities/box_entity.h>
#include <argos3/plugins/simulator/entities/cylinder_entity.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <limits>

namespace box_cylinder_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

SRobotExperiment With(const std::string& arena) {
  SRobotExperiment experiment;
  experiment.Arena = arena;
  return experiment;
}

const SBodyDescription& DescriptionOf(CPassiveBodyEntity& entity) {
  return *entity.GetEmbodiedEntity().GetBodyDescription();
}

}  // namespace

TEST_CASE("box: its description follows the file", "[entities]") {
  CRobotWorld world(
      With("<box id=\"wall\" size=\"4, 0.1 ,0.5\" movable=\"false\"><body position=\"1,2,0.3\" "
           "orientation=\"90,0,0\"/></box>"
           "<box id=\"crate\" size=\"0.3,0.2,0.1\" movable=\"true\" mass=\"2.5\"><body "
           "position=\"3,3,0\"/></box>"));
  auto& wall = world.Get<CBoxEntity>("wall");
  CHECK(wall.GetSize() == CVector3(4.0, 0.1, 0.5));
  CHECK_FALSE(wall.GetEmbodiedEntity().IsMovable());
  CHECK(wall.GetEmbodiedEntity().GetOriginAnchor().Position == CVector3(1.0, 2.0, 0.3));
  const SBodyDescription& fixed = DescriptionOf(wall);
  REQUIRE(fixed.Shapes.size() == 1);
  CHECK(fixed.Shapes[0].Kind == SShapeDescription::EKind::Box);
  CHECK(fixed.Shapes[0].Size == CVector3(4.0, 0.1, 0.5));
  CHECK_FALSE(fixed.GroundFriction.has_value());
  CHECK_FALSE(fixed.Drive.has_value());
  CHECK(wall.GetMass() == 0.0);

  auto& crate = world.Get<CBoxEntity>("crate");
  CHECK(crate.GetEmbodiedEntity().IsMovable());
  CHECK(crate.GetMass() == 2.5);
  CHECK(DescriptionOf(crate).Mass == 2.5);
  REQUIRE(DescriptionOf(crate).GroundFriction.has_value());
  CHECK(DescriptionOf(crate).GroundFriction->Class == SGroundFrictionDescription::EClass::Box);
}

TEST_CASE("cylinder: its description follows the file", "[entities]") {
  CRobotWorld world(
      With("<cylinder id=\"c\" radius=\"0.2\" height=\"0.4\" movable=\"true\" "
           "mass=\"3\"><body position=\"1,1,0\"/></cylinder>"));
  auto& cylinder = world.Get<CCylinderEntity>("c");
  CHECK(cylinder.GetRadius() == 0.2);
  CHECK(cylinder.GetHeight() == 0.4);
  const SBodyDescription& body = DescriptionOf(cylinder);
  REQUIRE(body.Shapes.size() == 1);
  CHECK(body.Shapes[0].Kind == SShapeDescription::EKind::Cylinder);
  CHECK(body.Shapes[0].Radius == 0.2);
  CHECK(body.Shapes[0].Size.GetZ() == 0.4);
  CHECK(body.Mass == 3.0);
  REQUIRE(body.GroundFriction.has_value());
  CHECK(body.GroundFriction->Class == SGroundFrictionDescription::EClass::Cylinder);
}

TEST_CASE("box and cylinder: invalid values are refused with place and reason",
          "[entities][errors]") {
  struct SCase {
    const char* Element;
    const char* Reason;
  };
  const SCase c = GENERATE(
      SCase{"<box id=\"b\" size=\"0,1,1\" movable=\"false\"><body/></box>", "size"},
      SCase{"<box id=\"b\" size=\"1,-1,1\" movable=\"false\"><body/></box>", "component y"},
      SCase{"<box id=\"b\" size=\"1,1\" movable=\"false\"><body/></box>", "size"},
      SCase{"<box id=\"b\" size=\"1,1,1\"><body/></box>", "movable"},
      SCase{"<box id=\"b\" size=\"1,1,1\" movable=\"1\"><body/></box>", "movable"},
      SCase{"<box id=\"b\" size=\"1,1,1\" movable=\"true\"><body/></box>", "mass"},
      SCase{"<box id=\"b\" size=\"1,1,1\" movable=\"true\" mass=\"0\"><body/></box>", "mass"},
      SCase{"<box id=\"b\" size=\"1,1,1\" movable=\"true\" mass=\"-2\"><body/></box>", "got -2"},
      SCase{"<box id=\"b\" size=\"1,1,1\" movable=\"false\"/>", "body"},
      SCase{"<box size=\"1,1,1\" movable=\"false\"><body/></box>", "id"},
      SCase{"<cylinder id=\"b\" radius=\"0\" height=\"1\" movable=\"false\"><body/></cylinder>",
            "radius"},
      SCase{"<cylinder id=\"b\" radius=\"1\" height=\"-1\" movable=\"false\"><body/></cylinder>",
            "height"},
      SCase{"<cylinder id=\"b\" radius=\"1\" height=\"1\" movable=\"true\"><body/></cylinder>",
            "mass"});
  CAPTURE(c.Element);
  CHECK_THAT(LoadError(With(c.Element)), Contains(c.Reason) && Contains("test.argos:"));
}

TEST_CASE("box and cylinder: constructors refuse sizes and masses that are not positive",
          "[entities][errors]") {
  const CRobotWorld world(With(""));
  const Real bad = GENERATE(0.0, -1.0, std::numeric_limits<Real>::quiet_NaN(),
                            std::numeric_limits<Real>::infinity());
  CAPTURE(bad);
  const CVector3 p;
  const CQuaternion q;
  CHECK_THROWS_WITH(CBoxEntity("b", p, q, false, CVector3(1.0, bad, 1.0)),
                    Contains("box \"b\"") && Contains("size"));
  CHECK_THROWS_WITH(CBoxEntity("b", p, q, true, CVector3(1.0, 1.0, 1.0), bad), Contains("mass"));
  CHECK_THROWS_WITH(CCylinderEntity("c", p, q, false, bad, 1.0),
                    Contains("cylinder \"c\"") && Contains("radius"));
  CHECK_THROWS_WITH(CCylinderEntity("c", p, q, false, 1.0, bad), Contains("height"));
  CHECK_THROWS_WITH(CCylinderEntity("c", p, q, true, 1.0, 1.0, bad), Contains("mass"));
  // the mass of immovable bodies is ignored
  CHECK_NOTHROW(CBoxEntity("b", p, q, false, CVector3(1.0, 1.0, 1.0), bad));
}

TEST_CASE("box: a box resized while in an engine is found at its new size", "[entities]") {
  CRobotWorld world(
      With("<box id=\"b\" size=\"1,1,1\" movable=\"false\"><body position=\"2,0,0\"/></box>"));
  auto& box = world.Get<CBoxEntity>("b");
  const CRay3 ray(CVector3(0.0, 0.0, 0.5), CVector3(2.0, 0.0, 0.5));
  SEmbodiedEntityIntersectionItem hit;
  REQUIRE(world.GetSpace().GetBodyIndex().FindClosestHit(hit, ray));
  CHECK(hit.TOnRay == 0.75);
  box.Resize(CVector3(3.0, 1.0, 1.0));
  CHECK(box.GetEmbodiedEntity().GetPhysicsModelsNum() == 1);
  REQUIRE(world.GetSpace().GetBodyIndex().FindClosestHit(hit, ray));
  CHECK(hit.TOnRay == 0.25);
  CHECK(hit.IntersectedEntity == &box.GetEmbodiedEntity());
  CHECK_THROWS_AS(box.Resize(CVector3(0.0, 1.0, 1.0)), CARGoSException);
  CHECK(box.GetSize() == CVector3(3.0, 1.0, 1.0));
  world.Step();
}

TEST_CASE("cylinder: changes of mass and size update the description", "[entities]") {
  CRobotWorld world(
      With("<cylinder id=\"c\" radius=\"0.2\" height=\"0.4\" movable=\"true\" "
           "mass=\"3\"><body position=\"1,1,0\"/></cylinder>"));
  auto& cylinder = world.Get<CCylinderEntity>("c");
  cylinder.SetMass(5.0);
  CHECK(DescriptionOf(cylinder).Mass == 5.0);
  cylinder.Resize(0.1, 0.7);
  CHECK(DescriptionOf(cylinder).Shapes[0].Radius == 0.1);
  CHECK(DescriptionOf(cylinder).Shapes[0].Size.GetZ() == 0.7);
  CHECK_THROWS_AS(cylinder.SetMass(0.0), CARGoSException);
  CHECK(cylinder.GetMass() == 5.0);
  world.Step();
}

TEST_CASE("box and cylinder: are drawn with their shapes", "[entities]") {
  CRobotWorld world(
      With("<box id=\"b\" size=\"1,2,3\" movable=\"false\"><body/></box>"
           "<cylinder id=\"c\" radius=\"0.2\" height=\"0.4\" movable=\"true\" mass=\"3\"><body "
           "position=\"3,3,0\"/></cylinder>"));
  const SAppearance& box = *world.Get<CBoxEntity>("b").GetAppearance();
  REQUIRE(box.Parts.size() == 1);
  CHECK(box.Parts[0].Kind == SVisualPart::EKind::Box);
  CHECK(box.Parts[0].Size == CVector3(1.0, 2.0, 3.0));
  const SAppearance& cylinder = *world.Get<CCylinderEntity>("c").GetAppearance();
  REQUIRE(cylinder.Parts.size() == 1);
  CHECK(cylinder.Parts[0].Kind == SVisualPart::EKind::Cylinder);
  CHECK(cylinder.Parts[0].Size == CVector3(0.4, 0.4, 0.4));
  // movable and immovable bodies have different colours
  CHECK(box.Parts[0].Color != cylinder.Parts[0].Color);
}

}  // namespace box_cylinder_test
