#include <argos3/plugins/simulator/visualizations/scene/camera_plan.h>
#include <argos3/plugins/simulator/visualizations/scene/camera_xml.h>
#include <argos3/plugins/simulator/visualizations/scene/enclosing_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/appearance.h>
#include <argos3/plugins/simulator/entities/box_entity.h>
#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

namespace camera_plan_test {

using namespace argos;
using Catch::WithinAbs;
using Catch::Matchers::Contains;

namespace {

constexpr double kAspectRatio = 4.0 / 3.0;
constexpr double kRounding = 1e-9;  // m

// an arena of 4 m x 2 m with a crate of 0.2 m at (1, 0.5), and more entities
class CWorld {
 public:
  explicit CWorld(const std::string& more = "", const std::string& center = "0,0,0.5")
      : m_scope(m_simulator) {
    m_document.Parse(R"(<argos-configuration>
      <framework><experiment length="1" ticks_per_second="10" random_seed="1"/></framework>
      <controllers/><arena size="4,2,1" center=")" +
                     center + R"(">
        <floor id="floor" source="loop_functions" pixels_per_meter="5"/>
        <box id="crate" size="0.2,0.2,0.2" movable="false"><body position="1,0.5,0"/></box>)" +
                     more + R"(
      </arena><physics_engines><dynamics2d id="d"/></physics_engines><media><led id="leds"/></media>
      </argos-configuration>)");
    m_simulator.Load(m_document);
  }

  CSpace& GetSpace() { return m_simulator.GetSpace(); }
  void MoveCrate(const CVector3& position) {
    auto& crate = dynamic_cast<CBoxEntity&>(GetSpace().GetEntity("crate"));
    crate.GetEmbodiedEntity().MoveTo(position, CQuaternion(), false, true);
  }

  CCameraPlan Plan(const std::string& attributes, const std::string& children = "") {
    CConfigurationDocument document;
    document.Parse("<offscreen>\n<camera " + attributes + ">" + children + "</camera></offscreen>",
                   "test.argos");
    SCameraSettings settings((CCameraTimeline(MakeDefaultPlacements(SArenaBox()))));
    ReadCameraSettings(document.GetRoot(), GetSpace(), settings);
    return CCameraPlan(settings, kAspectRatio);
  }

 private:
  CConfigurationDocument m_document;
  CSimulator m_simulator;
  CSimulator::CScope m_scope;
};

Eigen::Vector2d Project(const SCameraPlacement& placement, const Eigen::Vector3d& point) {
  return CCamera(placement, kAspectRatio).Project(point);
}

bool IsSeen(const SCameraPlacement& placement, const Eigen::Vector3d& point) {
  const Eigen::Array2d share = Project(placement, point);
  return (share >= 0.0).all() && (share <= 1.0).all();
}

}  // namespace

TEST_CASE("camera plan: a view of the arena shows its ground and what stands across its border",
          "[visualizations][offscreen][camera]") {
  CWorld world;
  world.MoveCrate(CVector3(2.5, 0.0, 0.0));
  const std::string view = GENERATE("oblique", "top", "corner");
  CAPTURE(view);
  CCameraPlan plan = world.Plan("view='" + view + "'");
  const SCameraPlacement placement = plan.ComputeAt(world.GetSpace(), 0);
  CHECK(IsSeen(placement, {-2.0, -1.0, 0.0}));
  CHECK(IsSeen(placement, {-2.0, 1.0, 0.0}));
  CHECK(IsSeen(placement, {2.6, 0.1, 0.2}));
}

TEST_CASE("camera plan: a body across the border of the arena extends the view to its edge",
          "[visualizations][offscreen][camera]") {
  CWorld world;
  world.MoveCrate(CVector3(2.0, 0.0, 0.0));
  CCameraPlan plan = world.Plan("view='top' projection='orthographic' margin='0'");
  // from -2 m to 2.1 m along x; the arena is 2 m deep
  CHECK_THAT(plan.ComputeAt(world.GetSpace(), 0).OrthographicHeight,
             WithinAbs(4.1 / kAspectRatio, kRounding));
}

TEST_CASE("camera plan: a view of the contents leaves out empty ground, and only grows",
          "[visualizations][offscreen][camera]") {
  CWorld world;
  CCameraPlan plan = world.Plan("view='top' projection='orthographic' fit='contents' margin='0'");
  const SCameraPlacement atStart = plan.ComputeAt(world.GetSpace(), 0);
  // the crate is 0.2 m wide
  CHECK_THAT(atStart.OrthographicHeight, WithinAbs(0.2, kRounding));
  CHECK_FALSE(IsSeen(atStart, {-2.0, -1.0, 0.0}));
  world.MoveCrate(CVector3(1.0, -0.5, 0.0));
  const SCameraPlacement later = plan.ComputeAt(world.GetSpace(), 1);
  CHECK_THAT(later.OrthographicHeight, WithinAbs(1.2, kRounding));
  world.MoveCrate(CVector3(1.0, 0.0, 0.0));
  CHECK_THAT(plan.ComputeAt(world.GetSpace(), 2).OrthographicHeight, WithinAbs(1.2, kRounding));
  plan.Reset();
  CHECK_THAT(plan.ComputeAt(world.GetSpace(), 0).OrthographicHeight, WithinAbs(0.2, kRounding));
}

TEST_CASE("camera plan: a view of the contents shows lamps above the arena, wherever it is",
          "[visualizations][offscreen][camera]") {
  // the arena reaches from (8,4) to (12,6)
  const CVector3 place = GENERATE(CVector3(11.5, 5.0, 0.0), CVector3(8.5, 5.0, 0.0));
  CAPTURE(place);
  const auto light = [](const std::string& id, const CVector3& at) {
    return "<light id='" + id + "' position='" + std::to_string(at.GetX()) + ',' +
           std::to_string(at.GetY()) + ",0' color='red' intensity='1' medium='leds'/>";
  };
  // those outside of it stand for the sun
  CWorld world(light("in", place) + light("x", {12.5, 5.0, 0.0}) + light("y", {10.0, 6.5, 0.0}),
               "10,5,0.5");
  world.MoveCrate(CVector3(10.0, 5.0, 0.0));
  CCameraPlan plan = world.Plan("view='top' projection='orthographic' fit='contents' margin='0'");
  // from the far side of the crate, at 0.1 m, to the lamp, at 1.5 m
  CHECK_THAT(plan.ComputeAt(world.GetSpace(), 0).OrthographicHeight,
             WithinAbs(1.6 / kAspectRatio, kRounding));
}

TEST_CASE("camera plan: a camera that follows keeps the entity at the same place of the picture",
          "[visualizations][offscreen][camera]") {
  CWorld world;
  const bool isPlaced = GENERATE(false, true);
  CCameraPlan plan = isPlaced ? world.Plan("follow='crate'",
                                           "<placements><placement index='0' position='0,-3,2' "
                                           "look_at='0,0,0.1'/></placements>")
                              : world.Plan("follow='crate' reach='0.5'");
  const Eigen::Vector2d before =
      Project(plan.ComputeAt(world.GetSpace(), 0), Eigen::Vector3d(1.0, 0.5, 0.0));
  world.MoveCrate(CVector3(-1.5, 0.25, 0.0));
  const SCameraPlacement later = plan.ComputeAt(world.GetSpace(), 1);
  const Eigen::Vector2d after = Project(later, Eigen::Vector3d(-1.5, 0.25, 0.0));
  CHECK_THAT((after - before).norm(), WithinAbs(0.0, kRounding));
  if (isPlaced) {
    CHECK_THAT((later.Position - Eigen::Vector3d(-1.5, -2.75, 2.0)).norm(),
               WithinAbs(0.0, kRounding));
  } else {
    CHECK(IsSeen(later, {-2.0, 0.25, 0.0}));
    CHECK_FALSE(IsSeen(later, {0.0, 0.25, 0.0}));
  }
}

TEST_CASE(
    "camera plan: when the followed entity is removed, the camera stays and a warning tells it",
    "[visualizations][offscreen][camera]") {
  CWorld world;
  CCameraPlan plan = world.Plan("follow='crate'");
  const SCameraPlacement before = plan.ComputeAt(world.GetSpace(), 0);
  world.GetSpace().RemoveEntity(dynamic_cast<CBoxEntity&>(world.GetSpace().GetEntity("crate")));
  TakeLogErr();
  const SCameraPlacement after = plan.ComputeAt(world.GetSpace(), 1);
  CHECK(after.Position == before.Position);
  CHECK_THAT(TakeLogErr(), Contains("[WARNING]") && Contains("\"crate\""));
  plan.ComputeAt(world.GetSpace(), 2);
  CHECK(TakeLogErr().empty());
}

TEST_CASE("camera plan: a camera inside of an entity is reported once",
          "[visualizations][offscreen][camera]") {
  CWorld world;
  CCameraPlan plan = world.Plan(
      "",
      "<placements><placement index='0' position='1.05,0.45,0.1' look_at='0,0,0'/></placements>");
  TakeLogErr();
  plan.ComputeAt(world.GetSpace(), 0);
  plan.ComputeAt(world.GetSpace(), 1);
  const std::string warning = TakeLogErr();
  CHECK_THAT(warning, Contains("[WARNING]") && Contains("inside of \"crate\"") &&
                          Contains("(1.05,0.45,0.1)"));
  CHECK(warning.find("inside") == warning.rfind("inside"));
}

TEST_CASE("camera plan: inside of an entity means within its visible shape",
          "[visualizations][offscreen][camera]") {
  CWorld world(R"(<cylinder id="tin" radius="0.1" height="0.3" movable="false">
      <body position="-1,-0.5,0"/></cylinder>)");
  const CEntity* const crate = &world.GetSpace().GetEntity("crate");
  const CEntity* const tin = &world.GetSpace().GetEntity("tin");
  const auto find = [&world](double x, double y, double z) {
    return FindEnclosingEntity(world.GetSpace(), Eigen::Vector3d(x, y, z));
  };
  // the crate, of 0.2 m, is centred on (1, 0.5)
  for (const double side : {-1.0, 1.0}) {
    CAPTURE(side);
    CHECK(find(1.0 + side * 0.099, 0.5 + 0.099, 0.1) == crate);
    CHECK(find(1.0 + side * 0.101, 0.5, 0.1) == nullptr);
    CHECK(find(1.0, 0.5 + side * 0.099, 0.1) == crate);
    CHECK(find(1.0, 0.5 + side * 0.101, 0.1) == nullptr);
    // its middle is at 0.1 m
    CHECK(find(1.0, 0.5, 0.1 + side * 0.099) == crate);
    CHECK(find(1.0, 0.5, 0.1 + side * 0.101) == nullptr);
  }
  // the tin has a radius of 0.1 m: its edge along the diagonal is at 0.0707 m
  CHECK(find(-1.0 + 0.099, -0.5, 0.1) == tin);
  CHECK(find(-1.0 + 0.101, -0.5, 0.1) == nullptr);
  CHECK(find(-1.0 + 0.0700, -0.5 - 0.0700, 0.1) == tin);
  CHECK(find(-1.0 + 0.0714, -0.5 - 0.0714, 0.1) == nullptr);
  CHECK(find(-1.0, -0.5, 0.299) == tin);
  CHECK(find(-1.0, -0.5, 0.301) == nullptr);
  CHECK(find(-1.0, -0.5, -0.001) == nullptr);
}

TEST_CASE("camera plan: inside of a cone or a sphere", "[visualizations][offscreen][camera]") {
  class CUsersEntity : public CComposableEntity {
   public:
    CUsersEntity() : CComposableEntity(nullptr, "mine") {
      AddComponent(
          *new CEmbodiedEntity(this, "body", CVector3(3.0, 2.0, 0.5), CQuaternion(), false));
      SVisualPart part;
      part.Size = CVector3(0.2, 0.2, 0.4);
      part.Kind = SVisualPart::EKind::Cone;
      m_appearance.Parts.push_back(part);
      part.Kind = SVisualPart::EKind::Sphere;
      part.Position = CVector3(0.0, 1.0, 0.0);
      m_appearance.Parts.push_back(part);
      part.Kind = SVisualPart::EKind::Ring;
      part.Position = CVector3(0.0, -1.0, 0.0);
      m_appearance.Parts.push_back(part);
      // one sees through the last one
      part.Kind = SVisualPart::EKind::Box;
      part.Color.SetAlpha(254);
      m_appearance.Parts.push_back(part);
    }
    const SAppearance* GetAppearance() const override { return &m_appearance; }

   private:
    SAppearance m_appearance;
  };
  CWorld world;
  CUsersEntity entity;
  world.GetSpace().GetRootEntityVector().push_back(&entity);
  const auto isInside = [&](double x, double y, double z) {
    return FindEnclosingEntity(world.GetSpace(), Eigen::Vector3d(3.0 + x, 2.0 + y, 0.5 + z)) ==
           &entity;
  };
  // half as wide at half of its height
  for (const auto& [height, radius] : {std::pair(0.001, 0.09975), {0.2, 0.05}, {0.396, 0.001}}) {
    CAPTURE(height);
    CHECK(isInside(0.99 * radius, 0.0, height));
    CHECK_FALSE(isInside(1.01 * radius, 0.0, height));
    CHECK(isInside(0.7 * radius, -0.7 * radius, height));
    CHECK_FALSE(isInside(0.72 * radius, -0.72 * radius, height));
  }
  CHECK_FALSE(isInside(0.0, 0.0, -0.001));
  CHECK_FALSE(isInside(0.0, 0.0, 0.401));
  CHECK(isInside(0.0, 1.0, 0.199));
  CHECK(isInside(0.0, 1.0, -0.199));
  CHECK_FALSE(isInside(0.0, 1.0, 0.201));
  CHECK(isInside(0.07, 1.07, 0.0));
  CHECK_FALSE(isInside(0.072, 1.072, 0.0));
  CHECK_FALSE(isInside(0.0, -1.0, 0.1));
  world.GetSpace().GetRootEntityVector().pop_back();
}

TEST_CASE("camera plan: errors name file, line, attribute and what would be right",
          "[visualizations][offscreen][camera]") {
  CWorld world;
  const std::string placed =
      "<placements><placement index='0' position='0,-3,2' look_at='0,0,0'/></placements>";
  CHECK_THROWS_WITH(world.Plan("follow='crane'"),
                    Contains("test.argos:2: <camera>: attribute \"follow\": there is no entity "
                             "\"crane\"") &&
                        Contains("did you mean \"crate\""));
  CHECK_THROWS_WITH(world.Plan("follow='floor'"), Contains("this entity has no position"));
  CHECK_THROWS_WITH(world.Plan("view='tpo'"),
                    Contains("test.argos:2:") && Contains("did you mean \"top\""));
  CHECK_THROWS_WITH(world.Plan("fit='content'"), Contains("did you mean \"contents\""));
  CHECK_THROWS_WITH(world.Plan("projection='isometric'"), Contains("\"orthographic\""));
  CHECK_THROWS_WITH(world.Plan("margin='-1'"), Contains("must not be negative"));
  CHECK_THROWS_WITH(world.Plan("margin='nan'"), Contains("test.argos:2:"));
  CHECK_THROWS_WITH(world.Plan("reach='2'"), Contains("needs \"follow\""));
  CHECK_THROWS_WITH(world.Plan("follow='crate' reach='0'"), Contains("must be positive"));
  CHECK_THROWS_WITH(world.Plan("view='top'", placed), Contains("also given as a <placement>"));
  CHECK_THROWS_WITH(
      world.Plan("view='top' projection='orthographic'",
                 "<placements><placement index='1' position='0,-3,2' look_at='0,0,0'/></placements>"
                 "<timeline><keyframe placement='0' step='0'/><interpolate/>"
                 "<keyframe placement='1' step='10'/></timeline>"),
      Contains("test.argos:2:") && Contains("only one is orthographic"));
}

}  // namespace camera_plan_test
