#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematics2d_engine.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_limits.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_world.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematics2d_model.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_body.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/engine_manual.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/robot_components.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// The pose of a body. A pose that this engine has written is returned unchanged to the bit.
SPlanarPose ReadPose(const CEmbodiedEntity& body) {
  constexpr Real kRounding = 1e-13;
  const SAnchor& origin = body.GetOriginAnchor();
  const CQuaternion& turn = origin.Orientation;
  if (turn.GetX() == 0.0 && turn.GetY() == 0.0 &&
      std::abs(turn.GetW() * turn.GetW() + turn.GetZ() * turn.GetZ() - 1.0) < kRounding) {
    return {origin.Position.GetX(), origin.Position.GetY(), turn.GetW(), turn.GetZ()};
  }
  return MakePlanarPose(origin.Position, turn);
}

}  // namespace

CKinematics2DEngine::CKinematics2DEngine()
    : m_boxFriction(std::make_unique<SGroundFriction>()),
      m_cylinderFriction(std::make_unique<SGroundFriction>()) {
  SetIterations(1);
}

CKinematics2DEngine::~CKinematics2DEngine() = default;

void CKinematics2DEngine::Init(TConfigurationNode& tree) {
  CPlanarEngine::Init(tree);
  ReadGroundFriction(tree, *m_boxFriction, *m_cylinderFriction);
  // accepted so that a file can switch engines
  Real ignored = 0.0;
  ReadNotNegative(tree, "gripping_rigidity", ignored);
}

// The next tick builds a new world from the entities, without any state of the run so far.
void CKinematics2DEngine::Reset() {
  ResetRecordedBodies();
  DropWorld();
}

void CKinematics2DEngine::DropWorld() {
  m_world.reset();
}

void CKinematics2DEngine::Destroy() {
  m_world.reset();
  m_manipulators.clear();
  DestroyModels();
}

std::unique_ptr<CDescribedBodyModel> CKinematics2DEngine::CreateModel(
    CEmbodiedEntity& body, const CRecordedBody* recorded) {
  return std::make_unique<CKinematics2DModel>(*this, body, FindDrive(body, recorded));
}

void CKinematics2DEngine::Enter(CDescribedBodyModel& model) {
  auto& entering = static_cast<CKinematics2DModel&>(model);
  if (m_world != nullptr) {
    AddToWorld(entering);
  }
  UpdateManipulator(entering);
}

void CKinematics2DEngine::Leave(CDescribedBodyModel& model) {
  auto& leaving = static_cast<CKinematics2DModel&>(model);
  if (m_world != nullptr) {
    m_world->Remove(leaving.m_handle);
  }
  if (leaving.m_isManipulator) {
    std::erase(m_manipulators, &leaving);
    leaving.m_isManipulator = false;
  }
}

bool CKinematics2DEngine::GetMotion(const CEmbodiedEntity& body, SBodyMotion& motion) const {
  const auto& model = static_cast<const CKinematics2DModel&>(body.GetPhysicsModel(size_t(0)));
  if (!model.m_drive) {
    return false;
  }
  const SDriveCommand command = model.m_drive.Read();
  motion.Velocity = CVector3(command.Ahead, command.Left, 0.0);
  motion.Rotation = CVector3(0.0, 0.0, command.YawRate);
  motion.Velocity.Rotate(body.GetOriginAnchor().Orientation);
  if (m_world != nullptr) {
    motion.Command = m_world->GetLastCommand(model.m_handle);
  }
  return true;
}

void CKinematics2DEngine::SetMotion(CEmbodiedEntity& body, const SBodyMotion& motion) {
  CRobotsCode::CheckShared("CPhysicsEngine::SetMotion()");
  const auto& model = static_cast<const CKinematics2DModel&>(body.GetPhysicsModel(size_t(0)));
  if (m_world != nullptr && model.m_drive) {
    m_world->SetLastCommand(model.m_handle, FindCommand(motion, body));
  }
}

void CKinematics2DEngine::Reposition(CDescribedBodyModel& model) {
  auto& displaced = static_cast<CKinematics2DModel&>(model);
  if (displaced.m_handle.Kind == EKinematicKind::Immovable) {
    m_world->Remove(displaced.m_handle);
    AddToWorld(displaced);
  } else {
    m_world->SetPose(displaced.m_handle, ToFrame(ReadPose(displaced.m_cEmbodiedEntity)));
  }
}

void CKinematics2DEngine::UpdateManipulator(CPlanarModel& model) {
  auto& robot = static_cast<CKinematics2DModel&>(model);
  const bool hasOne = robot.m_gripper != nullptr || robot.m_turret != nullptr;
  if (hasOne && !robot.m_isManipulator) {
    m_manipulators.push_back(&robot);
  } else if (!hasOne && robot.m_isManipulator) {
    std::erase(m_manipulators, &robot);
  }
  robot.m_isManipulator = hasOne;
}

void CKinematics2DEngine::Build() {
  const std::vector<CDescribedBodyModel*> models = ListModelsForWorld();
  size_t numImmovable = 0;
  size_t numDriven = 0;
  for (CDescribedBodyModel* model : models) {
    const auto& body = static_cast<const CKinematics2DModel&>(*model);
    numImmovable += body.m_cEmbodiedEntity.IsMovable() ? 0 : 1;
    numDriven += body.m_drive ? 1 : 0;
  }
  m_manipulators.reserve(AddSpareCapacity(m_manipulators.size()));
  m_hasLeft.reserve(AddSpareCapacity(numDriven));
  m_world = std::make_unique<CKinematicWorld>();
  m_world->SetPeriod(GetPeriod());
  m_isPeriodic = GetPeriod().IsOn();
  m_world->Reserve(numImmovable, AddSpareCapacity(models.size() - numImmovable - numDriven),
                   AddSpareCapacity(numDriven));
  for (CDescribedBodyModel* model : models) {
    AddToWorld(static_cast<CKinematics2DModel&>(*model));
  }
  for (const SWallSlab& wall : GetVolume().DescribeWalls()) {
    m_world->AddWall(*wall.Description, ToFrame(MakePlanarPose(wall.Position, wall.Orientation)));
  }
  if (SeesGhosts()) {
    m_world->ReserveForGhosts(AddSpareCapacity(numDriven));
  }
}

Real CKinematics2DEngine::GetGhostReach() const {
  return m_world != nullptr
             ? m_world->ComputeGhostReach(m_cSimulator.GetTickLength(), GetIterations())
             : CPhysicsEngine::GetGhostReach();
}

void CKinematics2DEngine::AddToWorld(CKinematics2DModel& model) {
  const CEmbodiedEntity& body = model.GetEmbodiedEntity();
  const SBodyDescription& description = *body.GetBodyDescription();
  const SPlanarPose pose = ToFrame(ReadPose(body));
  const SKinematicOwner owner{&model, &model.GetEmbodiedEntity(), &model.m_handle};
  if (!body.IsMovable()) {
    m_world->AddImmovable(owner, description, pose);
    return;
  }
  m_world->AddMovable(owner, description, pose, model.m_drive,
                      ChooseGroundFriction(description, *m_boxFriction, *m_cylinderFriction));
}

void CKinematics2DEngine::UpdateWorld() {
  StartRecordedBodies();
  if (m_world == nullptr) {
    Build();
  }
  if (SeesGhosts()) {
    m_world->SetGhosts(ListGhosts(), m_cSimulator.GetTickLength(), GetIterations());
  }
  Advance();
  UpdateManipulators();
  WriteBackDiscs();
  WriteBackSolids();
  FinishRecordedBodies();
}

void CKinematics2DEngine::Advance() {
  CThreadPool& pool = m_cSimulator.GetThreadPool();
  CDiscSwarm& discs = m_world->GetDiscs();
  for (UInt32 substep = 0; substep < GetIterations(); ++substep) {
    if (substep > 0) {
      for (UInt32 slot = 0; slot < discs.GetSize(); ++slot) {
        discs.Commit(slot);
        if (m_isPeriodic) {
          discs.Wrap(slot);
        }
      }
    }
    try {
      const Real lateShare = std::clamp(GetVelocityLag() * GetIterations() - substep, 0.0, 1.0);
      const bool isLast = substep + 1 == GetIterations();
      m_world->Advance(pool, {GetPhysicsClockTick(), lateShare, isLast});
    } catch (const SBadDriveCommand& bad) {
      ThrowBadCommand(bad);
    }
    if (m_isPeriodic) {
      m_world->WrapSolids();
    }
  }
}

void CKinematics2DEngine::UpdateManipulators() {
  for (CKinematics2DModel* model : m_manipulators) {
    if (model->m_turret != nullptr) {
      model->m_turret->Advance(m_cSimulator.GetTickLength());
    }
    if (model->m_gripper != nullptr && model->m_gripper->IsLocked()) {
      THROW_ARGOSEXCEPTION("robot \"" << model->m_root.GetId()
                                      << "\" has locked its gripper, but <kinematics2d id=\""
                                      << GetId()
                                      << "\"> cannot hold anything: use <dynamics2d> for robots "
                                         "that grip");
    }
  }
}

void CKinematics2DEngine::WriteBackDiscs() {
  CDiscSwarm& discs = m_world->GetDiscs();
  m_hasLeft.resize(discs.GetSize());
  m_cSimulator.GetThreadPool().ParallelFor(
      discs.GetSize(), kDiscGrain,
      [this](size_t begin, size_t end, UInt32) { WriteBackDiscs(begin, end); });
  if (IsEntityTransferActive()) {
    for (UInt32 slot = 0; slot < discs.GetSize(); ++slot) {
      if (m_hasLeft[slot] != 0) {
        ScheduleEntityForTransfer(discs.GetOwner(slot).Model->m_cEmbodiedEntity);
      }
    }
  }
}

// For robots [begin, end), on any thread: all data that is written belongs to one of them.
void CKinematics2DEngine::WriteBackDiscs(size_t begin, size_t end) {
  CDiscSwarm& discs = m_world->GetDiscs();
  for (size_t i = begin; i < end; ++i) {
    const UInt32 slot = static_cast<UInt32>(i);
    discs.Commit(slot);
    if (m_isPeriodic) {
      discs.Wrap(slot);
    }
    const SPlanarPose pose = ToWorld(discs.GetPose(slot));
    const Real radius = discs.GetRadius(slot);
    CKinematics2DModel& model = *discs.GetOwner(slot).Model;
    CEmbodiedEntity& body = *discs.GetOwner(slot).Body;
    WritePose(model, body, pose);
    MoveDiscBounds(model.m_sBoundingBox, pose, radius);
    if (body.HasFollowers()) {
      body.GetRootEntity().Update();
    }
    m_hasLeft[i] = HasLeft(body) ? 1 : 0;
  }
}

void CKinematics2DEngine::WriteBackSolids() {
  CSolids& solids = m_world->GetSolids();
  for (UInt32 slot = 0; slot < solids.GetSize(); ++slot) {
    SSolid& solid = solids.Get(slot);
    if (!solid.HasMoved && solid.IsPassive()) {
      continue;
    }
    solid.HasMoved = false;
    CKinematics2DModel& model = *solid.Owner.Model;
    CEmbodiedEntity& body = model.m_cEmbodiedEntity;
    const SPlanarPose pose = ToWorld(solid.Pose);
    WritePose(model, body, pose);
    model.m_sBoundingBox = ComputePlanarBounds(body, pose);
    if (body.HasFollowers()) {
      model.m_root.Update();
    }
    if (HasLeft(body)) {
      ScheduleEntityForTransfer(body);
    }
  }
}

bool CKinematics2DEngine::HasLeft(const CEmbodiedEntity& body) {
  return IsEntityTransferActive() && !IsPointContained(body.GetOriginAnchor().Position);
}

REGISTER_PHYSICS_ENGINE(
    CKinematics2DEngine, "kinematics2d", "the authors of this project", "1.0",
    "Robots without momentum on a plane: the fastest engine.",
    R"(Robots on wheels that follow the exact arcs of their wheel speeds, do not overlap walls or each other,
slide along obstacles, and push objects against their friction on the ground. Nothing has momentum: objects that are not
pushed stand still. Robots do not push robots. A tick uses all threads of <system threads>; its result does not depend on
them. Gripping is an error that names the robot: only dynamics2d and dynamics3d support it.
)" + RequiredEngineXML(R"(<kinematics2d id="kin2d" />)") +
        OptionalEngineXML("kinematics2d",
                          R"(id="kin2d" iterations="1" velocity_lag="0.1" elevation="0")",
                          PlanarFrictionXML(), std::string()) +
        R"(
ATTRIBUTES

  id                         text, required: unique among the engines.
  iterations                 integer >= 1, default 1: substeps of a tick. No bodies overlap or pass through
                             each other with any number; robots that may touch something move straight in
                             a substep.
)" + VelocityLagManual() +
        R"(  elevation                  m, default 0: height of the plane; bodies must stand on it, to 1e-4 m.
  box_linear_friction        N, >= 0, default 1.49: force that is necessary to push a movable box.
  box_angular_friction       N m, >= 0, default 1.49: torque that is necessary to turn it.
  cylinder_linear_friction   N, >= 0, default 1.49: the same for a movable cylinder.
  cylinder_angular_friction  N m, >= 0, default 1.49.
)" + PlanarBoundariesManual() +
        R"(  gripping_rigidity, spatial_hash  of dynamics2d: accepted and ignored.
)",
    "Usable")

}  // namespace argos
