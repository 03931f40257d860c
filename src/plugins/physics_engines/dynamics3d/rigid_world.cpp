#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_world.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/articulated_body.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/body_builder.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/ode_session.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_flight.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/flight_loop.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/robot_components.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace argos {

namespace {

// m/s; assumed greatest speed that a flying robot at rest reaches in a tick: an eye-bot reaches it
// in 0.1 s with a new target 5 m away
constexpr Real kStartFlightSpeed = 6.0;
// factor for what other bodies that push add to the path of the fastest body
constexpr Real kPathMargin = 1.5;

// removes a body from a list by its number, which the last one gets
void TakeOut(std::vector<SRigidBody*>& bodies, const SRigidBody& body) {
  const UInt32 number = body.Number;
  bodies[number] = bodies.back();
  bodies[number]->Number = number;
  bodies.pop_back();
}

// the greatest speed that is commanded to a wheel, or to a planar drive, m/s
Real GetOrderedSpeed(const SRigidBody& body) {
  if (body.HasPlanarDrive()) {
    return body.Source.Drive.Read().ComputeSpeed();
  }
  const Real* const wheels = body.Source.Drive.GetWheels();
  return std::max(std::abs(wheels[0]), std::abs(wheels[1]));
}

// of the fastest link, m/s
Real ComputeSpeed(const SRigidBody& body) {
  if (body.IsFree) {
    return body.Roll.Motion.ComputeSpeed();
  }
  Real fastest = FromODE(dBodyGetLinearVel(body.Body)).Length();
  for (const SRigidLink& link : body.Links) {
    fastest = std::max(fastest, FromODE(dBodyGetLinearVel(link.Part)).Length());
  }
  return fastest;
}

bool IsSlow(dBodyID part) {
  return FromODE(dBodyGetLinearVel(part)).Length() < kQuietSpeed &&
         FromODE(dBodyGetAngularVel(part)).Length() < kQuietTurn;
}

// the speed that a body may reach in a tick by its own drive, m/s
Real ForeseeSpeed(const SRigidBody& body, Real tick) {
  const Real speed = ComputeSpeed(body);
  if (!body.HasDrive()) {
    return speed;
  }
  const SBodyDescription& description = *body.Source.Description;
  const Real gain = description.GetDriveLimits().MaxForce / description.Mass * tick;
  return std::max(speed, std::min(GetOrderedSpeed(body), speed + gain));
}

}  // namespace

CRigidWorld::CRigidWorld(const SRigidSettings& settings, std::function<void()> beforeSubstep)
    : m_settings(settings),
      m_beforeSubstep(std::move(beforeSubstep)),
      m_world(dWorldCreate()),
      m_threading(dThreadingAllocateSelfThreadedImplementation()),
      m_stepper(m_settings),
      m_free(m_settings),
      m_upright(m_settings) {
  dWorldSetStepThreadingImplementation(m_world, dThreadingImplementationGetFunctions(m_threading),
                                       m_threading);
  dWorldSetERP(m_world, m_settings.ErrorReduction);
  dWorldSetCFM(m_world, m_settings.ConstraintForceMixing);
  dWorldSetContactSurfaceLayer(m_world, m_settings.SurfaceLayer);
  dWorldSetContactMaxCorrectingVel(m_world, m_settings.MaxCorrectingSpeed);
  dWorldSetQuickStepNumIterations(m_world, static_cast<int>(m_settings.SolverIterations));
  // this class implements sleeping, by islands
  dWorldSetAutoDisableFlag(m_world, 0);
  m_contacts = std::make_unique<CContactFinder>(m_settings, m_world);
  m_grips = std::make_unique<CRigidGrips>(m_world);
}

CRigidWorld::~CRigidWorld() {
  m_contacts->Clear();
  m_grips.reset();
  for (const auto& body : m_owned) {
    DestroyRigidBody(*body);
  }
  m_spares.Clear();
  m_contacts.reset();
  dWorldDestroy(m_world);
  dThreadingFreeImplementation(m_threading);
}

void CRigidWorld::SetGravity(const CVector3& gravity) {
  m_gravity = gravity;
  dWorldSetGravity(m_world, gravity.GetX(), gravity.GetY(), gravity.GetZ());
  SetGround();
  WakeAll();
}

SRigidBody& CRigidWorld::MakePlane(const SGroundPlane& plane) {
  SRigidBody& body = MakeBody();
  body.Friction = plane.Friction;
  m_planes.push_back(&body);
  WakeAll();
  return body;
}

// other bounds of planes are not used
void CRigidWorld::AddPlane(const SGroundPlane& plane) {
  SRigidBody& body = MakePlane(plane);
  body.Low.SetZ(-HUGE_VAL);
  body.High.SetZ(plane.Height);
  const dGeomID geom = dCreatePlane(nullptr, 0.0, 0.0, 1.0, plane.Height);
  body.Solids.push_back(geom);
  SetGround();
}

void CRigidWorld::AddCeiling(const SGroundPlane& plane) {
  SRigidBody& body = MakePlane(plane);
  body.Margin = kFaceMargin;
  body.Low.SetZ(plane.Height - kFaceMargin);
  body.High.SetZ(HUGE_VAL);
  const dGeomID geom = dCreatePlane(nullptr, 0.0, 0.0, -1.0, kFaceMargin - plane.Height);
  body.Solids.push_back(geom);
  SetGround();
}

void CRigidWorld::AddWall(const SBodyDescription& wall, SRigidPose pose) {
  pose.Position += Rotated(CVector3::Y, pose.Orientation) * kFaceMargin;
  SRigidSource source;
  source.Description = &wall;
  source.Movable = false;
  Add(source, pose).Margin = kFaceMargin;
}

SRigidBody& CRigidWorld::MakeBody() {
  m_owned.push_back(std::make_unique<SRigidBody>());
  m_owned.back()->Owned = static_cast<UInt32>(m_owned.size() - 1);
  m_owned.back()->Serial = ++m_numMade;
  return *m_owned.back();
}

SRigidBody& CRigidWorld::Add(const SRigidSource& source, const SRigidPose& pose) {
  WakeAll();
  SRigidBody& body = MakeBody();
  body.Source = source;
  auto& list = source.Movable ? m_movables : m_fixed;
  body.Number = static_cast<UInt32>(list.size());
  list.push_back(&body);
  body.IsFree = m_free.MayStartFree(source, pose);
  if (body.IsFree) {
    DescribeRigidBody(body, m_settings);
    body.Roll = {MakePlanarPose(pose.Position, pose.Orientation), pose.Position.GetZ(), {}};
  } else {
    BuildRigidBody(body, pose, m_settings, m_world);
    UpdateBounds(body);
  }
  if (!source.Movable) {
    m_free.MarkFixedChanged();
    m_upright.MarkFixedChanged();
  } else if (!body.IsFree) {
    body.PartsNumber = static_cast<UInt32>(m_active.size());
    m_active.push_back(&body);
  }
  if (body.HasDrive()) {
    m_free.NoteRobot(body);
  }
  Reserve();
  if (source.Movable) {
    m_widest = std::max(m_widest, source.Description->ComputeBoundingRadius());
  }
  if (source.Quadrotor != nullptr) {
    m_flying.push_back(&body);
  }
  if (body.IsArticulated()) {
    m_articulated.push_back(&body);
    HardenJoints(body);
  }
  return body;
}

// ODE's softness of joints, in m/s per N, would let heavy links come off.
void CRigidWorld::HardenJoints(const SRigidBody& body) {
  ForEachPart(body, [this](dBodyID part) {
    dMass mass;
    dBodyGetMass(part, &mass);
    m_heaviestLink = std::max<Real>(m_heaviestLink, mass.mass);
  });
  dWorldSetCFM(m_world, m_settings.ConstraintForceMixing / std::max<Real>(1.0, m_heaviestLink));
}

// Any number of the robots may be active in a tick.
void CRigidWorld::Reserve() {
  m_active.reserve(m_movables.capacity());
  m_loose.reserve(m_movables.capacity());
  m_listed.reserve(m_movables.capacity());
  m_large.reserve(m_movables.capacity());
  m_stepper.Reserve(m_movables.capacity());
  m_struck.reserve(m_movables.capacity());
  m_free.Reserve(m_movables.capacity());
  m_contacts->Reserve(m_movables.capacity(), m_fixed.capacity());
}

bool CRigidWorld::Has(const SRigidBody& body) const {
  // by address: the body may be gone
  return std::any_of(m_owned.begin(), m_owned.end(),
                     [&body](const auto& owned) { return owned.get() == &body; });
}

void CRigidWorld::Remove(SRigidBody& body) {
  ARGOS_ASSERT(Has(body), "a rigid body is removed that is not in the world");
  std::vector<SRigidBody*>& list = body.Source.Movable ? m_movables : m_fixed;
  ARGOS_ASSERT(body.Number < list.size() && list[body.Number] == &body &&
                   body.Owned < m_owned.size() && m_owned[body.Owned].get() == &body,
               "a rigid body is not the one with its number, " << body.Number);
  WakeAll();
  m_grips->ReleaseAllOf(body);
  body.Gripper = nullptr;
  body.Turret = nullptr;
  m_grips->SetManipulator(body);
  if (!body.Source.Movable) {
    m_free.MarkFixedChanged();
    m_upright.MarkFixedChanged();
  } else if (!body.IsFree) {
    TakeFromActive(body);
  }
  DestroyRigidBody(body);
  TakeOut(list, body);
  if (body.Source.Quadrotor != nullptr) {
    m_flying.erase(std::find(m_flying.begin(), m_flying.end(), &body));
  }
  m_articulated.erase(std::remove(m_articulated.begin(), m_articulated.end(), &body),
                      m_articulated.end());
  const UInt32 owned = body.Owned;
  m_owned.back()->Owned = owned;
  std::swap(m_owned[owned], m_owned.back());
  m_owned.pop_back();
}

void CRigidWorld::Place(SRigidBody& body, const SRigidPose& pose, const SRigidMotion& motion) {
  ARGOS_ASSERT(Has(body), "a rigid body is placed that is not in the world");
  WakeAll();
  m_grips->ReleaseAllOf(body);
  if (body.IsFree) {
    Activate(body);
  }
  if (!body.Source.Movable) {
    m_free.MarkFixedChanged();
    m_upright.MarkFixedChanged();
  }
  m_contacts->ForgetForces();
  m_upright.ForgetForces();
  PlaceRigidBody(body, pose, motion);
  UpdateBounds(body);
}

// Called by all functions that change the world between ticks.
void CRigidWorld::WakeAll() {
  m_contacts->MarkChanged();
  for (SRigidBody* body : m_active) {
    WakeRigidBody(*body);
  }
}

void CRigidWorld::Advance(CThreadPool* pool) {
  StartTick(pool);
  m_grips->StartTick(m_active, m_settings.Tick);
  SelectUpright();
  for (UInt32 i = 0; i < m_numSubsteps; ++i) {
    m_beforeSubstep();
    for (SRigidBody* body : m_flying) {
      PushFlyingBody(*body, m_gravity, m_substep,
                     CVector3(m_settings.OriginX, m_settings.OriginY, 0.0));
    }
    for (const SRigidBody* body : m_articulated) {
      DriveJoints(*body, m_substep);
    }
    if (!m_upright.IsEmpty() && m_upright.Step(m_substep, pool)) {
      ListLoose();
    }
    // what sleeps is woken by others that are awake
    if (std::any_of(m_loose.begin(), m_loose.end(),
                    [](const auto* body) { return !body->Asleep; })) {
      StepLoose(pool);
      if (!m_settings.Sleep) {
        Doze(i == 0);
      }
      if (i + 1 < m_numSubsteps) {
        ActivateStruck(i + 1);
      }
    }
    for (SRigidBody* body : m_articulated) {
      ReadJoints(*body);
    }
  }
  m_grips->EndTick(m_settings.Tick);
  m_upright.EndTick();
  if (!m_settings.Sleep) {
    EndDozing();
  }
  if (m_settings.Sleep && !m_loose.empty()) {
    UpdateSleep();
  }
  RollFree(pool);
}

// Moves the active bodies that are not upright by a substep.
void CRigidWorld::StepLoose(CThreadPool* pool) {
  m_contacts->Find(m_loose, m_fixed, m_planes, *m_grips, m_ghosts, m_gravity, m_substep);
  SetPlanarMotors();
  Step(pool);
  m_contacts->Clear();
  m_grips->BreakOverloadedGrips();
}

// What rests in one substep would rest in the others of the tick.
void CRigidWorld::Doze(bool isFirstSubstep) {
  for (SRigidBody* body : m_loose) {
    if (body->Rests && !body->Asleep) {
      PutToSleep(*body);
      body->Dozes = true;
    }
    body->Rests = false;
  }
  m_contacts->KeepDozing(isFirstSubstep);
}

void CRigidWorld::EndDozing() {
  for (SRigidBody* body : m_loose) {
    if (body->Dozes) {
      WakeRigidBody(*body);
    }
  }
}

// Drives get their targets in each substep, when it is known whether they touch the ground.
void CRigidWorld::SetPlanarMotors() {
  for (SRigidBody* body : m_loose) {
    if (body->HasPlanarDrive() && !body->Asleep) {
      SetPlanarMotor(*body, m_substep);
    }
  }
}

void CRigidWorld::StartTick(CThreadPool* pool) {
  SelectFree(pool);
  for (SRigidBody* body : m_articulated) {
    StartJointTick(*body, m_settings.Tick / m_settings.Substeps);
  }
  for (SRigidBody* body : m_active) {
    StartRobotTick(*body);
  }
  if (!m_ghosts.IsEmpty()) {
    m_ghosts.FindMeetings(m_active, ComputeLongestPath(FindFastest(m_movables)),
                          ComputeLongestPath(kStartFlightSpeed));
  }
  m_mostDirectRows = m_settings.MaxDirectRows;
  m_numSubsteps = CountSubsteps();
  SetSubstep(m_settings.Tick / m_numSubsteps);
}

// Sets the speeds of wheels.
void CRigidWorld::StartRobotTick(SRigidBody& body) {
  if (body.HasPlanarDrive() && !(body.Source.Drive.Read() == SDriveCommand())) {
    WakeRigidBody(body);
  }
  if (!body.HasWheels()) {
    return;
  }
  for (size_t i = 0; i < body.Axles.size(); ++i) {
    const Real speed = body.Source.Drive.GetWheels()[i];
    dJointSetHingeParam(body.Axles[i], dParamVel, speed / body.WheelRadius);
    if (speed != 0.0) {
      WakeRigidBody(body);
    }
  }
}

// Greatest speed of these bodies and their wheels, m/s.
Real CRigidWorld::FindFastest(const std::vector<SRigidBody*>& bodies) {
  Real fastest = 0.0;
  for (const SRigidBody* body : bodies) {
    if (body->Asleep) {
      continue;
    }
    fastest = std::max(fastest, ComputeSpeed(*body));
    if (body->HasDrive()) {
      fastest = std::max(fastest, GetOrderedSpeed(*body));
    }
  }
  return fastest;
}

// Longest path in a tick, m, including pushes by others and free fall.
Real CRigidWorld::ComputeLongestPath(Real fastest) const {
  return (kPathMargin * fastest + 0.5 * m_gravity.Length() * m_settings.Tick) * m_settings.Tick;
}

Real CRigidWorld::ComputeGhostReach() const {
  // a robot and the robot that approaches it may both move by the longest path
  const Real start = m_flying.empty() ? kStartSpeed : kStartFlightSpeed;
  return m_widest + 2.0 * ComputeLongestPath(std::max(FindFastest(m_movables), start));
}

// ODE finds contacts only at the end of a substep, so that no body may pass through another in one;
// and the controllers of flying robots must be accurate.
UInt32 CRigidWorld::CountSubsteps() const {
  const Real gain = m_gravity.Length() * m_settings.Tick;
  // ODE finds no contact of a cylinder that sticks out of the other side of a box
  Real thinnest = HUGE_VAL;
  for (const SRigidBody* body : m_fixed) {
    thinnest = std::min(thinnest, body->Narrowest);
  }
  Real strides = 0.0;
  for (const SRigidBody* body : m_active) {
    if (!body->Asleep) {
      const Real speed = ForeseeSpeed(*body, m_settings.Tick);
      const Real most = speed + (body->Source.Quadrotor == nullptr ? gain : 0.0);
      strides = std::max(
          {strides, most * m_settings.Tick / body->Narrowest, speed * m_settings.Tick / thinnest});
    }
  }
  Real wanted = strides / kMaxStride;
  for (const SRigidBody* body : m_flying) {
    const Real longest = ComputeMaxFlightSubstep(*body->Source.Description);
    wanted = std::max(wanted, m_settings.Tick / longest);
  }
  const UInt32 most = std::max(m_settings.Substeps * kMaxRefinement, kMaxRefined);
  return std::max(m_settings.Substeps,
                  static_cast<UInt32>(std::ceil(std::min(wanted, static_cast<Real>(most)))));
}

void CRigidWorld::SetSubstep(Real substep) {
  m_substep = substep;
  for (SRigidBody* body : m_active) {
    if (body->HasWheels()) {
      TuneWheels(*body, m_gravity.Length(), substep);
    }
  }
}

void CRigidWorld::Step(CThreadPool* pool) {
  if (m_settings.Stepper == SRigidSettings::EStepper::Direct) {
    m_contacts->CreateInODE(true);
    StepDirectly();
    return;
  }
  m_stepper.Step({m_loose, *m_contacts, *m_grips, m_gravity, m_substep}, pool);
  if (!m_articulated.empty()) {
    StepJoints();
  }
}

// ODE steps the islands with its joints.
void CRigidWorld::StepJoints() {
  const auto isOfODE = [this](const SRigidBody& body) {
    return m_contacts->GetIsland(body).HasJoints;
  };
  m_contacts->CreateInODE(false);
  for (SRigidBody* body : m_loose) {
    if (!body->Asleep && !isOfODE(*body)) {
      ForEachPart(*body, &dBodyDisable);
    }
  }
  StepByIslands();
  for (SRigidBody* body : m_loose) {
    if (!body->Asleep) {
      ForEachPart(*body, &dBodyEnable);
    }
  }
}

// ODE's direct solver fails for some kinds of redundant contacts: then, for the rest of the tick,
// larger islands are solved iteratively.
void CRigidWorld::StepDirectly() {
  // discards a message left by another world on this thread
  TakeODEError();
  dWorldStep(m_world, m_substep);
  if (TakeODEError() != nullptr) {
    ++m_numGivenUp;
    m_mostDirectRows = std::min(m_mostDirectRows, kSimpleRows);
  }
}

// ODE steps every island that has an enabled body: first the small ones, then the large ones.
void CRigidWorld::StepByIslands() {
  using enum SRigidSettings::EStepper;
  const UInt32 most = m_settings.Stepper == Iterative ? 0 : m_mostDirectRows;
  m_large.clear();
  for (SRigidBody* body : m_loose) {
    const CContactFinder::SIsland& island = m_contacts->GetIsland(*body);
    if (!body->Asleep && island.HasJoints && island.Rows > most) {
      m_large.push_back(body);
      ForEachPart(*body, &dBodyDisable);
    }
  }
  StepDirectly();
  if (m_large.empty()) {
    return;
  }
  for (SRigidBody* body : m_loose) {
    if (!body->Asleep) {
      ForEachPart(*body, &dBodyDisable);
    }
  }
  for (SRigidBody* body : m_large) {
    ForEachPart(*body, &dBodyEnable);
  }
  StepIteratively();
}

void CRigidWorld::StepIteratively() {
  // another order of the constraints in every step: the errors of a fixed order would add up
  StepODEIteratively(m_world, m_substep, m_numIterativeSteps++);
}

// Uses the islands of the last substep. An island without contact to a fixed body never sleeps.
void CRigidWorld::UpdateSleep() {
  for (SRigidBody* body : m_loose) {
    if (body->Asleep) {
      continue;
    }
    const bool slow = body->Source.Quadrotor == nullptr && IsSlow(body->Body) &&
                      std::all_of(body->Links.begin(), body->Links.end(),
                                  [](const SRigidLink& link) { return IsSlow(link.Part); });
    body->QuietTime = slow ? body->QuietTime + m_settings.Tick : 0.0;
    if (body->QuietTime < kQuietTime) {
      m_contacts->GetIsland(*body).Quiet = false;
    }
  }
  for (SRigidBody* body : m_loose) {
    if (!body->Asleep) {
      const CContactFinder::SIsland& island = m_contacts->GetIsland(*body);
      if (island.Quiet && island.Supported) {
        PutToSleep(*body);
      }
    }
  }
}

}  // namespace argos
