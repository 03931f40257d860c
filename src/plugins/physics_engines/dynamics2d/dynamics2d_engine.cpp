#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_engine.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/body_description.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_shapes.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_world.h>
#include <argos3/plugins/simulator/physics_engines/planar/footprints.h>
#include <argos3/plugins/simulator/physics_engines/planar/ghost_discs.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_body.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace argos {

CDynamics2DEngine::CDynamics2DEngine() : m_settings(std::make_unique<SPlanarSettings>()) {
  SetIterations(kDefaultSubsteps);
}

CDynamics2DEngine::~CDynamics2DEngine() = default;

void CDynamics2DEngine::Init(TConfigurationNode& tree) {
  CPhysicsEngine::Init(tree);
  CheckIterations(tree, *this);
  m_elevation = ReadElevation(tree);
  ReadNotNegative(tree, "gripping_rigidity", m_grippingRigidity);
  ReadGroundFriction(tree, m_settings->BoxFriction, m_settings->CylinderFriction);
  if (NodeExists(tree, "spatial_hash")) {
    // tunes a broad phase that this engine does not have
    MarkSubtreeRead(GetNode(tree, "spatial_hash"));
  }
  m_settings->Tick = m_cSimulator.GetTickLength();
  m_settings->Substeps = GetIterations();
  m_settings->GrippingRigidity = m_grippingRigidity;
  // whoever asks for a number of substeps gets it
  m_settings->RefineInCrowds = !NodeAttributeExists(tree, "iterations");
}

// The world is made anew from the entities, in the next tick: nothing of the run so far is left in
// it, nor of where bodies were put before that tick.
void CDynamics2DEngine::Reset() {
  m_world.reset();
  while (!m_displaced.empty()) {
    ForgetDisplaced(*m_displaced.back());
  }
}

void CDynamics2DEngine::Destroy() {
  m_world.reset();
  m_models.clear();
  m_displaced.clear();
}

bool CDynamics2DEngine::IsAtHeight(const CEmbodiedEntity& body) const {
  return IsOnPlane(body, m_elevation);
}

std::string CDynamics2DEngine::ExplainRefusal(CEntity& entity) const {
  return ExplainPlanarRefusal(entity, m_elevation);
}

bool CDynamics2DEngine::AddEntity(CEntity& entity) {
  CEmbodiedEntity* const body = FindPlanarBody(entity);
  if (body == nullptr || !IsAtHeight(*body)) {
    return false;
  }
  CheckPlanarBody(*body);
  auto model = std::make_unique<CDynamics2DModel>(*this, *body, FindWheels(*body));
  body->AddPhysicsModel(GetId(), *model);
  AddModel(std::move(model));
  return true;
}

void CDynamics2DEngine::AddModel(std::unique_ptr<CDynamics2DModel> model) {
  model->m_number = m_models.size();
  m_models.push_back(std::move(model));
  if (m_world != nullptr) {
    AddToWorld(*m_models.back());
  }
}

bool CDynamics2DEngine::RemoveEntity(CEntity& entity) {
  CEmbodiedEntity* const body = FindPlanarBody(entity);
  for (UInt32 i = 0; body != nullptr && i < body->GetPhysicsModelsNum(); ++i) {
    if (&body->GetPhysicsModel(i).GetEngine() != this) {
      continue;
    }
    const auto model = TakeOut(static_cast<CDynamics2DModel&>(body->GetPhysicsModel(i)));
    body->RemovePhysicsModel(GetId());
    return true;
  }
  return false;
}

// the last model takes the number of the one that goes
std::unique_ptr<CDynamics2DModel> CDynamics2DEngine::TakeOut(CDynamics2DModel& model) {
  ForgetDisplaced(model);
  if (m_world != nullptr) {
    m_world->Remove(model.m_handle);
  }
  const size_t number = model.m_number;
  std::swap(m_models[number], m_models.back());
  m_models[number]->m_number = number;
  std::unique_ptr<CDynamics2DModel> taken = std::move(m_models.back());
  m_models.pop_back();
  return taken;
}

void CDynamics2DEngine::TransferEntity(CEmbodiedEntity& body) {
  if (&body.GetPhysicsModel(size_t(0)).GetEngine() != this) {
    return;
  }
  auto& model = static_cast<CDynamics2DModel&>(body.GetPhysicsModel(size_t(0)));
  CDynamics2DEngine* const next = FindNext(body);
  if (next == nullptr) {
    // grips end there
    CPhysicsEngine::TransferEntity(body);
  } else if (m_world != nullptr && m_world->IsInGrip(model.m_handle)) {
    TransferCluster(model, *next);
  } else {
    CheckPlanarBody(body);
    SBodyMotion motion;
    const bool hasMotion = GetMotion(body, motion);
    next->TakeOver(model);
    if (hasMotion) {
      next->SetMotion(body, motion);
    }
  }
}

bool CDynamics2DEngine::GetMotion(const CEmbodiedEntity& body, SBodyMotion& motion) const {
  if (m_world == nullptr) {
    return false;
  }
  const auto& model = static_cast<const CDynamics2DModel&>(body.GetPhysicsModel(size_t(0)));
  const SPlanarVelocity velocity = m_world->GetVelocity(model.m_handle);
  motion = {CVector3(velocity.X, velocity.Y, 0.0), CVector3(0.0, 0.0, velocity.W)};
  return true;
}

void CDynamics2DEngine::SetMotion(CEmbodiedEntity& body, const SBodyMotion& motion) {
  if (m_world != nullptr) {
    const auto& model = static_cast<CDynamics2DModel&>(body.GetPhysicsModel(size_t(0)));
    m_world->SetVelocity(model.m_handle,
                         {motion.Velocity.GetX(), motion.Velocity.GetY(), motion.Rotation.GetZ()});
  }
}

// Of all that hangs together with a body in grips, does it have the lowest index?
bool CDynamics2DEngine::LeadsItsCluster(const CDynamics2DModel& model) {
  m_world->FindCluster(model.m_handle, m_cluster);
  return std::none_of(m_cluster.begin(), m_cluster.end(), [&model](const SPlanarOwner& each) {
    return each.Model->m_cEmbodiedEntity.GetIndex() < model.m_cEmbodiedEntity.GetIndex();
  });
}

void CDynamics2DEngine::TransferCluster(CDynamics2DModel& model, CDynamics2DEngine& next) {
  m_world->FindCluster(model.m_handle, m_cluster);
  m_world->CopyGrips(m_cluster, m_grips);
  for (const SPlanarOwner& each : m_cluster) {
    CheckPlanarBody(each.Model->m_cEmbodiedEntity);
  }
  for (const SPlanarOwner& each : m_cluster) {
    const SPlanarVelocity velocity = m_world->GetVelocity(*each.Handle);
    // the model is made anew at the same place in memory
    next.TakeOver(*each.Model);
    if (next.m_world != nullptr) {
      next.m_world->SetVelocity(*each.Handle, velocity);
    }
  }
  for (const SGripToMove& grip : m_grips) {
    if (next.m_world != nullptr) {
      next.m_world->RestoreGrip(grip);
    }
  }
}

// the engine that would take the body, if it is of this type and certain to
CDynamics2DEngine* CDynamics2DEngine::FindNext(CEmbodiedEntity& body) const {
  auto* const next = dynamic_cast<CDynamics2DEngine*>(FindNextEngine(body));
  return next != nullptr && next != this && next->IsAtHeight(body) ? next : nullptr;
}

// Takes a movable body over from another engine of this type. Its model is made anew where it is,
// because models refer to their engine for ever, and a tick must not ask for memory.
void CDynamics2DEngine::TakeOver(CDynamics2DModel& model) {
  auto& from = static_cast<CDynamics2DEngine&>(model.GetEngine());
  std::unique_ptr<CDynamics2DModel> taken = from.TakeOut(model);
  CEmbodiedEntity& body = model.m_cEmbodiedEntity;
  const Real* const wheels = model.m_wheels;
  std::destroy_at(taken.get());
  std::construct_at(taken.get(), *this, body, wheels);
  body.MovePhysicsModel(from.GetId(), GetId(), *taken);
  AddModel(std::move(taken));
}

void CDynamics2DEngine::Replace(CDynamics2DModel& model) {
  ForgetDisplaced(model);
  if (m_world != nullptr) {
    m_world->Remove(model.m_handle);
    AddToWorld(model);
  }
}

void CDynamics2DEngine::MarkDisplaced(CDynamics2DModel& model) {
  if (m_world != nullptr && !model.m_isDisplaced) {
    model.m_isDisplaced = true;
    m_displaced.push_back(&model);
  }
}

void CDynamics2DEngine::ForgetDisplaced(CDynamics2DModel& model) {
  if (model.m_isDisplaced) {
    model.m_isDisplaced = false;
    // from the end, where it mostly is
    m_displaced.erase(std::find(m_displaced.rbegin(), m_displaced.rend(), &model).base() - 1);
  }
}

// Most have been put back by those who only wanted to know whether a place is free.
void CDynamics2DEngine::ReplaceDisplaced() {
  for (CDynamics2DModel* model : m_displaced) {
    model->m_isDisplaced = false;
    const SAnchor& origin = model->m_cEmbodiedEntity.GetOriginAnchor();
    if (!m_world->IsAt(model->m_handle, MakePlanarPose(origin.Position, origin.Orientation))) {
      Replace(*model);
    }
  }
  m_displaced.clear();
}

void CDynamics2DEngine::UpdateManipulator(CDynamics2DModel& model) {
  if (m_world != nullptr) {
    m_world->SetManipulator({&model, &model.m_handle},
                            *model.m_cEmbodiedEntity.GetBodyDescription(), model.m_gripper,
                            model.m_turret);
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
  const auto count = [&models](bool movable, bool driven) {
    return static_cast<size_t>(
        std::count_if(models.begin(), models.end(), [=](const CDynamics2DModel* model) {
          return model->GetEmbodiedEntity().IsMovable() == movable &&
                 (model->m_wheels != nullptr) == driven;
        }));
  };
  // movable bodies may also come from other engines; room that is not used costs no memory
  const auto withComers = [this](size_t bodies) {
    return IsEntityTransferActive() ? bodies + bodies / 2 + kRoomForComers : bodies;
  };
  m_models.reserve(withComers(m_models.size()));
  m_world->MakeRoom(count(false, false), withComers(count(true, false)),
                    withComers(count(true, true)));
  for (CDynamics2DModel* model : models) {
    AddToWorld(*model);
  }
  // faces of the region that are walls
  const std::vector<SWallSlab> walls = GetVolume().DescribeWalls();
  m_walls.assign(walls.size(), SPlanarHandle());
  for (size_t i = 0; i < walls.size(); ++i) {
    m_world->AddImmovable({nullptr, &m_walls[i]}, *walls[i].Description,
                          MakePlanarPose(walls[i].Position, walls[i].Orientation));
  }
  m_world->Reserve();
}

Real CDynamics2DEngine::GetGhostReach() const {
  return m_world != nullptr ? m_world->ComputeGhostReach() : CPhysicsEngine::GetGhostReach();
}

// Box2D is tuned for bodies of about its unit of length
Real CDynamics2DEngine::ChooseScale() const {
  Real smallest = 0.0;
  for (const auto& model : m_models) {
    if (model->GetEmbodiedEntity().IsMovable()) {
      const Real half = ComputeNarrowestHalf(*model->GetEmbodiedEntity().GetBodyDescription());
      smallest = smallest > 0.0 ? std::min(smallest, half) : half;
    }
  }
  return smallest > 0.0 ? kSmallestRadiusInUnits / smallest : kDefaultUnitsPerMetre;
}

void CDynamics2DEngine::AddToWorld(CDynamics2DModel& model) {
  const CEmbodiedEntity& body = model.GetEmbodiedEntity();
  const SBodyDescription& description = *body.GetBodyDescription();
  const SAnchor& origin = body.GetOriginAnchor();
  const SPlanarPose pose = MakePlanarPose(origin.Position, origin.Orientation);
  const SPlanarOwner owner{&model, &model.m_handle};
  if (!body.IsMovable()) {
    m_world->AddImmovable(owner, description, pose);
  } else if (model.m_wheels != nullptr) {
    m_world->AddDriven(owner, description, pose, model.m_wheels);
    m_world->SetManipulator(owner, description, model.m_gripper, model.m_turret);
  } else {
    m_world->AddPassive(owner, description, pose);
  }
}

void CDynamics2DEngine::Update() {
  if (m_world == nullptr) {
    Build();
  }
  ReplaceDisplaced();
  if (FeelsGhosts()) {
    ListGhostDiscs(*this, m_elevation, m_ghostDiscs);
    m_world->SetGhosts(m_ghostDiscs);
  }
  try {
    m_world->Advance();
  } catch (const SBadWheelSpeed& bad) {
    THROW_ARGOSEXCEPTION("robot \"" << bad.Owner->GetEmbodiedEntity().GetRootEntity().GetId()
                                    << "\": wheel speeds must be finite numbers, found left = "
                                    << bad.Left << " m/s, right = " << bad.Right << " m/s");
  }
  m_world->CommitDriven(
      [this](const SDrivenBody& body) { WriteBack(*body.Owner.Model, body.Pose); },
      [](const CDynamics2DModel& model, int stage) {
        if (stage == 0) {
          model.m_cEmbodiedEntity.PrefetchPose();
        } else {
          model.m_cEmbodiedEntity.PrefetchIndexedPose();
        }
      });
  m_world->ForEachPassive([this](const SPassiveBody& body) {
    if (body.Moved) {
      WriteBack(*body.Owner.Model, body.Pose);
    }
  });
}

void CDynamics2DEngine::WriteBack(CDynamics2DModel& model, const SPlanarPose& pose) {
  CEmbodiedEntity& body = model.m_cEmbodiedEntity;
  body.SetOriginPose(CVector3(pose.X, pose.Y, m_elevation),
                     CQuaternion(pose.HalfCos, 0.0, 0.0, pose.HalfSin));
  if (body.GetEnabledAnchors().size() > 1) {
    model.CalculateAnchors();
  }
  model.m_sBoundingBox = ComputePlanarBounds(body, pose);
  if (body.HasFollowers()) {
    model.m_root.Update();
  }
  if (IsEntityTransferActive() && !IsPointContained(body.GetOriginAnchor().Position) &&
      (!m_world->IsInGrip(model.m_handle) || LeadsItsCluster(model))) {
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
  iterations                 integer >= 1: substeps of a tick. Not given: 2, and up to 64 where a crowd is
                             so deep that robots would overlap. In any case more, up to 64, while
                             something moves by more than half its radius in a substep. 64 substeps are
                             also what bounds speeds: a robot goes at most 32 radii in a tick.
  elevation                  m, default 0: height of the plane; bodies must stand on it, to 1e-4 m.
  gripping_rigidity          N/m, >= 0, default 10000: stiffness of grips, along the arm from the robot's
                             centre to the point that is gripped; 0: grippers hold nothing.
  box_linear_friction        N, >= 0, default 1.49: most the ground brakes a movable box.
  box_angular_friction       N m, >= 0, default 1.49: most the ground brakes its turning.
  cylinder_linear_friction   N, >= 0, default 1.49: the same for a movable cylinder.
  cylinder_angular_friction  N m, >= 0, default 1.49.
  boundaries                 the region of the engine, default everything: sides/vertex@point, in m, at
                             least three, counter-clockwise, convex. A vertex may have wall="true", which
                             stops bodies at the side from there to the next vertex, or gate="id", which
                             hands those that cross it to that engine (doc/space_partitioning.md).
  ghosts                     true or false, default true: robots of other engines near the border are felt.
  spatial_hash               accepted and ignored.
)",
    "Usable")

}  // namespace argos
