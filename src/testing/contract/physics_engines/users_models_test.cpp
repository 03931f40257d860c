// Models of users for dynamics2d, written as for ARGoS 3, in every engine.

#include <argos3/core/simulator/physics_engine/described_body_model.h>
#include <argos3/plugins/simulator/entities/new_component.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_differentialsteering_control.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_gripping.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_multi_body_object_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_stretchable_object_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_velocity_control.h>
#include <argos3/testing/compat/projects/chipmunk_robot/beetle_entity.h>
#include <argos3/testing/compat/projects/chipmunk_robot/dynamics2d_beetle_model.h>
#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/support/closed_form/differential_drive.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

namespace argos::users_models_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kTick = 0.1;  // s

/** Entities of this file: a "body" and what they need of attributes. */
class CModelledEntity : public CComposableEntity {
 public:
  CModelledEntity() : CComposableEntity(nullptr) {}

  void Init(TConfigurationNode& tree) override {
    CComposableEntity::Init(tree);
    bool movable = true;
    GetNodeAttributeOrDefault(tree, "movable", movable, movable);
    GetNodeAttributeOrDefault(tree, "flaw", Flaw, Flaw);
    GetNodeAttributeOrDefault(tree, "friction", Friction, Friction);
    m_body = NewComponent<CEmbodiedEntity>(*this, "body_0", CVector3(), CQuaternion(), movable);
    m_body->Init(GetNode(tree, "body"));
  }
  CEmbodiedEntity& GetEmbodiedEntity() { return *m_body; }

  std::string Flaw;
  Real Friction = 1.0;  // N
  Real Speed = 0.0;  // m/s
  Real Steering = 0.0;  // rad

 private:
  CEmbodiedEntity* m_body = nullptr;
};

}  // namespace

/** A beetle that describes its body. Of the same class for operations, so it has a model, too. */
class CDescribedBeetleEntity : public CBeetleEntity {
 public:
  void Init(TConfigurationNode& tree) override {
    CBeetleEntity::Init(tree);
    auto description = std::make_shared<SBodyDescription>();
    description->Shapes.push_back(SShapeDescription::Cylinder(BEETLE_RADIUS, BEETLE_HEIGHT));
    description->Mass = BEETLE_MASS;
    description->PlanarInertia = BEETLE_MASS * 0.5 * (BEETLE_RADIUS * BEETLE_RADIUS);
    description->Drive = SDifferentialDriveDescription{BEETLE_WHEEL_DISTANCE, BEETLE_WHEEL_RADIUS,
                                                       BEETLE_MAX_FORCE, BEETLE_MAX_TORQUE};
    GetEmbodiedEntity().SetBodyDescription(description);
  }
  std::string GetTypeDescription() const override { return "described_beetle"; }
};

/** A car: four wheels, of which the front ones steer. */
class CCartEntity : public CModelledEntity {
 public:
  ENABLE_VTABLE();
  std::string GetTypeDescription() const override { return "cart"; }

  bool IsStopped = false;
};

/** Uses what the reference protects, as a third party's car does. */
class CCartControl : public CDynamics2DVelocityControl {
 public:
  static constexpr Real kWheelbase = 0.12;  // m

  explicit CCartControl(CDynamics2DEngine& engine)
      : CDynamics2DVelocityControl(engine, 20.0, 1.0) {}
  void Steer(Real speed, Real steering) {
    const Real heading = m_ptControlledBody->a;
    SetLinearVelocity(CVector2(speed * std::cos(heading), speed * std::sin(heading)));
    m_ptControlBody->w = speed * std::tan(steering) / kWheelbase;
  }
};

class CCartModel : public CDynamics2DSingleBodyObjectModel {
 public:
  CCartModel(CDynamics2DEngine& engine, CCartEntity& cart)
      : CDynamics2DSingleBodyObjectModel(engine, cart), m_cart(cart), m_control(engine) {
    cpSpace* space = engine.GetPhysicsSpace();
    cpBody* body = cpSpaceAddBody(space, cpBodyNew(1.2, cpMomentForBox(1.2, 0.2, 0.1)));
    cpSpaceAddShape(space, cpBoxShapeNew(body, 0.2, 0.1));
    m_control.AttachTo(body);
    SetBody(body, 0.1);
  }
  void UpdateFromEntityStatus() override {
    m_control.Steer(m_cart.Speed, m_cart.Steering);
    if (m_cart.IsStopped) {
      m_control.Reset();
    }
  }

 private:
  CCartEntity& m_cart;
  CCartControl m_control;
};

/** A robot with a trailer that is rigidly joined, with a polygon, and with flaws. */
class CTugEntity : public CModelledEntity {
 public:
  ENABLE_VTABLE();
  void Init(TConfigurationNode& tree) override {
    CModelledEntity::Init(tree);
    Wheels = NewComponent<CWheeledEntity>(*this, "wheels_0", size_t(2));
    Wheels->SetWheel(0, CVector3(0.0, 0.04, 0.0), 0.015);
    Wheels->SetWheel(1, CVector3(0.0, -0.04, 0.0), 0.015);
  }
  std::string GetTypeDescription() const override { return "tug"; }

  CWheeledEntity* Wheels = nullptr;
  CVector2 Velocity;  // m/s, in the world; (0,0): as the wheels turn
};

class CTugModel : public CDynamics2DMultiBodyObjectModel {
 public:
  CTugModel(CDynamics2DEngine& engine, CTugEntity& tug)
      : CDynamics2DMultiBodyObjectModel(engine, tug),
        m_tug(tug),
        m_control(engine, 3.0, 2.0, 0.08, tug.GetConfigurationNode()),
        m_second(engine, 3.0, 2.0, 0.08) {
    cpSpace* space = engine.GetPhysicsSpace();
    cpBody* base =
        tug.Flaw == "static"
            ? cpBodyNewStatic()
            : cpSpaceAddBody(space, cpBodyNew(0.5, cpMomentForCircle(0.5, 0, 0.06, cpvzero)));
    cpBody* trailer = cpSpaceAddBody(space, cpBodyNew(0.25, cpMomentForBox(0.25, 0.06, 0.04)));
    if (tug.Flaw == "constraint") {
      cpSpaceAddConstraint(space, cpPivotJointNew(base, trailer, cpv(-0.06, 0.0)));
    }
    if (tug.Flaw != "no_shape") {
      cpSpaceAddShape(space, cpCircleShapeNew(base, 0.06, cpvzero));
      cpSpaceAddShape(space, cpBoxShapeNew(trailer, 0.06, 0.04));
    }
    if (tug.Flaw == "sensor") {
      cpSpaceAddShape(space, cpCircleShapeNew(base, 0.1, cpvzero))->sensor = 1;
    }
    m_control.AttachTo(tug.Flaw == "offset" ? trailer : base);
    if (tug.Flaw == "two_controls") {
      m_second.AttachTo(trailer);
    }
    if (tug.Flaw == "polygon") {
      const cpVect dent[] = {cpv(0.0, 0.0), cpv(0.1, 0.1), cpv(0.03, 0.0), cpv(0.1, -0.1)};
      cpSpaceAddShape(space, cpPolyShapeNew(base, 4, dent, cpvzero));
    }
    if (tug.Flaw == "radius") {
      cpCircleShapeNew(base, 0.0, cpvzero);
    }
    if (tug.Flaw == "mass") {
      cpBodyNew(-1.0, 1.0);
    }
    if (tug.Flaw != "no_body") {
      AddBody(base, cpvzero, 0.0, 0.05);
      AddBody(trailer, cpv(-0.1, 0.0), 0.0, 0.03);
    }
  }
  void Reset() override {
    CDynamics2DMultiBodyObjectModel::Reset();
    m_control.Reset();
    ++NumResets;
  }
  void UpdateFromEntityStatus() override {
    const Real* wheels = m_tug.Wheels->GetWheelVelocities();
    m_control.SetWheelVelocity(wheels[0], wheels[1]);
    if (m_tug.Velocity != CVector2()) {
      m_control.SetLinearVelocity(m_tug.Velocity);
    }
  }
  void UpdateEntityStatus() override {
    CDynamics2DMultiBodyObjectModel::UpdateEntityStatus();
    Trailer = GetBody(1)->p;
    Last = GetBody(0)->v;
  }
  void MoveTo(const CVector3& position, const CQuaternion& orientation) override {
    CDynamics2DMultiBodyObjectModel::MoveTo(position, orientation);
    Trailer = GetBody(1).Body->p;
  }

  inline static int NumResets = 0;
  inline static cpVect Trailer = cpvzero;  // m, after the last tick or move
  inline static cpVect Last = cpvzero;  // m/s, of the base

 private:
  CTugEntity& m_tug;
  CDynamics2DDifferentialSteeringControl m_control, m_second;
};

/** A crate that robots push. */
class CCrateEntity : public CModelledEntity {
 public:
  ENABLE_VTABLE();
  std::string GetTypeDescription() const override { return "crate"; }
};

class CCrateModel : public CDynamics2DStretchableObjectModel {
 public:
  CCrateModel(CDynamics2DEngine& engine, CCrateEntity& crate)
      : CDynamics2DStretchableObjectModel(engine, crate) {
    const bool movable = crate.GetEmbodiedEntity().IsMovable();
    cpBody* body = movable ? cpSpaceAddBody(engine.GetPhysicsSpace(),
                                            cpBodyNew(0.3, cpMomentForBox(0.3, 0.2, 0.2)))
                           : cpBodyNewStatic();
    const cpVect corners[] = {cpv(-0.1, -0.1), cpv(-0.1, 0.1), cpv(0.1, 0.1), cpv(0.1, -0.1)};
    cpShape* shape =
        cpSpaceAddShape(engine.GetPhysicsSpace(), cpPolyShapeNew(body, 4, corners, cpvzero));
    SetBody(body, 0.05);
    SetMass(0.3);
    SetLinearFriction(0.0, crate.Friction);
    SetAngularFriction(0.0, crate.Friction * 0.1);
    SetGrippable(
        std::make_unique<CDynamics2DGrippable>(crate.GetEmbodiedEntity(), shape).release());
  }
};

/** A class whose operation a user has written by hand, with a gripper. */
class CClawEntity : public CModelledEntity {
 public:
  ENABLE_VTABLE();
  void Init(TConfigurationNode& tree) override {
    CModelledEntity::Init(tree);
    Gripper = NewComponent<CGripperEquippedEntity>(*this, "gripper_0", CVector3(0.06, 0.0, 0.02),
                                                   CVector3::X);
  }
  std::string GetTypeDescription() const override { return "claw"; }

  CGripperEquippedEntity* Gripper = nullptr;
};

class CClawModel : public CDynamics2DSingleBodyObjectModel {
 public:
  CClawModel(CDynamics2DEngine& engine, CClawEntity& claw)
      : CDynamics2DSingleBodyObjectModel(engine, claw), m_claw(claw), m_control(engine, 5.0, 5.0) {
    cpSpace* space = engine.GetPhysicsSpace();
    cpBody* body =
        cpSpaceAddBody(space, cpBodyNew(1.0, cpMomentForCircle(1.0, 0.0, 0.05, cpvzero)));
    cpSpaceAddShape(space, cpCircleShapeNew(body, 0.05, cpvzero));
    cpShape* sensor = cpSpaceAddShape(space, cpCircleShapeNew(body, 0.01, cpv(0.06, 0.0)));
    sensor->sensor = 1;
    m_gripper = std::make_unique<CDynamics2DGripper>(engine, *claw.Gripper, sensor);
    m_control.AttachTo(body);
    SetBody(body, 0.05);
    Current = this;
  }
  void UpdateFromEntityStatus() override {
    m_control.SetLinearVelocity(CVector2(m_claw.Speed, 0.0));
  }
  CDynamics2DGripper& GetGripper() { return *m_gripper; }

  inline static CClawModel* Current = nullptr;

 private:
  CClawEntity& m_claw;
  CDynamics2DVelocityControl m_control;
  std::unique_ptr<CDynamics2DGripper> m_gripper;
};

class CAddClaw : public CDynamics2DOperationAddEntity {
 public:
  SOperationOutcome ApplyTo(CDynamics2DEngine& engine, CClawEntity& claw) {
    CClawModel* model = std::make_unique<CClawModel>(engine, claw).release();
    engine.AddPhysicsModel(claw.GetId(), *model);
    claw.GetComponent<CEmbodiedEntity>("body").AddPhysicsModel(engine.GetId(), *model);
    return SOperationOutcome(true);
  }
};

#define REGISTER_MODELLED(CLASS, TAG)                                               \
  REGISTER_ENTITY(CLASS, TAG, "a test", "1.0", "Has a user's model.", "", "Usable") \
  REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CLASS)

REGISTER_ENTITY(CDescribedBeetleEntity, "described_beetle", "a test", "1.0", "A beetle.", "",
                "Usable")
REGISTER_MODELLED(CCartEntity, "cart")
REGISTER_MODELLED(CTugEntity, "tug")
REGISTER_MODELLED(CCrateEntity, "crate")
REGISTER_MODELLED(CClawEntity, "claw")
REGISTER_STANDARD_DYNAMICS2D_OPERATIONS_ON_ENTITY(CCartEntity, CCartModel)
REGISTER_STANDARD_DYNAMICS2D_OPERATIONS_ON_ENTITY(CTugEntity, CTugModel)
REGISTER_STANDARD_DYNAMICS2D_OPERATIONS_ON_ENTITY(CCrateEntity, CCrateModel)
REGISTER_DYNAMICS2D_OPERATION(CDynamics2DOperationAddEntity, CAddClaw, CClawEntity)

namespace {

std::string Placed(const std::string& tag, const std::string& id, Real x, Real y, Real yaw = 0.0,
                   const std::string& attributes = "") {
  std::ostringstream xml;
  xml << std::setprecision(17) << "<" << tag << " id='" << id << "' " << attributes
      << "><body position='" << x << "," << y << ",0' orientation='" << yaw << ",0,0'/></" << tag
      << ">\n";
  return xml.str();
}

const SBodyDescription& DescriptionOf(CDriveWorld& world, const std::string& id) {
  return *world.Body(id).GetBodyDescription();
}

}  // namespace

TEST_CASE("users' models: a robot moves to the bit like one that describes its body",
          "[contract][engine]") {
  const SEngineType type = GENERATE(from_range(kEnginesWithWheels));
  using TSpeeds = std::pair<Real, Real>;  // cm/s
  const auto [left, right] = GENERATE(TSpeeds(10, 10), TSpeeds(3, 12), TSpeeds(-5, 7.5));
  CAPTURE(type, left, right);
  // the wall is reached after about 40 ticks
  const std::string wall =
      "<box id='w' size='0.2,8,0.5' movable='false'><body position='0.6,0,0'/></box>";
  const auto drive = [&, l = left, r = right](const std::string& tag) {
    return std::make_unique<CDriveWorld>(type.ToXml(), wall + DriverXml(tag, "r", 0, 0, 10, l, r));
  };
  const auto recorded = drive("beetle");
  const auto described = drive("described_beetle");
  CHECK(DescriptionOf(*recorded, "r").IsRecorded);
  CHECK_FALSE(DescriptionOf(*described, "r").IsRecorded);
  for (int tick = 0; tick < 80; ++tick) {
    recorded->Step();
    described->Step();
    REQUIRE(recorded->Position("r") == described->Position("r"));
    REQUIRE(recorded->Body("r").GetOriginAnchor().Orientation ==
            described->Body("r").GetOriginAnchor().Orientation);
  }
  CHECK(recorded->Position("r") != CVector3());
  if (type.HasContacts && left == right) {
    CHECK_THAT(recorded->Position("r").GetX(), WithinAbs(0.5 - BEETLE_RADIUS, 2e-3));
    CHECK(recorded->Position("r").GetX() < 0.5);
  }
}

TEST_CASE("users' models: the record becomes the description", "[contract][engine]") {
  const SEngineType type = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(type);
  CDriveWorld world(type.ToXml(), DriverXml("beetle", "b", 0, 0, 0, 0, 0) +
                                      Placed("tug", "t", 0, 1) + Placed("cart", "c", 0, 2) +
                                      Placed("crate", "k", 0, 3, 0, "friction='0.7'"));
  const SBodyDescription& beetle = DescriptionOf(world, "b");
  REQUIRE(beetle.Shapes.size() == 1);
  CHECK(beetle.Shapes[0].Kind == SShapeDescription::EKind::Cylinder);
  CHECK(beetle.Shapes[0].Radius == BEETLE_RADIUS);
  CHECK(beetle.Shapes[0].Size.GetZ() == BEETLE_HEIGHT);
  CHECK(beetle.Mass == BEETLE_MASS);
  CHECK_THAT(*beetle.PlanarInertia, WithinAbs(0.4 * 0.5 * 0.0036, 1e-15));
  REQUIRE(beetle.Drive.has_value());
  CHECK(beetle.Drive->InterwheelDistance == BEETLE_WHEEL_DISTANCE);
  CHECK(beetle.Drive->WheelRadius == BEETLE_WHEEL_RADIUS);
  CHECK(beetle.Drive->MaxForce == BEETLE_MAX_FORCE);
  CHECK_FALSE(beetle.Grippable);

  const SBodyDescription& tug = DescriptionOf(world, "t");
  REQUIRE(tug.Shapes.size() == 2);
  CHECK(tug.Mass == 0.75);
  // the trailer's own moment, and that of its mass at 0.1 m
  CHECK_THAT(*tug.PlanarInertia,
             WithinAbs(0.5 * 0.5 * 0.0036 + 0.25 * (0.0036 + 0.0016) / 12.0 + 0.25 * 0.01, 1e-15));
  CHECK(tug.Shapes[1].Kind == SShapeDescription::EKind::Box);
  CHECK(tug.Shapes[1].Offset == CVector3(-0.1, 0, 0));
  CHECK(tug.Shapes[1].Size == CVector3(0.06, 0.04, 0.03));

  const SBodyDescription& cart = DescriptionOf(world, "c");
  CHECK_FALSE(cart.Drive.has_value());
  REQUIRE(cart.PlanarDrive.has_value());
  CHECK(cart.PlanarDrive->MaxForce == 20.0);
  CHECK(cart.PlanarDrive->MaxTorque == 1.0);

  const SBodyDescription& crate = DescriptionOf(world, "k");
  CHECK_FALSE(crate.HasDrive());
  CHECK(crate.Grippable);
  REQUIRE(crate.Shapes.size() == 1);
  CHECK(crate.Shapes[0].Kind == SShapeDescription::EKind::Prism);
  CHECK(crate.Shapes[0].Size == CVector3(0.2, 0.2, 0.05));
  REQUIRE(crate.GroundFriction.has_value());
  CHECK(crate.GroundFriction->MaxForce == 0.7);
  CHECK_THAT(*crate.GroundFriction->MaxTorque, WithinAbs(0.07, 1e-15));
}

TEST_CASE("users' models: attributes of the robot's element have precedence over the limits",
          "[contract][engine]") {
  const std::string child = GENERATE(
      as<std::string>(), "<dynamics2d><differential_steering max_force='7'/></dynamics2d>", "");
  const std::string attributes = child.empty() ? "max_force='7'" : "";
  CDriveWorld world(kDynamics2D.ToXml(),
                    "<tug id='t' " + attributes + "><body position='0,0,0'/>" + child + "</tug>");
  CHECK(DescriptionOf(world, "t").Drive->MaxForce == 7.0);
  CHECK(DescriptionOf(world, "t").Drive->MaxTorque == 2.0);
}

TEST_CASE("users' models: joined bodies follow the arc, and the model sees them",
          "[contract][engine]") {
  const SEngineType type = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(type);
  CDriveWorld world(type.ToXml(), Placed("tug", "t", 0.5, -0.5, 30));
  const Real wheels[2] = {0.03, 0.07};
  world.Get<CTugEntity>("t").Wheels->SetVelocities(wheels);
  world.Step(50);
  const testing::SPose exact = testing::IntegrateDifferentialDrive(
      {0.5, -0.5, std::numbers::pi / 6.0}, 0.03, 0.07, 0.08, kTick * (50 - type.GetLag()));
  const CVector3 position = world.Position("t");
  const Real way = 0.05 * 5.0;
  // an allowance: its centre of mass is off its origin
  const Real offCentre = type.Tag == "dynamics2d" ? 5e-4 : 0.0;
  CHECK(std::hypot(position.GetX() - exact.X, position.GetY() - exact.Y) <=
        1e-9 + offCentre + 2.0 * type.Slip * way);
  const Real yaw = world.Yaw("t");
  CHECK_THAT(CTugModel::Trailer.x, WithinAbs(position.GetX() - 0.1 * std::cos(yaw), 1e-9));
  CHECK_THAT(CTugModel::Trailer.y, WithinAbs(position.GetY() - 0.1 * std::sin(yaw), 1e-9));
  CHECK_THAT(std::hypot(CTugModel::Last.x, CTugModel::Last.y), WithinAbs(0.05, 1e-3));

  world.Body("t").MoveTo(CVector3(2, 2, 0), CQuaternion());
  CHECK_THAT(CTugModel::Trailer.x, WithinAbs(1.9, 1e-12));
  const int resets = CTugModel::NumResets;
  world.GetSimulator().Reset();
  CHECK(CTugModel::NumResets == resets + 1);
  CHECK_THAT(CTugModel::Trailer.x, WithinAbs(0.5 - 0.1 * std::cos(std::numbers::pi / 6.0), 1e-9));
}

TEST_CASE("users' models: a car that sets velocities in the world moves straight in each tick",
          "[contract][engine]") {
  const SEngineType type = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(type);
  CDriveWorld world(type.ToXml("e", type.HasLag ? "velocity_lag='0'" : ""),
                    Placed("cart", "c", 0, 0, 20));
  auto& cart = world.Get<CCartEntity>("c");
  cart.Speed = 0.1;
  cart.Steering = 0.4;
  Real x = 0.0;
  Real y = 0.0;
  Real yaw = std::numbers::pi / 9.0;
  for (int tick = 0; tick < 50; ++tick) {
    world.Step();
    x += kTick * 0.1 * std::cos(yaw);
    y += kTick * 0.1 * std::sin(yaw);
    yaw += kTick * 0.1 * std::tan(0.4) / CCartControl::kWheelbase;
  }
  const CVector3 position = world.Position("c");
  // in space, the robot settles on its casters
  CHECK(std::hypot(position.GetX() - x, position.GetY() - y) <= (type.Slip > 0.0 ? 1e-4 : 1e-9));
  cart.IsStopped = true;
  world.Step();
  const CVector3 stopped = world.Position("c");
  world.Step(10);
  // single precision in dynamics2d; in space, it rolls out in a tick
  CHECK(Distance(world.Position("c"), stopped) <= (type.Slip > 0.0 ? 1e-3 : 1e-6));
}

TEST_CASE("users' models: wheels that are given a velocity turn with its part along the heading",
          "[contract][engine]") {
  const SEngineType type = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(type);
  CDriveWorld world(type.ToPromptXml(), Placed("tug", "t", 0, 0, 60));
  // 0.05 m/s of 0.1 m/s along x
  world.Get<CTugEntity>("t").Velocity.Set(0.1, 0.0);
  world.Step(20);
  const Real way = world.Position("t").Length();
  CHECK_THAT(way, WithinAbs(0.05 * 2.0, 1e-3 + type.Slip * 0.1));
  CHECK_THAT(std::atan2(world.Position("t").GetY(), world.Position("t").GetX()),
             WithinAbs(std::numbers::pi / 3.0, 0.01));
  CHECK_THAT(world.Yaw("t"), WithinAbs(std::numbers::pi / 3.0, 0.01));
}

TEST_CASE("users' models: an object resists with the friction of its model", "[contract][engine]") {
  const SEngineType type = GENERATE(from_range(kEnginesWithContacts));
  if (type.Ground != EGround::Force) {
    return;
  }
  // a beetle pushes with 1.5 N
  const bool isLight = GENERATE(true, false);
  CAPTURE(type, isLight);
  CDriveWorld world(type.ToXml(), DriverXml("beetle", "b", 0, 0, 0, 10, 10) +
                                      Placed("crate", "k", 0.3, 0, 0,
                                             isLight ? "friction='0.5'" : "friction='3'"));
  world.Step(60);
  const Real way = world.Position("k").GetX() - 0.3;
  if (isLight) {
    CHECK(way > 0.2);
  } else {
    // the impact moves it, see the README of dynamics2d
    CHECK(std::abs(way) < 0.01);
  }
}

TEST_CASE("users' models: immovable objects, and collisions", "[contract][engine]") {
  const SEngineType type = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(type);
  CDriveWorld world(type.ToXml(), DriverXml("beetle", "b", 0, 0, 0, 10, 10) +
                                      Placed("crate", "k", 0.3, 0, 0, "movable='false'"));
  world.Step(60);
  CHECK(world.Position("k") == CVector3(0.3, 0, 0));
  CHECK_THAT(world.Position("b").GetX(), WithinAbs(0.2 - BEETLE_RADIUS, 2e-3));
  CHECK_FALSE(world.Body("b").MoveTo(CVector3(0.25, 0, 0), CQuaternion()));
  CHECK(world.Body("b").MoveTo(CVector3(-1, 0, 0), CQuaternion()));
}

TEST_CASE("users' models: the engine takes a place of distributed objects", "[contract][engine]") {
  const SEngineType type = GENERATE(kDynamics2D, kKinematics2D);
  // it knows the shape only after the crate was added
  const std::string arena =
      "<distribute><position method='uniform' min='1,0,0' max='1,0,0'/><orientation "
      "method='constant' values='0,0,0'/><entity quantity='2' max_trials='3'>"
      "<crate id='k' movable='false'/></entity></distribute>";
  CHECK_THAT(LoadError(SExperiment{.Engines = type.ToXml(), .Arena = arena}),
             Contains("\"k1\" after 4 trials") && Contains("\"something in its engine\""));
}

TEST_CASE("users' models: a robot keeps its model in another engine of its type",
          "[contract][engine]") {
  const SEngineType type = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(type);
  CDriveWorld world(type.ToTwoXml(0.0), DriverXml("beetle", "b", -0.3, 0, 0, 10, 10));
  world.Step(51);
  CHECK(world.EngineOf("b") == "east");
  CHECK_THAT(world.Position("b").GetX(), WithinAbs(0.2, 0.015));
}

TEST_CASE("users' models: a robot gets another model in an engine of another type",
          "[contract][engine]") {
  const std::string west =
      "<kinematics2d id='west'><boundaries><sides><vertex point='-10,-10'/><vertex point='0,-10'/>"
      "<vertex point='0,10'/><vertex point='-10,10'/></sides></boundaries></kinematics2d>";
  const std::string east =
      "<dynamics2d id='east'><boundaries><sides><vertex point='0,-10'/><vertex point='10,-10'/>"
      "<vertex point='10,10'/><vertex point='0,10'/></sides></boundaries></dynamics2d>";
  CDriveWorld world(west + east, DriverXml("beetle", "b", -0.3, 0, 0, 10, 10));
  world.Step(51);
  CHECK(world.EngineOf("b") == "east");
  CHECK_THAT(world.Position("b").GetX(), WithinAbs(0.199, 1e-9));
  world.GetSimulator().Reset();
  world.Step(51);
  CHECK_THAT(world.Position("b").GetX(), WithinAbs(0.199, 1e-9));
}

TEST_CASE("users' models: an operation written by hand, with a gripper", "[contract][engine]") {
  const SEngineType type = GENERATE(from_range(kEnginesWithGrips));
  CAPTURE(type);
  CDriveWorld world(type.ToXml(), Placed("claw", "c", 0, 0) +
                                      Placed("crate", "k", 0.165, 0, 0, "friction='0.1'"));
  const SBodyDescription& description = DescriptionOf(world, "c");
  CHECK(description.Shapes.size() == 1);
  REQUIRE(description.Gripper.has_value());
  CHECK(description.Gripper->Offset == CVector3(0.06, 0, 0.02));
  CHECK(description.Gripper->SensorRadius == 0.01);
  REQUIRE(CClawModel::Current != nullptr);
  CDynamics2DGripper& gripper = CClawModel::Current->GetGripper();
  world.Step(2);
  CHECK(gripper.GetGrippee() == nullptr);
  world.Get<CClawEntity>("c").Gripper->SetLockState(1.0);
  world.Get<CClawEntity>("c").Speed = -0.05;
  world.Step(40);
  REQUIRE(gripper.IsGripping());
  REQUIRE(gripper.GetGrippee() != nullptr);
  CHECK(&gripper.GetGrippee()->GetEmbodiedEntity() == &world.Body("k"));
  CHECK(gripper.GetGrippee()->HasGrippers());
  CHECK(world.Position("k").GetX() < 0.05);
  gripper.GetGrippee()->ReleaseAll();
  world.Get<CClawEntity>("c").Gripper->SetLockState(0.0);
  world.Step(2);
  CHECK(gripper.GetGrippee() == nullptr);
}

TEST_CASE("users' models: what a record cannot express is refused", "[contract][engine]") {
  const SEngineType type = GENERATE(kDynamics2D, kKinematics2D);
  const auto [flaw, text] = GENERATE(table<std::string, std::string>({
      {"constraint", "cpPivotJointNew() cannot be recorded"},
      {"no_body", "CTugModel of \"t\" has no body: call SetBody() or AddBody()"},
      {"no_shape", "CTugModel of \"t\" has no shape: call cpSpaceAddShape()"},
      {"sensor", "CTugModel of \"t\" adds a sensor with cpSpaceAddShape()"},
      {"two_controls", "CTugModel of \"t\" calls AttachTo() for two bodies"},
      {"offset", "CTugModel of \"t\" calls AttachTo() for a body with an offset"},
      {"static", "CTugModel of \"t\" has a body of cpBodyNewStatic()"},
      {"polygon", "CTugModel of \"t\": the shape of cpPolyShapeNew() is no solid"},
      {"radius", "cpCircleShapeNew(): the radius (m) must be a number > 0, found 0"},
      {"mass", "cpBodyNew(): the mass (kg) must be a number > 0, found -1"},
  }));
  CAPTURE(type, flaw);
  CHECK_THAT(LoadError(SExperiment{.Engines = type.ToXml(),
                                   .Arena = Placed("tug", "t", 0, 0, 0, "flaw='" + flaw + "'")}),
             Contains(text) && Contains("t"));
}

}  // namespace argos::users_models_test
