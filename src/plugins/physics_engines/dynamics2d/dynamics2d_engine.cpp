#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_engine.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/body_description.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_world.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// m; positions in files are rounded, robots stand on the plane
constexpr Real kElevationTolerance = 1e-4;

// reads a number that must not be negative
void ReadNotNegative(TConfigurationNode& node, const std::string& attribute, Real& value) {
  GetNodeAttributeOrDefault(node, attribute, value, value);
  if (!(value >= 0.0) || std::isinf(value)) {
    THROW_ARGOSEXCEPTION(node.GetLocation() << ": <" << node.Value() << ">: \"" << attribute
                                            << "\" must be a number >= 0, found " << value);
  }
}

// the body of a root entity, if it is one that this engine can build
CEmbodiedEntity* FindBody(CEntity& root) {
  auto* composable = dynamic_cast<CComposableEntity*>(&root);
  if (composable == nullptr || !composable->HasComponent("body")) {
    return nullptr;
  }
  auto& body = composable->GetComponent<CEmbodiedEntity>("body");
  const SBodyDescription* description = body.GetBodyDescription();
  const bool upright = description != nullptr && !description->Shapes.empty();
  return upright ? &body : nullptr;
}

}  // namespace

CDynamics2DEngine::CDynamics2DEngine() : m_settings(std::make_unique<SPlanarSettings>()) {
  SetIterations(kDefaultSubsteps);
}

CDynamics2DEngine::~CDynamics2DEngine() = default;

void CDynamics2DEngine::Init(TConfigurationNode& tree) {
  CPhysicsEngine::Init(tree);
  GetNodeAttributeOrDefault(tree, "elevation", m_elevation, m_elevation);
  ReadNotNegative(tree, "gripping_rigidity", m_grippingRigidity);
  if (NodeExists(tree, "friction")) {
    TConfigurationNode& node = GetNode(tree, "friction");
    ReadNotNegative(node, "box_linear_friction", m_settings->BoxFriction.Force);
    ReadNotNegative(node, "box_angular_friction", m_settings->BoxFriction.Torque);
    ReadNotNegative(node, "cylinder_linear_friction", m_settings->CylinderFriction.Force);
    ReadNotNegative(node, "cylinder_angular_friction", m_settings->CylinderFriction.Torque);
  }
  if (NodeExists(tree, "spatial_hash")) {
    // tunes a broad phase that this engine does not have
    MarkSubtreeRead(GetNode(tree, "spatial_hash"));
  }
  m_settings->Tick = m_cSimulator.GetTickLength();
  m_settings->Substeps = GetIterations();
}

void CDynamics2DEngine::PostSpaceInit() {
  Build();
}

// the world is made anew, from the entities: nothing of the run so far is left in it
void CDynamics2DEngine::Reset() {
  m_world.reset();
}

void CDynamics2DEngine::Destroy() {
  m_world.reset();
  m_models.clear();
}

bool CDynamics2DEngine::IsPointContained(const CVector3& point) {
  return std::abs(point.GetZ() - m_elevation) <= kElevationTolerance &&
         CPhysicsEngine::IsPointContained(point);
}

bool CDynamics2DEngine::AddEntity(CEntity& entity) {
  CEmbodiedEntity* const body = FindBody(entity);
  if (body == nullptr) {
    return false;
  }
  auto model = std::make_unique<CDynamics2DModel>(*this, *body);
  model->m_number = m_models.size();
  body->AddPhysicsModel(GetId(), *model);
  m_models.push_back(std::move(model));
  if (m_world != nullptr) {
    AddToWorld(*m_models.back());
  }
  return true;
}

bool CDynamics2DEngine::RemoveEntity(CEntity& entity) {
  CEmbodiedEntity* const body = FindBody(entity);
  for (UInt32 i = 0; body != nullptr && i < body->GetPhysicsModelsNum(); ++i) {
    if (&body->GetPhysicsModel(i).GetEngine() != this) {
      continue;
    }
    auto& model = static_cast<CDynamics2DModel&>(body->GetPhysicsModel(i));
    if (m_world != nullptr) {
      m_world->Remove(model.m_handle);
    }
    body->RemovePhysicsModel(GetId());
    const size_t number = model.m_number;
    std::swap(m_models[number], m_models.back());
    m_models[number]->m_number = number;
    m_models.pop_back();
    return true;
  }
  return false;
}

void CDynamics2DEngine::Replace(CDynamics2DModel& model) {
  if (m_world != nullptr) {
    m_world->Remove(model.m_handle);
    AddToWorld(model);
  }
}

// bodies enter the world in the order of their entities, whatever happened before
void CDynamics2DEngine::Build() {
  std::vector<CDynamics2DModel*> models;
  models.reserve(m_models.size());
  for (const auto& model : m_models) {
    models.push_back(model.get());
  }
  std::sort(models.begin(), models.end(), [](CDynamics2DModel* a, CDynamics2DModel* b) {
    return a->GetEmbodiedEntity().GetIndex() < b->GetEmbodiedEntity().GetIndex();
  });
  m_settings->UnitsPerMetre = ChooseScale();
  m_world = std::make_unique<CPlanarWorld>(*m_settings);
  for (CDynamics2DModel* model : models) {
    AddToWorld(*model);
  }
  m_world->Reserve();
}

Real CDynamics2DEngine::ChooseScale() const {
  Real smallest = 0.0;
  for (const auto& model : m_models) {
    if (model->GetEmbodiedEntity().IsMovable()) {
      const Real radius = model->GetEmbodiedEntity().GetBodyDescription()->ComputeBoundingRadius();
      smallest = smallest > 0.0 ? std::min(smallest, radius) : radius;
    }
  }
  return smallest > 0.0 ? kSmallestRadiusInUnits / smallest : kDefaultUnitsPerMetre;
}

void CDynamics2DEngine::AddToWorld(CDynamics2DModel& model) {
  CEmbodiedEntity& body = model.GetEmbodiedEntity();
  const SBodyDescription& description = *body.GetBodyDescription();
  const SAnchor& origin = body.GetOriginAnchor();
  // of the orientation only the yaw is kept
  const Real w = origin.Orientation.GetW();
  const Real z = origin.Orientation.GetZ();
  const Real length = std::hypot(w, z);
  const SPlanarPose pose{origin.Position.GetX(), origin.Position.GetY(),
                         length > 0.0 ? w / length : 1.0, length > 0.0 ? z / length : 0.0};
  const SPlanarOwner owner{&model, &model.m_handle};
  if (!body.IsMovable()) {
    m_world->AddImmovable(owner, description, pose);
  } else if (description.Drive) {
    auto& root = static_cast<CComposableEntity&>(body.GetRootEntity());
    const auto& wheels = root.GetComponent<CWheeledEntity>("wheels");
    m_world->AddDriven(owner, description, pose, wheels.GetWheelVelocities());
  } else {
    m_world->AddPassive(owner, description, pose);
  }
}

void CDynamics2DEngine::Update() {
  if (m_world == nullptr) {
    Build();
  }
  try {
    m_world->Advance();
  } catch (const SBadWheelSpeed& bad) {
    THROW_ARGOSEXCEPTION("robot \"" << bad.Owner->GetEmbodiedEntity().GetRootEntity().GetId()
                                    << "\": wheel speeds must be finite numbers, found left = "
                                    << bad.Left << " m/s, right = " << bad.Right << " m/s");
  }
  m_world->CommitDriven([this](const SDrivenBody& body) {
    WriteBack(*body.Owner.Model, body.Pose.X, body.Pose.Y, body.Pose.HalfCos, body.Pose.HalfSin);
  });
  m_world->ForEachPassive([this](const SPassiveBody& body) {
    if (body.Moved) {
      WriteBack(*body.Owner.Model, body.Pose.X, body.Pose.Y, body.Pose.HalfCos, body.Pose.HalfSin);
    }
  });
}

void CDynamics2DEngine::WriteBack(CDynamics2DModel& model, Real x, Real y, Real halfCos,
                                  Real halfSin) {
  CEmbodiedEntity& body = model.m_cEmbodiedEntity;
  body.SetOriginPose(CVector3(x, y, m_elevation), CQuaternion(halfCos, 0.0, 0.0, halfSin));
  if (body.GetEnabledAnchors().size() > 1) {
    model.CalculateAnchors();
  }
  model.CalculateBoundingBox();
  body.GetRootEntity().Update();
  if (GetVolume().IsActive() && !IsPointContained(body.GetOriginAnchor().Position)) {
    ScheduleEntityForTransfer(body);
  }
}

REGISTER_PHYSICS_ENGINE(
    CDynamics2DEngine, "dynamics2d", "the authors of this project", "1.0",
    "Rigid bodies on a plane, on Box2D.",
    R"(Robots and objects on a horizontal plane: they push, slide, stall and slip. Only the yaw of a body is
kept. Robots that touch nothing follow the exact arc of their wheel speeds.

REQUIRED XML

  <physics_engines>
    <dynamics2d id="dyn2d" />
  </physics_engines>

OPTIONAL XML

  <physics_engines>
    <dynamics2d id="dyn2d" iterations="2" elevation="0" gripping_rigidity="10000">
      <friction box_linear_friction="1.49" box_angular_friction="1.49"
                cylinder_linear_friction="1.49" cylinder_angular_friction="1.49" />
      <boundaries>
        <sides>
          <vertex point="0,0" /> <vertex point="5,0" /> <vertex point="5,5" /> <vertex point="0,5" />
        </sides>
      </boundaries>
    </dynamics2d>
  </physics_engines>

ATTRIBUTES

  id                         text, required: unique among the engines.
  iterations                 integer >= 1, default 2: substeps of a tick.
  elevation                  m, default 0: height of the plane; only bodies at this height live here.
  gripping_rigidity          N/m, >= 0, default 10000: stiffness of what holds a gripped object.
  box_linear_friction        N, >= 0, default 1.49: most the ground brakes a movable box.
  box_angular_friction       N m, >= 0, default 1.49: most the ground brakes its turning.
  cylinder_linear_friction   N, >= 0, default 1.49: the same for a movable cylinder.
  cylinder_angular_friction  N m, >= 0, default 1.49.
  boundaries                 the region of the engine, default everything: sides/vertex@point, in m, at
                             least three, counter-clockwise, convex.
  spatial_hash               accepted and ignored.
)",
    "Usable")

}  // namespace argos
