#include <argos3/testing/benchmark/bare_box2d.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>

#include <box2d/box2d.h>

namespace argos::testing {

namespace {

// the settings of the engine, see its README: lengths are scaled so
// that a robot's radius is one unit
constexpr int kVelocityIterations = 8;
constexpr int kPositionIterations = 3;

}  // namespace

struct CBareBox2D::SState {
  struct SDisc {
    b2Body* Body;
    const SAnchor* Anchor;
    CVector3 Last;
    b2Vec2 Velocity;
  };

  b2World World{b2Vec2(0.0F, 0.0F)};
  std::vector<SDisc> Discs;
  float Scale = 1.0F;  // units per metre
  UInt32 Substeps = 1;
  Real TickLength = 0.1;  // s

  void AddWall(const CEmbodiedEntity& body, const SShapeDescription& shape) {
    b2BodyDef definition;
    const SAnchor& anchor = body.GetOriginAnchor();
    definition.position.Set(Scale * static_cast<float>(anchor.Position.GetX()),
                            Scale * static_cast<float>(anchor.Position.GetY()));
    b2PolygonShape box;
    box.SetAsBox(0.5F * Scale * static_cast<float>(shape.Size.GetX()),
                 0.5F * Scale * static_cast<float>(shape.Size.GetY()));
    World.CreateBody(&definition)->CreateFixture(&box, 0.0F);
  }

  void AddDisc(const CEmbodiedEntity& body, const SShapeDescription& shape) {
    const SAnchor& anchor = body.GetOriginAnchor();
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.allowSleep = false;
    definition.position.Set(Scale * static_cast<float>(anchor.Position.GetX()),
                            Scale * static_cast<float>(anchor.Position.GetY()));
    b2CircleShape circle;
    circle.m_radius = Scale * static_cast<float>(shape.Radius);
    b2Body* const disc = World.CreateBody(&definition);
    disc->CreateFixture(&circle, 1.0F);
    Discs.push_back({disc, &anchor, anchor.Position, b2Vec2(0.0F, 0.0F)});
  }
};

CBareBox2D::CBareBox2D(CSpace& space, UInt32 substeps, Real tick)
    : m_state(std::make_unique<SState>()) {
  m_state->Substeps = substeps;
  m_state->TickLength = tick;
  m_state->World.SetContinuousPhysics(false);
  const auto bodyOf = [](CEntity& root) -> CEmbodiedEntity& {
    return dynamic_cast<CComposableEntity&>(root).GetComponent<CEmbodiedEntity>("body");
  };
  const CControllableEntity& first = *space.GetControllableEntities().front();
  m_state->Scale = 1.0F / static_cast<float>(bodyOf(const_cast<CEntity&>(first.GetRootEntity()))
                                                 .GetBodyDescription()
                                                 ->ComputeBoundingRadius());
  for (CEntity* root : space.GetRootEntityVector()) {
    const CEmbodiedEntity& body = bodyOf(*root);
    const SShapeDescription& shape = body.GetBodyDescription()->Shapes.front();
    if (body.IsMovable()) {
      m_state->AddDisc(body, shape);
    } else {
      m_state->AddWall(body, shape);
    }
  }
}

CBareBox2D::~CBareBox2D() = default;

void CBareBox2D::TakeVelocities() {
  const Real scale = m_state->Scale / m_state->TickLength;
  for (SState::SDisc& disc : m_state->Discs) {
    const CVector3 moved = disc.Anchor->Position - disc.Last;
    disc.Last = disc.Anchor->Position;
    disc.Velocity.Set(static_cast<float>(scale * moved.GetX()),
                      static_cast<float>(scale * moved.GetY()));
  }
}

void CBareBox2D::Tick() {
  for (const SState::SDisc& disc : m_state->Discs) {
    disc.Body->SetLinearVelocity(disc.Velocity);
  }
  const float step =
      static_cast<float>(m_state->TickLength) / static_cast<float>(m_state->Substeps);
  for (UInt32 substep = 0; substep < m_state->Substeps; ++substep) {
    m_state->World.Step(step, kVelocityIterations, kPositionIterations);
  }
}

}  // namespace argos::testing
