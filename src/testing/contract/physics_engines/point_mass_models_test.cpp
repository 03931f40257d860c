// Models of users in the engine pointmass3d: bodies with their own laws of motion.

#include <argos3/plugins/simulator/media/line_of_sight.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_engine.h>
#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_model.h>
#include <argos3/testing/support/experiment.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace argos::point_mass_models_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kRadius = 0.1;  // m

}  // namespace

/** A thrown ball; its body has no description, only a model. */
class CBallEntity : public CComposableEntity {
 public:
  ENABLE_VTABLE();

  CBallEntity() : CComposableEntity(nullptr) { AddBody(CVector3()); }
  CBallEntity(const std::string& id, const CVector3& position) : CComposableEntity(nullptr, id) {
    AddBody(position);
  }

  void Init(TConfigurationNode& tree) override {
    CComposableEntity::Init(tree);
    m_body->Init(GetNode(tree, "body"));
    GetNodeAttributeOrDefault(tree, "velocity", Velocity, Velocity);
  }
  std::string GetTypeDescription() const override { return "ball"; }
  CEmbodiedEntity& GetEmbodiedEntity() { return *m_body; }

  CVector3 Velocity;  // m/s, at the start

 private:
  void AddBody(const CVector3& position) {
    auto body = std::make_unique<CEmbodiedEntity>(this, "body_0", position);
    m_body = body.get();
    AddComponent(*body.release());
  }
  CEmbodiedEntity* m_body = nullptr;
};

/** Model of a thrown ball; every step is a parabola, so that steps add up exactly. */
class CBallModel : public CPointMass3DModel {
 public:
  CBallModel(CPointMass3DEngine& engine, CBallEntity& ball)
      : CPointMass3DModel(engine, ball.GetEmbodiedEntity()), m_ball(ball) {
    Reset();
  }

  void Reset() override {
    CPointMass3DModel::Reset();
    m_cVelocity = m_ball.Velocity;
    m_cAcceleration = CVector3(0.0, 0.0, m_cPM3DEngine.GetGravity());
  }
  void UpdateFromEntityStatus() override {}
  void Step() override {
    const Real step = m_cPM3DEngine.GetPhysicsClockTick();
    m_cPosition += m_cVelocity * step + m_cAcceleration * (0.5 * step * step);
    m_cVelocity += m_cAcceleration * step;
  }
  void CalculateBoundingBox() override {
    const CVector3 half(kRadius, kRadius, kRadius);
    m_sBoundingBox.MinCorner = m_cPosition - half;
    m_sBoundingBox.MaxCorner = m_cPosition + half;
  }
  bool CheckIntersectionWithRay(Real& tOnRay, const CRay3& ray) const override {
    // along x only, which is sufficient for these tests
    const CVector3 d = ray.GetEnd() - ray.GetStart();
    const CVector3 p = ray.GetStart() - m_cPosition;
    const Real aside = std::hypot(p.GetY(), p.GetZ());
    if (aside > kRadius) {
      return false;
    }
    tOnRay = (-p.GetX() - std::sqrt(kRadius * kRadius - aside * aside)) / d.GetX();
    return tOnRay >= 0.0 && tOnRay <= 1.0;
  }

 private:
  CBallEntity& m_ball;
};

REGISTER_ENTITY(CBallEntity, "ball", "a test", "1.0", "A ball.", "Thrown.", "Usable")
REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CBallEntity)
REGISTER_STANDARD_POINTMASS3D_OPERATIONS_ON_ENTITY(CBallEntity, CBallModel)

/** Has neither a description nor a model. */
class CLumpEntity : public CBallEntity {
 public:
  ENABLE_VTABLE();
  std::string GetTypeDescription() const override { return "lump"; }
};

REGISTER_ENTITY(CLumpEntity, "lump", "a test", "1.0", "A lump.", "No engine accepts it.", "Usable")
REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CLumpEntity)

namespace {

class CBallWorld : public CTestWorld {
 public:
  explicit CBallWorld(const std::string& arena)
      : CTestWorld(SExperiment{.Engines = "<pointmass3d id='e'/>", .Arena = arena}),
        m_scope(GetSimulator()) {}
  CEmbodiedEntity& Body(const std::string& id) {
    return Get<CComposableEntity>(id).GetComponent<CEmbodiedEntity>("body");
  }
  CVector3 Position(const std::string& id) { return Body(id).GetOriginAnchor().Position; }
  CPointMass3DEngine& GetEngine() {
    return dynamic_cast<CPointMass3DEngine&>(*GetSimulator().GetPhysicsEngines().front());
  }

 private:
  CSimulator::CScope m_scope;
};

const std::string kBall = "<ball id='b' velocity='1,0,4'><body position='0,0,1'/></ball>";

// position of the ball after a time, s
CVector3 Parabola(Real time) {
  return CVector3(time, 0.0, 1.0 + 4.0 * time - 0.5 * 9.81 * time * time);
}

}  // namespace

TEST_CASE("users' models: a thrown ball flies a parabola", "[contract][engine]") {
  CBallWorld world(kBall);
  for (int tick = 1; tick <= 12; ++tick) {
    world.Step();
    CHECK_THAT(Distance(world.Position("b"), Parabola(0.1 * tick)), WithinAbs(0.0, 1e-12));
    CHECK_THAT(world.Body("b").GetBoundingBox().MaxCorner.GetZ(),
               WithinAbs(Parabola(0.1 * tick).GetZ() + kRadius, 1e-12));
  }
  world.GetSimulator().Reset();
  CHECK(world.Position("b") == CVector3(0, 0, 1));
  world.Step();
  CHECK_THAT(Distance(world.Position("b"), Parabola(0.1)), WithinAbs(0.0, 1e-12));
}

TEST_CASE("users' models: rays hit them, and described bodies as well", "[contract][engine]") {
  CBallWorld world(kBall +
                   "<box id='wall' size='0.2,4,5' movable='false'><body position='5,0,0'/></box>");
  const auto look = [](Real z) {
    SEmbodiedEntityIntersectionItem item;
    GetClosestEmbodiedEntityIntersectedByRay(item, CRay3(CVector3(-4, 0, z), CVector3(6, 0, z)));
    return item;
  };
  CHECK(world.GetEngine().HasBodiesOutsideIndex());
  CHECK(look(1.0).IntersectedEntity == &world.Body("b"));
  CHECK_THAT(10.0 * look(1.0).TOnRay, WithinAbs(4.0 - kRadius, 1e-12));
  CHECK(look(2.0).IntersectedEntity == &world.Body("wall"));
  world.Step();
  CHECK(look(1.0).IntersectedEntity == &world.Body("wall"));
  const CVector3 position = Parabola(0.1);
  CHECK_THAT(10.0 * look(position.GetZ()).TOnRay,
             WithinAbs(4.0 + position.GetX() - kRadius, 1e-12));
}

TEST_CASE("users' models: can be added, collide, be moved and be removed", "[contract][engine]") {
  CBallWorld world(
      "<box id='box' size='1,1,1' movable='true' mass='1'><body position='3,0,0'/>"
      "</box>");
  CLoopFunctions& functions = world.GetSimulator().GetLoopFunctions();
  functions.AddEntity(*std::make_unique<CBallEntity>("b", CVector3(0, 0, 1)).release());
  CHECK(world.GetEngine().GetNumPhysicsModels() == 2);
  // the box extends from 2.5 to 3.5
  CHECK_FALSE(world.Body("b").MoveTo(CVector3(2.45, 0, 0.5), CQuaternion()));
  CHECK(world.Position("b") == CVector3(0, 0, 1));
  CHECK(world.Body("b").MoveTo(CVector3(2.35, 0, 0.5), CQuaternion()));
  CHECK(world.Position("b") == CVector3(2.35, 0, 0.5));
  world.Step();
  // the ball is at rest at first and then falls vertically
  CHECK_THAT(world.Position("b").GetX(), WithinAbs(2.35, 1e-12));
  functions.RemoveEntity("b");
  CHECK(world.GetEngine().GetNumPhysicsModels() == 1);
  CHECK_FALSE(world.GetEngine().HasBodiesOutsideIndex());
  CHECK_THROWS_WITH(world.GetEngine().RemovePhysicsModel("b"),
                    Contains("the physics engine \"e\" has no model of \"b\""));
  world.Step();
}

TEST_CASE("users' models: an entity with neither description nor model is refused with the reason",
          "[contract][engine]") {
  CHECK_THROWS_WITH(CBallWorld("<lump id='l'><body position='0,0,1'/></lump>"),
                    Catch::Contains("accepts only bodies with an SBodyDescription") &&
                        Catch::Contains("<lump> has neither"));
}

TEST_CASE("users' models: they occlude lines of sight, but for those behind the end",
          "[contract][engine]") {
  const auto ball = [](const std::string& id, Real x) {
    return "<ball id='" + id + "'><body position='" + std::to_string(x) + ",0,1'/></ball>";
  };
  CBallWorld world(ball("eye", -3.0) + ball("between", 0.0) + ball("seen", 2.0) +
                   ball("behind", 2.3));
  const CLineOfSight sight(world.GetSpace());
  const auto isClear = [&](const std::string& from, const std::string& to, Real start, Real end,
                           Real height) {
    return sight.IsClear(CRay3(CVector3(start, 0, height), CVector3(end, 0, height)),
                         world.Body(from), world.Body(to));
  };
  CHECK_FALSE(isClear("eye", "seen", -3.0, 2.0, 1.0));
  CHECK(isClear("eye", "between", -3.0, 0.0, 1.0));
  CHECK(isClear("between", "seen", 0.0, 2.0, 1.0));
  // a line that ends inside of the next ball has entered the one at its end before
  CHECK(isClear("between", "seen", 0.0, 2.5, 1.0));
  CHECK_FALSE(isClear("between", "behind", 0.0, 2.5, 1.0));
  // above them
  CHECK(isClear("eye", "seen", -3.0, 2.0, 1.11));
}

TEST_CASE("users' models: described bodies occlude lines between two of them",
          "[contract][engine]") {
  const auto ball = [](const std::string& id, Real x) {
    return "<ball id='" + id + "'><body position='" + std::to_string(x) + ",0,1'/></ball>";
  };
  CBallWorld walled(ball("eye", -3.0) + ball("seen", 2.0) +
                    "<box id='wall' size='0.2,4,5' movable='false'><body position='0,0,0'/></box>");
  const CLineOfSight sight(walled.GetSpace());
  const auto isFree = [&](Real end) {
    return sight.IsClear(CRay3(CVector3(-3, 0, 1), CVector3(end, 0, 1)), walled.Body("eye"),
                         walled.Body("seen"));
  };
  CHECK_FALSE(isFree(2.0));
  CHECK(isFree(-0.11));
}

}  // namespace argos::point_mass_models_test
