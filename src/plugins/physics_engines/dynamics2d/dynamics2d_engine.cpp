#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_engine.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/memory/load_ahead.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_body.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_world.h>
#include <argos3/plugins/simulator/physics_engines/planar/footprints.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_body.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/engine_manual.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/robot_components.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace argos {

namespace {

// with fewer robots, to wake threads takes longer than what they do
constexpr size_t kRobotsForThreads = 2000;
// bodies that a thread writes back in a chunk
constexpr size_t kWriteGrain = 512;
// bodies between prefetching and writing
constexpr size_t kWriteAhead = 8;

}  // namespace

CDynamics2DEngine::CDynamics2DEngine()
    : m_settings(std::make_unique<SPlanarSettings>()),
      m_alone(std::make_unique<CThreadPool>(0, std::make_unique<CBalanceQuantitySchedule>())) {
  SetIterations(kDefaultSubsteps);
}

CDynamics2DEngine::~CDynamics2DEngine() = default;

void CDynamics2DEngine::Init(TConfigurationNode& tree) {
  CPlanarEngine::Init(tree);
  ReadNotNegative(tree, "gripping_rigidity", m_grippingRigidity);
  ReadGroundFriction(tree, m_settings->BoxFriction, m_settings->CylinderFriction);
  m_settings->Tick = m_cSimulator.GetTickLength();
  m_settings->VelocityLag = GetVelocityLag();
  m_settings->Substeps = GetIterations();
  m_settings->GrippingRigidity = m_grippingRigidity;
  // an explicit number of substeps is not refined
  m_settings->RefineInCrowds = !NodeAttributeExists(tree, "iterations");
}

// The next tick builds a new world from the entities, without any state of the run so far.
void CDynamics2DEngine::Reset() {
  ResetRecordedBodies();
  DropWorld();
  ForgetDisplaced();
}

void CDynamics2DEngine::DropWorld() {
  m_world.reset();
}

void CDynamics2DEngine::Destroy() {
  m_world.reset();
  DestroyModels();
}

std::unique_ptr<CDescribedBodyModel> CDynamics2DEngine::CreateModel(CEmbodiedEntity& body,
                                                                    const CRecordedBody* recorded) {
  return std::make_unique<CDynamics2DBody>(*this, body, FindDrive(body, recorded));
}

CDynamics2DBody& CDynamics2DEngine::GetModel(const CEmbodiedEntity& body) const {
  return static_cast<CDynamics2DBody&>(*FindModel(body));
}

void CDynamics2DEngine::Enter(CDescribedBodyModel& model) {
  if (m_world != nullptr) {
    AddToWorld(static_cast<CDynamics2DBody&>(model));
  }
}

void CDynamics2DEngine::Leave(CDescribedBodyModel& model) {
  if (m_world != nullptr) {
    m_world->Remove(static_cast<CDynamics2DBody&>(model).m_handle);
  }
}

void CDynamics2DEngine::Reposition(CDescribedBodyModel& model) {
  auto& displaced = static_cast<CDynamics2DBody&>(model);
  m_world->Remove(displaced.m_handle);
  AddToWorld(displaced);
}

bool CDynamics2DEngine::IsAtLastPose(const CDescribedBodyModel& model) const {
  const SAnchor& origin = model.GetEmbodiedEntity().GetOriginAnchor();
  return m_world->IsAt(static_cast<const CDynamics2DBody&>(model).m_handle,
                       MakePlanarPose(origin.Position, origin.Orientation), GetFrameOrigin());
}

void CDynamics2DEngine::FindCluster(CEmbodiedEntity& body, TBodies& cluster) const {
  if (m_world != nullptr && m_world->GetGrips().IsInGrip(GetModel(body).m_handle)) {
    m_world->GetGrips().FindCluster(body, cluster);
  } else {
    CPlanarEngine::FindCluster(body, cluster);
  }
}

void CDynamics2DEngine::CopyGrips(const TBodies& cluster, std::vector<SGripTransfer>& grips) const {
  grips.clear();
  if (m_world != nullptr) {
    m_world->GetGrips().CopyGrips(cluster, grips);
  }
}

void CDynamics2DEngine::RestoreGrip(const SGripTransfer& grip) {
  if (m_world != nullptr) {
    m_world->GetGrips().RestoreGrip(grip, GetModel(*grip.Holder).m_handle,
                                    GetModel(*grip.Held).m_handle);
  }
}

bool CDynamics2DEngine::GetMotion(const CEmbodiedEntity& body, SBodyMotion& motion) const {
  if (m_world == nullptr) {
    return false;
  }
  const SPlanarHandle& handle = GetModel(body).m_handle;
  const SPlanarVelocity velocity = m_world->GetVelocity(handle);
  motion.Velocity = CVector3(velocity.X, velocity.Y, 0.0);
  motion.Rotation = CVector3(0.0, 0.0, velocity.W);
  motion.Command = m_world->GetLastCommand(handle);
  return true;
}

void CDynamics2DEngine::SetMotion(CEmbodiedEntity& body, const SBodyMotion& motion) {
  CRobotsCode::CheckShared("CPhysicsEngine::SetMotion()");
  if (m_world != nullptr) {
    const SPlanarHandle& handle = GetModel(body).m_handle;
    m_world->SetVelocity(handle,
                         {motion.Velocity.GetX(), motion.Velocity.GetY(), motion.Rotation.GetZ()});
    m_world->SetLastCommand(handle, FindCommand(motion, body));
  }
}

void CDynamics2DEngine::UpdateManipulator(CPlanarModel& model) {
  if (m_world != nullptr) {
    auto& robot = static_cast<CDynamics2DBody&>(model);
    m_world->GetGrips().SetManipulator({&robot, &robot.m_cEmbodiedEntity, &robot.m_handle},
                                       *robot.m_cEmbodiedEntity.GetBodyDescription(),
                                       robot.m_gripper, robot.m_turret);
  }
}

void CDynamics2DEngine::Build() {
  const std::vector<CDescribedBodyModel*> models = ListModelsForWorld();
  m_settings->SmallestRadius = ComputeSmallestRadius();
  m_settings->Period = GetPeriod();
  m_isPeriodic = m_settings->Period.IsOn();
  m_world = std::make_unique<CPlanarWorld>(*m_settings);
  const auto count = [&models](bool movable, bool driven) {
    return static_cast<size_t>(
        std::count_if(models.begin(), models.end(), [=](const CDescribedBodyModel* model) {
          const auto& body = static_cast<const CDynamics2DBody&>(*model);
          return body.m_cEmbodiedEntity.IsMovable() == movable &&
                 static_cast<bool>(body.m_drive) == driven;
        }));
  };
  m_world->Reserve(count(false, false), AddSpareCapacity(count(true, false)),
                   AddSpareCapacity(count(true, true)));
  for (CDescribedBodyModel* model : models) {
    AddToWorld(static_cast<CDynamics2DBody&>(*model));
  }
  // faces of the region that are walls
  const std::vector<SWallSlab> walls = GetVolume().DescribeWalls();
  m_walls.assign(walls.size(), SPlanarHandle());
  for (size_t i = 0; i < walls.size(); ++i) {
    m_world->AddImmovable({nullptr, nullptr, &m_walls[i]}, *walls[i].Description,
                          ToFrame(MakePlanarPose(walls[i].Position, walls[i].Orientation)));
  }
  m_world->ReserveForTick();
}

Real CDynamics2DEngine::GetGhostReach() const {
  return m_world != nullptr ? m_world->ComputeGhostReach() : CPhysicsEngine::GetGhostReach();
}

Real CDynamics2DEngine::ComputeSmallestRadius() const {
  Real smallest = 0.0;
  for (const auto& model : GetModels()) {
    if (model->GetEmbodiedEntity().IsMovable()) {
      const Real half = ComputeNarrowestHalf(*model->GetEmbodiedEntity().GetBodyDescription());
      smallest = smallest > 0.0 ? std::min(smallest, half) : half;
    }
  }
  return smallest > 0.0 ? smallest : SPlanarSettings().SmallestRadius;
}

void CDynamics2DEngine::AddToWorld(CDynamics2DBody& model) {
  const CEmbodiedEntity& body = model.GetEmbodiedEntity();
  const SBodyDescription& description = *body.GetBodyDescription();
  const SAnchor& origin = body.GetOriginAnchor();
  const SPlanarPose pose = ToFrame(MakePlanarPose(origin.Position, origin.Orientation));
  const SPlanarOwner owner{&model, &model.GetEmbodiedEntity(), &model.m_handle};
  if (!body.IsMovable()) {
    m_world->AddImmovable(owner, description, pose);
  } else if (model.m_drive) {
    m_world->AddDriven(owner, description, pose, model.m_drive);
    m_world->GetGrips().SetManipulator(owner, description, model.m_gripper, model.m_turret);
  } else {
    m_world->AddPassive(owner, description, pose);
  }
}

void CDynamics2DEngine::UpdateWorld() {
  StartRecordedBodies();
  if (m_world == nullptr) {
    Build();
  }
  RepositionDisplaced();
  if (SeesGhosts()) {
    m_world->SetGhosts(ListGhosts());
  }
  const bool isWorthThreads = UsesThreadPool() && m_world->GetNumDriven() >= kRobotsForThreads;
  CThreadPool& pool = isWorthThreads ? m_cSimulator.GetThreadPool() : *m_alone;
  try {
    m_world->Advance(pool);
  } catch (const SBadDriveCommand& bad) {
    ThrowBadCommand(bad);
  }
  WriteBackDriven(pool);
  m_world->ForEachPassive([this](const SPassiveBody& body) {
    if (body.Moved && WriteBack(*body.Owner.Model, ToWorld(body.Pose), 0.0)) {
      ScheduleIfLeading(*body.Owner.Body);
    }
  });
  FinishRecordedBodies();
}

// Several engines share the threads better than the parts of each do.
bool CDynamics2DEngine::UsesThreadPool() const {
  return m_cSimulator.GetPhysicsEngines().size() < 2 * m_cSimulator.GetThreadPool().GetNumThreads();
}

void CDynamics2DEngine::WriteBackDriven(CThreadPool& pool) {
  m_hasLeft.resize(m_world->GetNumDriven());
  pool.ParallelFor(m_world->GetNumDriven(), kWriteGrain, [this](size_t begin, size_t end, UInt32) {
    m_world->CommitDriven(begin, end, [this](const SDrivenBody& body, size_t slot) {
      if (slot + kWriteAhead < m_hasLeft.size()) {
        const SPlanarOwner& ahead =
            m_world->GetDriven(static_cast<UInt32>(slot + kWriteAhead)).Owner;
        LoadAhead(*ahead.Model);
        LoadAhead(*ahead.Body);
      }
      m_hasLeft[slot] =
          WriteBack(*body.Owner.Model, ToWorld(body.Pose), body.IsDisc ? body.BoundingRadius : 0.0)
              ? 1
              : 0;
    });
  });
  if (IsEntityTransferActive()) {
    for (UInt32 slot = 0; slot < m_hasLeft.size(); ++slot) {
      if (m_hasLeft[slot] != 0) {
        ScheduleIfLeading(*m_world->GetDriven(slot).Owner.Body);
      }
    }
  }
}

// Bodies that are connected by grips are transferred together.
void CDynamics2DEngine::ScheduleIfLeading(CEmbodiedEntity& body) {
  if (LeadsCluster(body)) {
    ScheduleEntityForTransfer(body);
  }
}

// @param pose  world frame.
// @param radius  of a disc around the origin, m; 0 for another body.
// @return true if the body has left the region.
bool CDynamics2DEngine::WriteBack(CDynamics2DBody& model, const SPlanarPose& pose, Real radius) {
  CEmbodiedEntity& body = model.m_cEmbodiedEntity;
  WritePose(model, body, pose);
  if (radius > 0.0) {
    MoveDiscBounds(model.m_sBoundingBox, pose, radius);
  } else {
    model.m_sBoundingBox = ComputePlanarBounds(body, pose);
  }
  if (body.HasFollowers()) {
    model.m_root.Update();
  }
  return IsEntityTransferActive() && !IsPointContained(body.GetOriginAnchor().Position);
}

REGISTER_PHYSICS_ENGINE(
    CDynamics2DEngine, "dynamics2d", "the authors of this project", "1.0",
    "Rigid bodies on a plane.",
    R"(Robots and objects on a horizontal plane: they push, slide, stall and slip. Only the yaw of a body is
kept. Robots that touch nothing follow the exact arcs of their wheel speeds.
)" + RequiredEngineXML(R"(<dynamics2d id="dyn2d" />)") +
        OptionalEngineXML("dynamics2d",
                          R"(id="dyn2d" iterations="2" velocity_lag="0.1" elevation="0"
                gripping_rigidity="10000")",
                          PlanarFrictionXML(), std::string()) +
        R"(
ATTRIBUTES

  id                         text, required: unique among the engines.
  iterations                 integer >= 1: substeps of a tick. Not given: 2, as many as have 10 ms around a
                             body that a soft spring holds, and up to 64 where a crowd is so deep that robots would
                             overlap. In any case more, up to 64, while a body moves by more than half
                             its radius in a substep. 64 substeps also bound speeds: a robot moves at
                             most 32 radii in a tick.
)" + VelocityLagManual() +
        R"(  elevation                  m, default 0: height of the plane; bodies must stand on it, to 1e-4 m.
  gripping_rigidity          N/m, >= 0, default 10000: stiffness of grips, along the arm from the robot's
                             centre to the point that is gripped; 0: grippers hold nothing.
  box_linear_friction        N, >= 0, default 1.49: greatest friction force on a movable box.
  box_angular_friction       N m, >= 0, default 1.49: greatest friction torque on it.
  cylinder_linear_friction   N, >= 0, default 1.49: the same for a movable cylinder.
  cylinder_angular_friction  N m, >= 0, default 1.49.
)" + PlanarBoundariesManual() +
        R"(  spatial_hash               accepted and ignored.

A robot with two driven wheels may have other limits of its drive than its manual states. They are a child of the
robot's element, and hold in every engine that computes forces:

  <foot-bot id="fb0">
    <body position="0,0,0" />
    <controller config="c1" />
    <dynamics2d>
      <differential_steering max_force="15" max_torque="150" />
    </dynamics2d>
  </foot-bot>

  differential_steering@max_force   N, > 0: largest force with which the wheels push the robot.
  differential_steering@max_torque  N m, > 0: largest torque with which the wheels turn the robot.
)",
    "Usable")

}  // namespace argos
