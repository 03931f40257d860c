#include <argos3/plugins/simulator/visualizations/scene/scene_builder.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/core/simulator/visualization/appearance.h>
#include <argos3/plugins/simulator/entities/box_entity.h>
#include <argos3/plugins/simulator/entities/cylinder_entity.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/light_entity.h>
#include <argos3/core/simulator/visualization/floor_samples.h>
#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>

namespace scene_builder_test {

using namespace argos;
using Catch::Contains;
using Catch::WithinAbs;

namespace {

// tolerance of scene coordinates in single precision
constexpr double kFloatRounding = 1e-6;

// an experiment without physics: bodies keep the poses that the test sets
class CWorld {
 public:
  CWorld() : m_scope(m_simulator) {
    m_document.Parse(R"(<argos-configuration>
      <framework><experiment length="1" ticks_per_second="10" random_seed="1"/></framework>
      <controllers/><arena size="4,2,1" center="1,0,0.5"/><physics_engines/><media/>
      </argos-configuration>)");
    m_simulator.Load(m_document);
  }

  CSimulator& GetSimulator() { return m_simulator; }
  CSpace& GetSpace() { return m_simulator.GetSpace(); }

  template <typename ENTITY>
  ENTITY& Add(ENTITY* entity) {
    GetSpace().AddEntity(*entity);
    return *entity;
  }

  SScene& Build(bool showRays = true) {
    (showRays ? m_builder : m_builderWithoutRays).Build(GetSpace(), m_scene);
    return m_scene;
  }

 private:
  CConfigurationDocument m_document;
  CSimulator m_simulator;
  CSimulator::CScope m_scope;
  SScene m_scene;
  CSceneBuilder m_builder{true};
  CSceneBuilder m_builderWithoutRays{false};
};

void CheckRow(const std::array<float, 4>& row, const std::array<double, 4>& expected) {
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK_THAT(static_cast<double>(row[i]), WithinAbs(expected[i], kFloatRounding));
  }
}

// has a place but no appearance
class CUnseenEntity : public CPositionalEntity {
 public:
  ENABLE_VTABLE();
  explicit CUnseenEntity(const std::string& id)
      : CPositionalEntity(nullptr, id, CVector3(), CQuaternion()) {}
  std::string GetTypeDescription() const override { return "unseen"; }
};

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CUnseenEntity)

}  // namespace

TEST_CASE("scene builder: a type of entities without an appearance is named once",
          "[visualizations][offscreen][scene]") {
  CWorld world;
  world.Add(new CFloorEntity("floor", 10));
  world.Add(new CUnseenEntity("ghost"));
  world.Add(new CUnseenEntity("spirit"));
  CSceneBuilder builder(true);
  SScene scene;
  TakeLogErr();
  builder.Build(world.GetSpace(), scene);
  const std::string warning = TakeLogErr();
  CHECK_THAT(warning, Contains("[WARNING]") && Contains("\"ghost\"") && Contains("<unseen>") &&
                          !Contains("spirit") && !Contains("floor"));
  builder.Build(world.GetSpace(), scene);
  CHECK(TakeLogErr().empty());
}

TEST_CASE("scene builder: the arena follows the file", "[visualizations][offscreen][scene]") {
  CWorld world;
  const SScene& scene = world.Build();
  CHECK(scene.ArenaMin == Eigen::Vector2d(-1.0, -1.0));
  CHECK(scene.ArenaMax == Eigen::Vector2d(3.0, 1.0));
  CHECK(scene.Floor.Width == 0);
}

TEST_CASE("scene builder: a box stands on its base, turned and scaled",
          "[visualizations][offscreen][scene]") {
  CWorld world;
  // a quarter turn about z: the box's x axis is the world's y axis
  world.Add(new CBoxEntity("box", CVector3(0.5, -0.3, 0.2),
                           CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z), false,
                           CVector3(0.4, 0.2, 0.1)));
  SScene& scene = world.Build();
  REQUIRE(scene.OfKind(EMeshKind::Box).size() == 1);
  const SMeshInstance& box = scene.OfKind(EMeshKind::Box).front();
  CheckRow(box.ToWorld[0], {0.0, -0.2, 0.0, 0.5});
  CheckRow(box.ToWorld[1], {0.4, 0.0, 0.0, -0.3});
  CheckRow(box.ToWorld[2], {0.0, 0.0, 0.1, 0.2});
  // a box 0.2 m above the ground has no contact shadow
  CHECK(scene.ContactShadows.empty());
}

TEST_CASE("scene builder: bodies on the ground have contact shadows",
          "[visualizations][offscreen][scene]") {
  CWorld world;
  world.Add(
      new CCylinderEntity("cylinder", CVector3(0.5, 0.25, 0.0), CQuaternion(), false, 0.15, 0.3));
  SScene& scene = world.Build();
  CHECK(scene.OfKind(EMeshKind::Cylinder).size() == 1);
  REQUIRE(scene.ContactShadows.size() == 1);
  const SContactShadow& shadow = scene.ContactShadows.front();
  CHECK(shadow.Center == std::array<float, 2>{0.5f, 0.25f});
  CHECK_THAT(static_cast<double>(shadow.HalfExtent[0]), WithinAbs(0.15, kFloatRounding));
  CHECK_THAT(static_cast<double>(shadow.CornerRadius), WithinAbs(0.15, kFloatRounding));
}

TEST_CASE("scene builder: a contact shadow reaches as far as its solid is high or wide, in bounds",
          "[visualizations][offscreen][scene]") {
  struct SCase {
    CVector3 Size;  // m
    Real Blur;  // m: 0.6 of the least side, from 0.01 m to 0.1 m
  };
  const SCase c =
      GENERATE(SCase{CVector3(0.1, 0.2, 0.3), 0.06}, SCase{CVector3(0.2, 0.1, 0.3), 0.06},
               SCase{CVector3(0.2, 0.3, 0.05), 0.03}, SCase{CVector3(1, 1, 1), 0.1},
               SCase{CVector3(0.01, 0.2, 0.3), 0.01});
  CAPTURE(c.Size);
  CWorld world;
  world.Add(new CBoxEntity("b", CVector3(), CQuaternion(), false, c.Size));
  const SScene& scene = world.Build();
  REQUIRE(scene.ContactShadows.size() == 1);
  CHECK_THAT(scene.ContactShadows[0].Blur, WithinAbs(c.Blur, kFloatRounding));
}

TEST_CASE("scene builder: LEDs have the colours of the component, black ones are dark",
          "[visualizations][offscreen][scene]") {
  CWorld world;
  auto& box = world.Add(new CBoxEntity("box", CVector3(0.5, 0.0, 0.0), CQuaternion(), false,
                                       CVector3(0.4, 0.2, 0.1)));
  box.AddLED(CVector3(0.2, 0.0, 0.1), CColor::GREEN);
  box.AddLED(CVector3(-0.2, 0.0, 0.1), CColor::BLACK);
  SScene& scene = world.Build();
  REQUIRE(scene.Glows.size() == 2);
  CHECK(scene.Glows[0].Color.R == 0);
  CHECK(scene.Glows[0].Color.G == 255);
  CHECK(scene.Glows[0].HaloScale > 1.0f);
  CHECK_THAT(static_cast<double>(scene.Glows[0].Position[0]), WithinAbs(0.7, kFloatRounding));
  CHECK(scene.Glows[1].HaloScale == 0.0f);

  box.GetLEDEquippedEntity().SetLEDColor(1, CColor::BLUE);
  world.Build();
  REQUIRE(scene.Glows.size() == 2);
  CHECK(scene.Glows[1].Color.B == 255);
  CHECK(scene.Glows[1].HaloScale > 1.0f);
}

TEST_CASE("scene builder: a light is drawn at its position in its colour",
          "[visualizations][offscreen][scene]") {
  CWorld world;
  world.Add(new CLightEntity("lamp", CVector3(0.25, -0.5, 0.75), CColor::YELLOW, 1.0));
  SScene& scene = world.Build();
  REQUIRE(scene.Glows.size() == 1);
  CHECK(scene.Glows[0].Position == std::array<float, 3>{0.25f, -0.5f, 0.75f});
  CHECK(scene.Glows[0].Color.R == 255);
  CHECK(scene.Glows[0].Color.B == 0);
  CHECK(scene.Glows[0].HaloScale > 1.0f);
  for (const auto& instances : scene.Meshes) {
    CHECK(instances.empty());
  }
}

TEST_CASE("scene builder: a lamp shines only while its intensity is above 0",
          "[visualizations][offscreen][scene]") {
  CWorld world;
  auto* const lamp = new CLightEntity("lamp", CVector3(0.25, -0.5, 0.75), CColor::YELLOW, 0.0);
  world.Add(lamp);
  for (const Real intensity : {0.0, 0.1, -1.0, 2.0}) {
    CAPTURE(intensity);
    lamp->SetIntensity(intensity);
    SScene& scene = world.Build();
    REQUIRE(scene.Glows.size() == 1);
    const SGlow& glow = scene.Glows[0];
    CHECK(glow.Radius == 0.05f);
    CHECK(glow.IsLamp == (intensity > 0.0));
    CHECK((glow.HaloScale > 0.0f) == (intensity > 0.0));
    // dark glass is nearly black
    CHECK((glow.Color.R > 64) == (intensity > 0.0));
  }
}

TEST_CASE("scene builder: the floor is sampled at its resolution, again after a change",
          "[visualizations][offscreen][scene]") {
  CWorld world;
  auto* floor = new CFloorEntity("floor", 10);
  world.Add(floor);
  world.GetSpace().SetFloorEntity(*floor);
  SScene& scene = world.Build();
  CHECK(scene.Floor.Width == 40);
  CHECK(scene.Floor.Height == 20);
  REQUIRE(scene.Floor.Pixels != nullptr);
  REQUIRE(scene.Floor.Pixels->size() == 4 * 40 * 20);
  // default loop functions colour the floor white
  CHECK(scene.Floor.Pixels->front() == 255);
  CHECK(scene.Floor.IsSmooth);
  const auto version = scene.Floor.Version;
  world.Build();
  CHECK(scene.Floor.Version == version);
  floor->SetChanged();
  world.Build();
  CHECK(scene.Floor.Version != version);
}

namespace {

const CVector3 kEye(0.0, 0.0, 0.5);  // m, where rays start

// A world with a robot that tests record rays of.
class CRayWorld : public CWorld {
 public:
  CRayWorld() { GetSpace().AddControllableEntity(Robot); }
  ~CRayWorld() { GetSpace().RemoveControllableEntity(Robot); }
  CRayWorld(const CRayWorld&) = delete;
  CRayWorld& operator=(const CRayWorld&) = delete;

  typedef std::vector<std::array<float, 3>> TPoints;
  // builds the scene; @return the ends of its lines
  TPoints BuildEnds() {
    TPoints ends;
    for (const SLine& line : Build().Lines) {
      ends.push_back(line.End);
    }
    return ends;
  }

  CControllableEntity Robot{nullptr, "robot"};
};

}  // namespace

TEST_CASE("scene builder: recorded rays end at their hits, in another colour",
          "[visualizations][offscreen][scene]") {
  CRayWorld world;
  CControllableEntity& robot = world.Robot;
  const CRay3 free(kEye, CVector3(0.25, 0.0, 0.5));
  const CRay3 blocked(kEye, CVector3(0.0, 0.5, 0.5));
  robot.AddCheckedRay(false, free);
  robot.AddCheckedRay(true, blocked);
  robot.AddIntersectionPoint(blocked, 0.5);
  SScene& scene = world.Build();
  REQUIRE(scene.Lines.size() == 2);
  CHECK(scene.Lines[0].Start == std::array<float, 3>{0.0f, 0.0f, 0.5f});
  CHECK(scene.Lines[0].End == std::array<float, 3>{0.25f, 0.0f, 0.5f});
  // the obstructed one is half as long as the ray
  CHECK(scene.Lines[1].End == std::array<float, 3>{0.0f, 0.25f, 0.5f});
  CHECK(scene.Lines[1].Color.R > 2 * scene.Lines[1].Color.B);
  CHECK(scene.Lines[0].Color.B > 2 * scene.Lines[0].Color.R);
  REQUIRE(scene.Glows.size() == 1);
  CHECK(scene.Glows[0].Position == std::array<float, 3>{0.0f, 0.25f, 0.5f});
  world.Build(false);
  CHECK(scene.Lines.empty());
  CHECK(scene.Glows.empty());
}

TEST_CASE("scene builder: an obstructed ray without a recorded hit keeps its length",
          "[visualizations][offscreen][scene]") {
  CRayWorld world;
  CControllableEntity& robot = world.Robot;
  // a light sensor records no hit; the proximity sensor after it does
  const CRay3 toLight(kEye, CVector3(1.0, 0.0, 0.5));
  const CRay3 near(kEye, CVector3(0.0, 0.5, 0.5));
  robot.AddCheckedRay(true, toLight);
  robot.AddCheckedRay(true, near);
  robot.AddIntersectionPoint(near, 0.5);
  CHECK(world.BuildEnds() == CRayWorld::TPoints{{1.0f, 0.0f, 0.5f}, {0.0f, 0.25f, 0.5f}});
}

TEST_CASE("scene builder: hits belong to obstructed rays in their order, of any length",
          "[visualizations][offscreen][scene]") {
  CRayWorld world;
  CControllableEntity& robot = world.Robot;
  // of no length, free though a later hit is on it, with a hit, and without one
  const CRay3 point(kEye, kEye);
  const CRay3 along(kEye, CVector3(0.0, 0.5, 0.5));
  const CRay3 last(kEye, CVector3(0.0, -0.5, 0.5));
  robot.AddCheckedRay(true, point);
  robot.AddCheckedRay(false, along);
  robot.AddCheckedRay(true, along);
  robot.AddCheckedRay(true, last);
  robot.AddIntersectionPoint(point, 0.0);
  robot.AddIntersectionPoint(along, 0.5);
  CHECK(world.BuildEnds() ==
        CRayWorld::TPoints{
            {0.0f, 0.0f, 0.5f}, {0.0f, 0.5f, 0.5f}, {0.0f, 0.25f, 0.5f}, {0.0f, -0.5f, 0.5f}});
  CHECK(world.Build().Glows.size() == 2);
}

TEST_CASE("scene builder: a body without an appearance is drawn as its solids",
          "[visualizations][offscreen][scene]") {
  class CUsersBody : public CComposableEntity {
   public:
    CUsersBody() : CComposableEntity(nullptr, "mine") {
      auto* const body =
          new CEmbodiedEntity(this, "body", CVector3(1.0, 0.5, 0.25), CQuaternion(), false);
      AddComponent(*body);
      auto description = std::make_shared<SBodyDescription>();
      description->Shapes = {SShapeDescription::Box(CVector3(0.4, 0.2, 0.1)),
                             SShapeDescription::Cylinder(0.25, 0.5, CVector3(1.0, 0.0, 0.0)),
                             SShapeDescription::Sphere(0.25, CVector3(0.0, 1.0, 0.25))};
      body->SetBodyDescription(description);
    }
    std::string GetTypeDescription() const override { return "mine"; }
  };
  CWorld world;
  CUsersBody body;
  world.GetSpace().GetRootEntityVector().push_back(&body);
  TakeLogErr();
  SScene& scene = world.Build();
  CHECK_THAT(TakeLogErr(), Contains("pictures show the solids of \"mine\" and other <mine>"));
  const auto place = [&scene](EMeshKind kind) {
    REQUIRE(scene.OfKind(kind).size() == 1);
    const auto& rows = scene.OfKind(kind).front().ToWorld;
    return CVector3(rows[0][3], rows[1][3], rows[2][3]);
  };
  // boxes and cylinders are placed by their base, spheres by their centre
  CHECK(place(EMeshKind::Box) == CVector3(1.0, 0.5, 0.25));
  CHECK(place(EMeshKind::Cylinder) == CVector3(2.0, 0.5, 0.25));
  CHECK(place(EMeshKind::Sphere) == CVector3(1.0, 1.5, 0.75));
  world.Build();
  CHECK(TakeLogErr().empty());
  world.GetSpace().GetRootEntityVector().pop_back();
}

TEST_CASE("scene builder: LEDs that the appearance does not contain are drawn at their places",
          "[visualizations][offscreen][scene]") {
  // a user's robot: an appearance, or none, and LEDs that only its layout knows
  class CUsersRobot : public CComposableEntity {
   public:
    explicit CUsersRobot(bool isSeen) : CComposableEntity(nullptr, "mine"), m_isSeen(isSeen) {
      m_body = new CEmbodiedEntity(this, "body", CVector3(1.0, 0.5, 0.0),
                                   CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z), false);
      AddComponent(*m_body);
      m_leds = new CLEDEquippedEntity(this, "leds");
      AddComponent(*m_leds);
      m_leds->AddLED(CVector3(0.25, 0.0, 0.125), m_body->GetOriginAnchor(), CColor::RED);
      m_leds->AddLED(CVector3(0.0, 0.0, 0.25), m_body->GetOriginAnchor(), CColor::BLACK);
      SVisualPart part;
      part.Kind = SVisualPart::EKind::LED;
      part.LED = 1;
      part.Size = CVector3(0.5, 0.5, 0.5);
      m_appearance.Parts.push_back(part);
    }
    const SAppearance* GetAppearance() const override { return m_isSeen ? &m_appearance : nullptr; }
    std::string GetTypeDescription() const override { return "mine"; }

   private:
    bool m_isSeen;
    CEmbodiedEntity* m_body;
    CLEDEquippedEntity* m_leds;
    SAppearance m_appearance;
  };
  const bool isSeen = GENERATE(true, false);
  CAPTURE(isSeen);
  CWorld world;
  CUsersRobot robot(isSeen);
  world.GetSpace().GetRootEntityVector().push_back(&robot);
  TakeLogErr();
  SScene& scene = world.Build();
  REQUIRE(scene.Glows.size() == 2);
  const SGlow& lit = isSeen ? scene.Glows[1] : scene.Glows[0];
  CHECK(lit.Color.R == 255);
  CHECK(lit.IsSignal == 1.0f);
  // 0.25 m along the robot's x, which is the world's y
  CHECK_THAT(static_cast<double>(lit.Position[0]), WithinAbs(1.0, kFloatRounding));
  CHECK_THAT(static_cast<double>(lit.Position[1]), WithinAbs(0.75, kFloatRounding));
  CHECK_THAT(static_cast<double>(lit.Position[2]), WithinAbs(0.125, kFloatRounding));
  const SGlow& dark = isSeen ? scene.Glows[0] : scene.Glows[1];
  CHECK(dark.IsSignal == 0.0f);
  // the declared one has the size of its part
  CHECK((dark.Radius == 0.25f) == isSeen);
  TakeLogErr();
  world.GetSpace().GetRootEntityVector().pop_back();
}

TEST_CASE("floor image: edges that loop functions paint are filtered, areas are exact",
          "[visualizations][offscreen][scene]") {
  class CHalves : public CLoopFunctions {
   public:
    CColor GetFloorColor(const CVector2& point) override {
      return point.GetX() < 1.04 ? CColor(200, 0, 0) : CColor(0, 0, 200);
    }
  };
  CWorld world;
  CHalves halves;
  world.GetSimulator().SetLoopFunctions(halves);
  auto* floor = new CFloorEntity("floor", 10);
  world.Add(floor);
  world.GetSpace().SetFloorEntity(*floor);
  const SScene& scene = world.Build();
  REQUIRE(scene.Floor.Width == 40);
  const auto red = [&scene](std::size_t column) { return (*scene.Floor.Pixels)[4 * column]; };
  // the arena begins at x = -1: pixel 20 covers 1.0 to 1.1, and half of its samples, at 1.025, are
  // left of the border
  CHECK(red(18) == 200);
  CHECK(red(19) == 200);
  CHECK(red(20) == 100);
  CHECK(red(21) == 0);
  // before the loop functions end
  world.GetSimulator().Destroy();
}

TEST_CASE("floor image: edges are filtered in both directions, along the sides of the arena, too",
          "[visualizations][offscreen][scene]") {
  class CStripes : public CLoopFunctions {
   public:
    CColor GetFloorColor(const CVector2& point) override {
      return point.GetY() < -0.94 || point.GetY() > 0.23 ? CColor(200, 0, 0) : CColor(0, 0, 200);
    }
  };
  CWorld world;
  CStripes stripes;
  world.GetSimulator().SetLoopFunctions(stripes);
  auto* floor = new CFloorEntity("floor", 10);
  world.Add(floor);
  world.GetSpace().SetFloorEntity(*floor);
  const SScene& scene = world.Build();
  REQUIRE(scene.Floor.Height == 20);
  const auto red = [&scene](std::size_t row) { return (*scene.Floor.Pixels)[4 * 40 * row]; };
  // from y = -1 on, in steps of 0.1; the middles of rows 0 and 12, at -0.95 and 0.25, are red, and
  // one of their two samples, a quarter of a pixel away, is not: -0.925 and 0.225
  CHECK(red(0) == 100);
  CHECK(red(1) == 0);
  CHECK(red(11) == 0);
  CHECK(red(12) == 100);
  CHECK(red(13) == 200);
  world.GetSimulator().Destroy();
}

TEST_CASE("floor image: a side has from 1 to 8192 pixels", "[visualizations][offscreen][scene]") {
  CWorld world;
  CFloorEntity& floor = world.Add(new CFloorEntity("floor", 10));
  const SFloorSamples samples =
      SampleFloor(floor, CVector3(0.0, 0.0, 0.0), CVector3(1000.0, 0.0, 1.0));
  CHECK(samples.Width == 8192);
  CHECK(samples.Height == 1);
}

TEST_CASE("scene builder: the marker of a robot is the middle of its largest part, as wide as that",
          "[visualizations][offscreen][scene]") {
  class CUsersRobot : public CComposableEntity {
   public:
    CUsersRobot(bool isRobot, bool hasSolids) : CComposableEntity(nullptr, "mine") {
      AddComponent(
          *new CEmbodiedEntity(this, "body", CVector3(1.0, 0.5, 0.25), CQuaternion(), false));
      if (isRobot) {
        AddComponent(*new CControllableEntity(this));
      }
      SVisualPart part;
      part.Size = CVector3(0.125, hasSolids ? 0.125 : 0.0, 0.125);
      m_appearance.Parts.push_back(part);
      part.Size = CVector3(0.5, 0.75, hasSolids ? 1.0 : 0.0);
      m_appearance.Parts.push_back(part);
    }
    const SAppearance* GetAppearance() const override { return &m_appearance; }

   private:
    SAppearance m_appearance;
  };
  const bool isRobot = GENERATE(true, false);
  const bool hasSolids = GENERATE(true, false);
  CAPTURE(isRobot, hasSolids);
  CWorld world;
  CUsersRobot robot(isRobot, hasSolids);
  world.GetSpace().GetRootEntityVector().push_back(&robot);
  const SScene& scene = world.Build();
  REQUIRE(scene.Markers.size() == (isRobot && hasSolids ? 1 : 0));
  if (!scene.Markers.empty()) {
    CHECK(scene.Markers[0].Position == std::array<float, 3>{1.0f, 0.5f, 0.75f});
    CHECK(scene.Markers[0].Radius == 0.375f);
  }
  world.GetSpace().GetRootEntityVector().pop_back();
}

TEST_CASE("scene builder: what stands on the ground has one contact shadow, of its largest part",
          "[visualizations][offscreen][scene]") {
  class CStandingBody : public CPositionalEntity {
   public:
    CStandingBody() : CPositionalEntity(nullptr, "standing") {}
    const SAppearance* GetAppearance() const override { return &Appearance; }

    SAppearance Appearance;
  };
  using EKind = SVisualPart::EKind;
  CWorld world;
  CStandingBody body;
  world.GetSpace().GetRootEntityVector().push_back(&body);
  // half the width of the contact shadow, or 0 if there is none
  const auto build = [&](const std::vector<SVisualPart>& parts) {
    body.Appearance.Parts = parts;
    const SScene& scene = world.Build();
    CHECK(scene.ContactShadows.size() <= 1);
    return scene.ContactShadows.empty() ? 0.0f : scene.ContactShadows[0].HalfExtent[0];
  };
  const auto make = [](EKind kind, Real width, Real depth, Real height = 0.0, Real tilt = 0.0) {
    SVisualPart part;
    part.Kind = kind;
    part.Size = CVector3(width, depth, 1.0);
    part.Position = CVector3(0.0, 0.0, height);
    part.Orientation = CQuaternion(CRadians(tilt), CVector3::X);
    return part;
  };
  for (const EKind kind : {EKind::Box, EKind::Cylinder, EKind::Cone}) {
    CHECK(build({make(kind, 1.0, 1.0)}) == 0.5f);
    CHECK(build({make(kind, 1.0, 1.0, 0.5)}) == 0.0f);
    CHECK(build({make(kind, 1.0, 1.0, -0.5)}) == 0.0f);
    CHECK(build({make(kind, 1.0, 1.0, 0.0, 1.0)}) == 0.0f);
  }
  for (const EKind kind : {EKind::Sphere, EKind::Ring}) {
    CHECK(build({make(kind, 1.0, 1.0)}) == 0.0f);
  }
  const SVisualPart wide = make(EKind::Box, 2.0, 1.0);
  const SVisualPart narrow = make(EKind::Box, 1.0, 1.0);
  CHECK(build({wide, narrow}) == 1.0f);
  CHECK(build({narrow, wide}) == 1.0f);
  // of two that are as large, the first
  CHECK(build({wide, make(EKind::Box, 1.0, 2.0)}) == 1.0f);
  CHECK(build({make(EKind::Box, 1.0, 2.0), wide}) == 0.5f);
  // the largest one that stands
  CHECK(build({make(EKind::Sphere, 4.0, 4.0), narrow}) == 0.5f);
  world.GetSpace().GetRootEntityVector().pop_back();
}

TEST_CASE("scene builder: small parts of an entity are marked as details",
          "[visualizations][offscreen][scene]") {
  class CKnobbedBody : public CPositionalEntity {
   public:
    CKnobbedBody() : CPositionalEntity(nullptr, "knobbed") {
      SVisualPart part;
      part.Size = CVector3(1.0, 1.0, 1.0);
      m_appearance.Parts.push_back(part);
      part.Size = CVector3(0.5, 0.5, 0.5);
      m_appearance.Parts.push_back(part);
    }
    const SAppearance* GetAppearance() const override { return &m_appearance; }

   private:
    SAppearance m_appearance;
  };
  CWorld world;
  CKnobbedBody body;
  world.GetSpace().GetRootEntityVector().push_back(&body);
  SScene& scene = world.Build();
  REQUIRE(scene.OfKind(EMeshKind::Box).size() == 2);
  CHECK(scene.OfKind(EMeshKind::Box)[0].IsDetail == 0.0f);
  CHECK(scene.OfKind(EMeshKind::Box)[1].IsDetail == 1.0f);
  world.GetSpace().GetRootEntityVector().pop_back();
}

TEST_CASE("scene builder: building does not change the run and keeps nothing of the last picture",
          "[visualizations][offscreen][scene]") {
  CWorld world;
  auto& box = world.Add(new CBoxEntity("box", CVector3(0.5, 0.0, 0.0), CQuaternion(), false,
                                       CVector3(0.4, 0.2, 0.1)));
  box.AddLED(CVector3(0.2, 0.0, 0.1), CColor::GREEN);
  const UInt64 digest = world.GetSpace().ComputeDigest();
  world.Build();
  SScene& scene = world.Build();
  CHECK(scene.OfKind(EMeshKind::Box).size() == 1);
  CHECK(scene.Glows.size() == 1);
  CHECK(scene.ContactShadows.size() == 1);
  CHECK(world.GetSpace().ComputeDigest() == digest);
}

}  // namespace scene_builder_test
