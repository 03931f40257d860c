#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_engine.h>

#include <argos3/core/simulator/context/library_attribute.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/configuration/single_element.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/plugins/plugin_kind.h>
#include <argos3/core/utility/plugins/unknown_label.h>
#include <argos3/core/utility/string_utilities.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>
#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/articulated_body.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/body_builder.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/engine_poses.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/ode_session.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/read_settings.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_world.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/engine_manual.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/robot_components.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// m; farther away, contacts are not resolved to a tenth of the smallest robot's casters
constexpr Real kFarthest = 1e6;
// s, longest substep unless "iterations" is given
constexpr Real kDefaultSubstep = 0.01;
// bodies whose poses a thread writes together
constexpr size_t kWriteGrain = 128;

// Sine of half the greatest lean that is reported as upright: robots lean by less than 1e-3 rad
// when they roll. Sensors and placement handle upright solids exactly and fast.
constexpr Real kUpright = 5e-4;

CQuaternion Straighten(const CQuaternion& orientation) {
  const bool leans =
      std::abs(orientation.GetX()) > kUpright || std::abs(orientation.GetY()) > kUpright;
  return leans ? orientation : SetUpright(orientation);
}

bool IsFar(const CVector3& position) {
  // written so that NaN is far, too
  return !(std::abs(position.GetX()) + std::abs(position.GetY()) + std::abs(position.GetZ()) <=
           kFarthest);
}

bool IsPartOfEngine(const std::string& tag) {
  return tag == "boundaries" || tag == "solver" || tag == "contacts";
}

// Accepted so that a file can switch engines; reported as unused.
bool IsPartOfOtherEngine(const std::string& tag) {
  return tag == "friction" || tag == "spatial_hash";
}

}  // namespace

CDynamics3DEngine::CDynamics3DEngine() : m_settings(std::make_unique<SRigidSettings>()) {}

CDynamics3DEngine::~CDynamics3DEngine() = default;

void CDynamics3DEngine::Init(TConfigurationNode& tree) {
  m_settings->Tick = m_cSimulator.GetTickLength();
  // the tolerance keeps a rounding error from adding a substep
  const Real substeps = std::ceil(m_settings->Tick / kDefaultSubstep - 1e-6);
  SetIterations(static_cast<UInt32>(std::clamp<Real>(substeps, 1.0, kMaxIterations)));
  CDescribedBodyEngine::Init(tree);
  m_settings->Substeps = GetIterations();
  ReadRigidSettings(tree, *m_settings);
  UseODEInThisThread();
  InitPlugins(tree);
}

void CDynamics3DEngine::InitPlugins(TConfigurationNode& tree) {
  TConfigurationNodeIterator child;
  for (child = child.begin(&tree); child != child.end(); ++child) {
    const std::string& label = child->Value();
    if (IsPartOfEngine(label) || IsPartOfOtherEngine(label)) {
      CheckIsSingle(*child);
      continue;
    }
    LoadLibraryOf(*child);
    if (!CFactory<CDynamics3DPlugin>::Exists(label)) {
      THROW_ARGOSEXCEPTION(child->GetLocation()
                           << ": <dynamics3d> has no add-on <" << label << ">"
                           << DescribeUnknownLabel(label,
                                                   CFactory<CDynamics3DPlugin>::GetLabels()));
    }
    try {
      std::unique_ptr<CDynamics3DPlugin> plugin(CFactory<CDynamics3DPlugin>::New(label));
      plugin->SetEngine(*this);
      plugin->Init(*child);
      m_plugins.push_back(std::move(plugin));
    } catch (std::exception& error) {
      THROW_ARGOSEXCEPTION_NESTED(
          child->GetLocation() << ": <" << label << ">: the add-on cannot be initialised", error);
    }
  }
  if (m_plugins.empty()) {
    SetDefaults();
  }
  // others may push any body
  m_settings->FreeRobots = m_settings->FreeRobots &&
                           std::all_of(m_plugins.begin(), m_plugins.end(),
                                       [](const auto& plugin) { return plugin->IgnoresModels(); });
}

// No add-on listed: gravity and a floor by default.
void CDynamics3DEngine::SetDefaults() {
  m_hasDefaults = true;
  SetGravity(CVector3(0.0, 0.0, -kStandardGravity));
  const SHorizontalFace* const bottom = GetVolume().BottomFace;
  if (bottom == nullptr || !bottom->IsWall) {
    AddGroundPlane(0.0, 1.0);
  }
}

// The next tick builds a new world from the entities, without any state of the run so far.
void CDynamics3DEngine::Reset() {
  ResetRecordedBodies();
  DropWorld();
  ForgetDisplaced();
  for (const auto& plugin : m_plugins) {
    plugin->Reset();
  }
}

void CDynamics3DEngine::DropWorld() {
  m_world.reset();
  for (const auto& model : GetModels()) {
    static_cast<CDynamics3DModel&>(*model).m_body = nullptr;
  }
}

void CDynamics3DEngine::Destroy() {
  m_world.reset();
  DestroyModels();
  for (const auto& plugin : m_plugins) {
    plugin->Destroy();
  }
  m_plugins.clear();
}

void CDynamics3DEngine::PostSpaceInit() {
  if (m_hasDefaults) {
    LogDefaults();
  }
  const auto hasDrive = [](const auto& model) {
    return static_cast<bool>(static_cast<const CDynamics3DModel&>(*model).m_drive);
  };
  if (m_gravity == CVector3() && std::any_of(GetModels().begin(), GetModels().end(), hasDrive)) {
    LOGERR << "[WARNING] the engine \"" << GetId()
           << "\" has no gravity, so the drives of its robots have no grip: it needs the children "
              "<gravity g=\"9.81\" /> and <floor />, or none at all"
           << std::endl;
  }
}

// logged once for all engines, by the first one
void CDynamics3DEngine::LogDefaults() const {
  std::string ids;
  for (const CPhysicsEngine* each : m_cSimulator.GetPhysicsEngines()) {
    const auto* const engine = dynamic_cast<const CDynamics3DEngine*>(each);
    if (engine == nullptr || !engine->m_hasDefaults) {
      continue;
    }
    if (ids.empty() && engine != this) {
      return;
    }
    ids += (ids.empty() ? "\"" : ", \"") + engine->GetId() + "\"";
  }
  LOG << "[INFO] dynamics3d without add-ons (" << ids << "): gravity of " << kStandardGravity
      << " m/s^2 and a floor; <gravity g=\"0\" /> disables both" << std::endl;
}

void CDynamics3DEngine::SetGravity(const CVector3& gravity) {
  m_gravity = gravity;
  if (m_world != nullptr) {
    m_world->SetGravity(gravity);
  }
}

void CDynamics3DEngine::AddGroundPlane(Real height, Real friction) {
  m_planes.push_back({height, friction});
  if (m_world != nullptr) {
    m_world->AddPlane(m_planes.back());
  }
}

Real CDynamics3DEngine::GetDefaultFriction() const {
  return m_settings->Friction;
}

Real CDynamics3DEngine::GetSubstep() const {
  return m_world != nullptr ? m_world->GetSubstep() : GetPhysicsClockTick();
}

UInt32 CDynamics3DEngine::GetNumSubsteps() const {
  return m_world != nullptr ? m_world->GetNumSubsteps() : GetIterations();
}

bool CDynamics3DEngine::UsesThreadPool() const {
  return m_cSimulator.GetPhysicsEngines().size() == 1;
}

void CDynamics3DEngine::ActivateBody(SRigidBody& body) {
  if (body.IsFree) {
    UseODEInThisThread();
    m_world->Activate(body);
  }
}

void CDynamics3DEngine::CheckBody(CEmbodiedEntity& body) const {
  const CVector3& position = body.GetOriginAnchor().Position;
  if (IsFar(position)) {
    THROW_ARGOSEXCEPTION(NameOf(body)
                         << " at (" << position << ") is farther than " << kFarthest
                         << " m from the origin: contacts would no longer be accurate");
  }
  const std::string flaw = FindFlaw(*body.GetBodyDescription(), body.IsMovable());
  if (!flaw.empty()) {
    THROW_ARGOSEXCEPTION(NameOf(body) << " cannot be a rigid body: " << flaw);
  }
  // throw if the components are missing
  FindDrive(body);
  FindQuadrotor(body);
  FindJoints(body);
}

std::unique_ptr<CDescribedBodyModel> CDynamics3DEngine::CreateModel(CEmbodiedEntity& body,
                                                                    const CRecordedBody* recorded) {
  return std::make_unique<CDynamics3DModel>(*this, body, FindDrive(body, recorded));
}

void CDynamics3DEngine::Enter(CDescribedBodyModel& model) {
  auto& entering = static_cast<CDynamics3DModel&>(model);
  if (m_world != nullptr) {
    UseODEInThisThread();
    AddToWorld(entering);
  }
  for (const auto& plugin : m_plugins) {
    plugin->RegisterModel(entering);
  }
}

void CDynamics3DEngine::Leave(CDescribedBodyModel& model) {
  auto& leaving = static_cast<CDynamics3DModel&>(model);
  for (const auto& plugin : m_plugins) {
    plugin->UnregisterModel(leaving);
  }
  if (m_world != nullptr) {
    m_world->Remove(leaving.GetBody());
    leaving.m_body = nullptr;
  }
}

std::string CDynamics3DEngine::ExplainRefusal(CEntity& entity) const {
  return "accepts only bodies with an SBodyDescription, and <" + entity.GetTypeDescription() +
         "> has none";
}

void CDynamics3DEngine::UpdateManipulator(CDynamics3DModel& model) {
  if (m_world != nullptr) {
    model.GetBody().Gripper = model.m_gripper;
    model.GetBody().Turret = model.m_turret;
    m_world->GetGrips().SetManipulator(model.GetBody());
  }
}

void CDynamics3DEngine::Reposition(CDescribedBodyModel& model) {
  UseODEInThisThread();
  PlaceAtAnchor(static_cast<CDynamics3DModel&>(model), {});
}

bool CDynamics3DEngine::IsAtLastPose(const CDescribedBodyModel& model) const {
  const auto& displaced = static_cast<const CDynamics3DModel&>(model);
  const SAnchor& origin = displaced.m_cEmbodiedEntity.GetOriginAnchor();
  return displaced.m_lastPosition == origin.Position &&
         displaced.m_lastOrientation == origin.Orientation;
}

void CDynamics3DEngine::PlaceAtAnchor(CDynamics3DModel& model, const SRigidMotion& motion) {
  const SRigidPose pose = PoseOf(model.m_cEmbodiedEntity);
  m_world->Place(model.GetBody(), {pose.Position - GetFrameOrigin(), pose.Orientation}, motion);
  model.m_lastPosition = pose.Position;
  model.m_lastOrientation = pose.Orientation;
}

void CDynamics3DEngine::Build() {
  const std::vector<CDescribedBodyModel*> models = ListModelsForWorld();
  m_settings->OriginX = GetFrameOrigin().GetX();
  m_settings->OriginY = GetFrameOrigin().GetY();
  m_world = std::make_unique<CRigidWorld>(*m_settings, [this] { UpdatePlugins(); });
  m_world->SetGravity(m_gravity);
  for (const SGroundPlane& plane : m_planes) {
    m_world->AddPlane(plane);
  }
  for (CDescribedBodyModel* model : models) {
    AddToWorld(static_cast<CDynamics3DModel&>(*model));
  }
  BuildWalls();
}

void CDynamics3DEngine::AddToWorld(CDynamics3DModel& model) {
  CEmbodiedEntity& body = model.m_cEmbodiedEntity;
  SRigidSource source;
  source.Owner = &model;
  source.Description = body.GetBodyDescription();
  source.Shared = body.GetSharedBodyDescription();
  source.Movable = body.IsMovable();
  source.Drive = model.m_drive;
  source.Quadrotor = FindQuadrotor(body);
  source.Joints = FindJoints(body);
  source.LinkPoses = body.GetLinkPoses();
  const SRigidPose pose = PoseOf(body);
  model.m_body = &m_world->Add(source, {pose.Position - GetFrameOrigin(), pose.Orientation});
  if (source.Movable) {
    UpdateManipulator(model);
  }
  model.m_lastPosition = pose.Position;
  model.m_lastOrientation = pose.Orientation;
  model.m_wasAwake = true;
}

void CDynamics3DEngine::UpdatePlugins() {
  for (const auto& plugin : m_plugins) {
    plugin->Update();
  }
}

void CDynamics3DEngine::UpdateWorld() {
  StartRecordedBodies();
  UseODEInThisThread();
  if (m_world == nullptr) {
    Build();
  }
  RepositionDisplaced();
  if (SeesGhosts()) {
    UpdateGhosts();
  }
  try {
    m_world->Advance(UsesThreadPool() ? &m_cSimulator.GetThreadPool() : nullptr);
  } catch (const SBadDriveCommand& bad) {
    ThrowBadCommand(bad);
  }
  ReportFailures();
  WriteBack();
  FinishRecordedBodies();
}

void CDynamics3DEngine::WriteBack() {
  const std::vector<SRigidBody*>& bodies = m_world->GetMovables();
  m_haveLeft.resize(bodies.size());
  // on any thread: all data that is written belongs to one of the bodies
  const auto write = [&](size_t begin, size_t end, UInt32) {
    for (size_t i = begin; i < end; ++i) {
      CDynamics3DModel& model = *bodies[i]->Source.Owner;
      WriteBack(model);
      m_haveLeft[i] =
          IsEntityTransferActive() && HasLeft(model.m_cEmbodiedEntity.GetOriginAnchor().Position);
    }
  };
  if (UsesThreadPool()) {
    m_cSimulator.GetThreadPool().ParallelFor(bodies.size(), kWriteGrain, write);
  } else {
    write(0, bodies.size(), 0);
  }
  for (size_t i = 0; IsEntityTransferActive() && i < bodies.size(); ++i) {
    CEmbodiedEntity& entity = bodies[i]->Source.Owner->m_cEmbodiedEntity;
    if (m_haveLeft[i] != 0 && LeadsCluster(entity)) {
      ScheduleEntityForTransfer(entity);
    }
  }
}

// Warns if the user has chosen the direct solver only and it fails.
void CDynamics3DEngine::ReportFailures() {
  if (m_settings->Stepper == SRigidSettings::EStepper::Direct && !m_hasReported &&
      m_world->GetNumGivenUp() > 0) {
    m_hasReported = true;
    LOGERR << "[WARNING] the engine \"" << GetId()
           << "\": ODE's direct solver has left contacts unsolved; the stepper \"mixed\" would "
              "use the iterative one for them (reported once)"
           << std::endl;
  }
}

void CDynamics3DEngine::WriteBack(CDynamics3DModel& model) {
  CEmbodiedEntity& entity = model.m_cEmbodiedEntity;
  if (!model.GetBody().Asleep || model.m_wasAwake) {
    const SRigidPose own = GetRigidPose(model.GetBody());
    const SRigidPose pose{own.Position + GetFrameOrigin(), Straighten(own.Orientation)};
    if (IsFar(pose.Position)) {
      THROW_ARGOSEXCEPTION(NameOf(entity)
                           << " is now at (" << pose.Position << "), farther than " << kFarthest
                           << " m from the origin: has it fallen off the floor, or "
                              "is a force on it too great?");
    }
    entity.SetOriginPose(pose.Position, pose.Orientation);
    const SBodyPose toOrigin = Invert({own.Position, pose.Orientation});
    for (UInt32 link = 1; link <= model.GetBody().Links.size(); ++link) {
      entity.SetLinkPose(link, Compose(toOrigin, GetLinkFrame(model.GetBody(), link)));
    }
    model.m_lastPosition = pose.Position;
    model.m_lastOrientation = pose.Orientation;
    model.CalculateBoundingBox();
  }
  model.m_wasAwake = !model.GetBody().Asleep;
  if (entity.GetEnabledAnchors().size() > 1) {
    model.CalculateAnchors();
  }
  if (entity.HasFollowers()) {
    model.m_root.Update();
  }
}

[[maybe_unused]] static const CPluginKind kAddOns("dynamics3d_add_ons", "dynamics3d",
                                                  "ADD-ONS OF DYNAMICS3D",
                                                  &ListPlugins<CDynamics3DPlugin>);

REGISTER_PHYSICS_ENGINE(
    CDynamics3DEngine, "dynamics3d", "the authors of this project", "1.0",
    "Rigid bodies in three dimensions, on ODE.",
    R"(Robots and objects in space: they fall, slide, roll, stack and topple. Robots with a differential drive roll
on two sprung wheels with motors, and four casters without friction; those with a planar drive stand on such casters,
and motors of bounded force and torque move them while one touches the ground; robots with propellers fly by their own
controllers; grippers hold bodies, and turrets move the held bodies.
Gravity, floor and magnetism are add-ons. An engine without add-ons has gravity of 9.81 m/s^2 and a floor at z = 0;
an engine with any add-on has only those that are listed. <gravity g="0" /> alone is weightless.
)" + RequiredEngineXML(R"(<dynamics3d id="dyn3d" />)") +
        OptionalEngineXML(
            "dynamics3d",
            R"(id="dyn3d" iterations="10" default_friction="1" sleep="true" free_robots="true" upright="true" ghosts="true")",
            R"(      <floor height="0" friction="1" />
      <gravity vector="0,0,-9.81" />
      <magnetism force_constant="7.0500949e-13" max_distance="0.5" />
      <solver stepper="mixed" iterations="32" max_direct_rows="100" erp="0.2" cfm="1e-5" />
      <contacts restitution="0" bounce_speed="0.02" surface_layer="1e-5" max_correcting_speed="1" />
)",
            R"(        <top height="2" />
        <bottom height="0" />
)") + R"(
ATTRIBUTES

  id                    text, required: unique among the engines.
  iterations            integer in [1,10000]: least number of substeps of a tick. Not given: so many that none is
                        longer than 0.01 s. In any case more, up to 1000 or 16 times as many, while a body would move by
                        more than half its narrowest side in a substep.
  default_friction      in [0,1000], default 1: Coulomb's coefficient of every body. That of a contact is the product
                        of both.
  sleep                 "true" (default) or "false": if true, bodies that have been at rest (below 1 mm/s and
                        0.01 rad/s) on another body for half a second are not simulated until a body comes near.
  free_robots           "true" (default) or "false": if true, robots that roll upright on the floor and can touch
                        nothing else in a tick follow the arc of their drive, without ODE. Only with no other add-ons
                        than gravity and floor, unless these declare that they push nothing.
  upright               "true" (default) or "false": if true, robots and objects that stand upright on the floor and
                        touch others only sideways move in the plane, much faster. Only where robots may be free, with
                        the stepper "mixed" and no restitution.
  floor                 an infinite plane that supports the bodies above it. height: m, default 0. friction: >= 0,
                        default 1.
  gravity               g: m/s^2, default 9.81, downward. Or vector: "x,y,z", m/s^2.
  magnetism             forces between the magnets of robots (<magnets>), see its own description: force_constant,
                        default 7.0500949e-13; max_distance: m, default infinite.
  solver@stepper        "mixed" (default): impulses with Coulomb's cone of friction, by sweeps over the contacts
                        until they converge; large islands of bodies that touch as often as their size allows.
                        "iterative": at most solver@iterations sweeps, for crowds. "direct": ODE's dWorldStep, exact
                        but with a pyramid of friction, for few bodies that touch.
  solver@iterations     integer in [1,1000], default 32: sweeps in a substep, at least ("mixed", if they do not converge
                        before) or at most ("iterative").
  solver@max_direct_rows  integer, default 100: greatest number of constraints of an island of connected bodies over
                        which "mixed" sweeps until they converge, up to 400 times. Islands with joints of more than
                        that are solved approximately. A robot on the floor has 22, a box 12.
  solver@erp            in [0.01,1], default 0.2: the share of an error of position that is corrected in a substep.
  solver@cfm            m/s per N, in [1e-10,1], default 1e-5: how soft joints are, and contacts with "direct" of
                        bodies of up to 1 kg; those of heavier ones are harder in proportion.
  contacts@restitution  in [0,1], default 0: the speed after an impact over that before it; not of wheels.
  contacts@bounce_speed  m/s, >= 0, default 0.02: slower impacts do not bounce.
  contacts@surface_layer  m, >= 0, default 1e-5: overlap of bodies at rest.
  contacts@max_correcting_speed  m/s, default 1: greatest speed at which overlaps are corrected.
  boundaries            the region of the engine, default everything: top@height and bottom@height, in m, and
                        sides/vertex@point, in m, at least three, counter-clockwise, convex. A body that leaves it is
                        transferred to the engine whose region it enters. Each of these may have wall="true", which
                        stops bodies at that face (of a vertex: at the side from there to the next), or gate="id", which
                        transfers bodies that cross it to that engine (doc/space_partitioning.md). A bottom that is a
                        wall is a floor.
  ghosts                "true" (default) or "false": if true, robots of other engines near the border are obstacles.
  debug_file            accepted and ignored.

Every other child is an add-on that a library has registered (REGISTER_DYNAMICS3D_PLUGIN); argos3 -q followed by its
name describes it. <friction> and <spatial_hash>, which belong to dynamics2d, are ignored with a warning.
)",
    "Usable")

}  // namespace argos
