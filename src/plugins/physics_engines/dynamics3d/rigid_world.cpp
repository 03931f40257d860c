#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_world.h>

#include <argos3/core/simulator/physics_engine/body_description.h>
#include <argos3/core/simulator/physics_engine/flight_loop.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/body_builder.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/ode_session.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_flight.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace argos {

namespace {

// exponents of two, m: the cells of ODE's broad phase are as wide as what is in them, from the
// smallest robots to buildings
constexpr int kSmallestCell = -4;
constexpr int kLargestCell = 6;

// takes the body out of a list of owners, the last of which gets its number
void TakeOut(std::vector<std::unique_ptr<SRigidBody>>& bodies, UInt32 number) {
  std::swap(bodies[number], bodies.back());
  bodies[number]->Number = number;
  bodies.pop_back();
}

}  // namespace

CRigidWorld::CRigidWorld(const SRigidSettings& settings, std::function<void()> beforeSubstep)
    : m_settings(settings),
      m_beforeSubstep(std::move(beforeSubstep)),
      m_world(dWorldCreate()),
      m_space(dHashSpaceCreate(nullptr)) {
  dHashSpaceSetLevels(m_space, kSmallestCell, kLargestCell);
  dSpaceSetCleanup(m_space, 0);
  dWorldSetERP(m_world, m_settings.ErrorReduction);
  dWorldSetCFM(m_world, m_settings.ConstraintForceMixing);
  dWorldSetContactSurfaceLayer(m_world, m_settings.SurfaceLayer);
  dWorldSetContactMaxCorrectingVel(m_world, m_settings.MaxCorrectingSpeed);
  dWorldSetQuickStepNumIterations(m_world, static_cast<int>(m_settings.SolverIterations));
  // sleeping is ours: by islands
  dWorldSetAutoDisableFlag(m_world, 0);
  m_contacts = std::make_unique<CContactFinder>(m_settings, m_world, m_space);
}

CRigidWorld::~CRigidWorld() {
  m_contacts->Clear();
  for (auto* bodies : {&m_owned, &m_fixed, &m_planes}) {
    for (const auto& body : *bodies) {
      DestroyRigidBody(*body);
    }
  }
  m_contacts.reset();
  dSpaceDestroy(m_space);
  dWorldDestroy(m_world);
}

void CRigidWorld::SetGravity(const CVector3& gravity) {
  m_gravity = gravity;
  dWorldSetGravity(m_world, gravity.GetX(), gravity.GetY(), gravity.GetZ());
  WakeAll();
}

void CRigidWorld::AddPlane(const SGroundPlane& plane) {
  auto body = std::make_unique<SRigidBody>();
  body->Friction = plane.Friction;
  const dGeomID geom = dCreatePlane(m_space, 0.0, 0.0, 1.0, plane.Height);
  dGeomSetData(geom, body.get());
  dGeomSetCategoryBits(geom, geom_kind::kFixed);
  dGeomSetCollideBits(geom, geom_kind::kSolid | geom_kind::kWheel | geom_kind::kCaster);
  body->Geoms.push_back(geom);
  m_planes.push_back(std::move(body));
  WakeAll();
}

SRigidBody& CRigidWorld::Add(const SRigidSource& source, const SRigidPose& pose) {
  WakeAll();
  auto& list = source.Movable ? m_owned : m_fixed;
  list.push_back(std::make_unique<SRigidBody>());
  SRigidBody& body = *list.back();
  body.Source = source;
  body.Number = static_cast<UInt32>(list.size() - 1);
  BuildRigidBody(body, pose, m_settings, m_world, m_space);
  if (source.Movable) {
    m_movables.push_back(&body);
    if (source.Quadrotor != nullptr) {
      m_flying.push_back(&body);
    }
  }
  return body;
}

void CRigidWorld::Remove(SRigidBody& body) {
  WakeAll();
  DestroyRigidBody(body);
  const UInt32 number = body.Number;
  if (!body.Source.Movable) {
    TakeOut(m_fixed, number);
    return;
  }
  if (body.Source.Quadrotor != nullptr) {
    m_flying.erase(std::find(m_flying.begin(), m_flying.end(), &body));
  }
  m_movables[number] = m_movables.back();
  m_movables.pop_back();
  TakeOut(m_owned, number);
}

void CRigidWorld::Place(SRigidBody& body, const SRigidPose& pose, const SRigidMotion& motion) {
  WakeAll();
  PlaceRigidBody(body, pose, motion);
}

void CRigidWorld::WakeAll() {
  for (SRigidBody* body : m_movables) {
    WakeRigidBody(*body);
  }
}

void CRigidWorld::Advance() {
  StartTick();
  for (UInt32 i = 0; i < m_numSubsteps; ++i) {
    m_beforeSubstep();
    for (SRigidBody* body : m_flying) {
      PushFlyingBody(*body, m_gravity, m_substep);
    }
    m_contacts->Find(m_movables, m_gravity);
    Step();
    m_contacts->Clear();
  }
  if (m_settings.Sleep) {
    LayQuietToSleep();
  }
}

// Takes over what wheels are to do.
void CRigidWorld::StartTick() {
  for (SRigidBody* body : m_movables) {
    if (!body->HasWheels()) {
      continue;
    }
    for (size_t i = 0; i < body->Axles.size(); ++i) {
      const Real speed = body->Source.Wheels[i];
      dJointSetHingeParam(body->Axles[i], dParamVel, speed / body->WheelRadius);
      if (speed != 0.0) {
        WakeRigidBody(*body);
      }
    }
  }
  m_numSubsteps = CountSubsteps();
  SetSubstep(m_settings.Tick / m_numSubsteps);
}

// ODE finds contacts only where bodies are at the end of a substep: none may get through another in
// one, and none may have a controller that is not stable.
UInt32 CRigidWorld::CountSubsteps() const {
  const Real gain = m_gravity.Length() * m_settings.Tick;
  Real strides = 0.0;
  for (const SRigidBody* body : m_movables) {
    if (!body->Asleep) {
      const Real speed = FromODE(dBodyGetLinearVel(body->Body)).Length() +
                         (body->Source.Quadrotor == nullptr ? gain : 0.0);
      strides = std::max(strides, speed * m_settings.Tick / body->Narrowest);
    }
  }
  Real wanted = strides / kMaxStride;
  for (const SRigidBody* body : m_flying) {
    // half of the bound, as in pointmass3d
    const Real bound = ComputeFlightBound(*body->Source.Description);
    wanted = std::max(wanted, m_settings.Tick / (0.5 * bound));
  }
  const Real most = static_cast<Real>(m_settings.Substeps) * kMaxRefinement;
  return std::max(m_settings.Substeps, static_cast<UInt32>(std::ceil(std::min(wanted, most))));
}

void CRigidWorld::SetSubstep(Real substep) {
  m_substep = substep;
  for (SRigidBody* body : m_movables) {
    // the spring and damper that these stand for; see ODE's manual, "Soft constraints"
    const Real spring = substep * body->CasterStiffness;
    if (body->HasWheels()) {
      body->CasterErp = spring / (spring + body->CasterDamping);
      body->CasterCfm = 1.0 / (spring + body->CasterDamping);
    }
  }
}

void CRigidWorld::Step() {
  using enum SRigidSettings::EStepper;
  if (m_settings.Stepper == Iterative) {
    StepIteratively();
  } else if (m_settings.Stepper == Direct ||
             m_contacts->GetMostRows() <= m_settings.MaxDirectRows) {
    dWorldStep(m_world, m_substep);
  } else {
    StepByIslands();
  }
}

// ODE steps every island that has an enabled body: first the small ones, then the large ones.
void CRigidWorld::StepByIslands() {
  const auto enable = [](dBodyID part) { dBodyEnable(part); };
  const auto disable = [](dBodyID part) { dBodyDisable(part); };
  const auto isLarge = [this](const SRigidBody& body) {
    return m_contacts->GetIsland(body).Rows > m_settings.MaxDirectRows;
  };
  m_large.clear();
  for (SRigidBody* body : m_movables) {
    if (!body->Asleep && isLarge(*body)) {
      m_large.push_back(body);
      ForEachPart(*body, disable);
    }
  }
  dWorldStep(m_world, m_substep);
  for (SRigidBody* body : m_movables) {
    if (!body->Asleep) {
      ForEachPart(*body, disable);
    }
  }
  for (SRigidBody* body : m_large) {
    ForEachPart(*body, enable);
  }
  StepIteratively();
  for (SRigidBody* body : m_movables) {
    if (!body->Asleep) {
      ForEachPart(*body, enable);
    }
  }
}

void CRigidWorld::StepIteratively() {
  // another order of the constraints in every step: the errors of one would add up
  SeedODE(m_numIterativeSteps++);
  dWorldQuickStep(m_world, m_substep);
}

// Islands as of the last substep. An island that nothing fixed holds moves on for ever.
void CRigidWorld::LayQuietToSleep() {
  for (SRigidBody* body : m_movables) {
    if (body->Asleep) {
      continue;
    }
    const bool slow = body->Source.Quadrotor == nullptr &&
                      FromODE(dBodyGetLinearVel(body->Body)).Length() < kQuietSpeed &&
                      FromODE(dBodyGetAngularVel(body->Body)).Length() < kQuietTurn;
    body->QuietTime = slow ? body->QuietTime + m_settings.Tick : 0.0;
    if (body->QuietTime < kQuietTime) {
      m_contacts->GetIsland(*body).Quiet = false;
    }
  }
  for (SRigidBody* body : m_movables) {
    if (!body->Asleep) {
      const CContactFinder::SIsland& island = m_contacts->GetIsland(*body);
      if (island.Quiet && island.Supported) {
        LayToSleep(*body);
      }
    }
  }
}

}  // namespace argos
