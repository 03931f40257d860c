#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_stepper.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_motion.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

using EBlock = CImpulseSolver::EKind;
using SBlock = CImpulseSolver::SBlock;
constexpr UInt32 kNone = CImpulseSolver::kNone;

// greatest number of contacts between whose sweeps a crowd of robots is extrapolated
constexpr size_t kMaxCrowdMixed = 256;
// contacts for which threads are worth their start
constexpr size_t kManyContacts = 256;

bool IsOwn(const SRigidBody* body) {
  return body != nullptr && body->Body != nullptr;
}

// two directions at right angles to a normal and to each other
void SetAcross(std::array<CVector3, 3>& directions) {
  const CVector3& normal = directions[0];
  const bool isSteep = std::abs(normal.GetZ()) > 0.7;
  directions[1] = Cross(isSteep ? CVector3::Y : CVector3::Z, normal);
  directions[1] /= directions[1].Length();
  directions[2] = Cross(normal, directions[1]);
}

CVector3 PointVelocity(const CImpulseSolver::SBody& body, const CVector3& arm) {
  return body.Velocity + Cross(body.Turn, arm);
}

}  // namespace

void CRigidStepper::Reserve(size_t bodies) {
  m_islands.reserve(bodies + 1);
  m_places.reserve(bodies);
  m_bodies.reserve(bodies);
}

// Lists the islands in the order of their first bodies; the last entry is the end of all lists.
void CRigidStepper::ListIslands(const SSubstep& substep) {
  CContactFinder& finder = substep.Contacts;
  m_islands.clear();
  m_places.assign(substep.Active.size(), kNone);
  for (const SRigidBody* body : substep.Active) {
    if (body->Asleep) {
      continue;
    }
    const UInt32 number = finder.GetIslandNumber(body->ActiveNumber);
    if (m_places[number] == kNone && !finder.GetIslandByNumber(number).HasJoints) {
      m_places[number] = static_cast<UInt32>(m_islands.size());
      m_islands.push_back({number, {}});
    }
  }
  m_islands.emplace_back();
}

// Sorts items 0..count-1 by island; those of an island keep their order.
template <typename VALUE, typename PLACE, typename GET>
void CRigidStepper::Distribute(EList list, size_t count, PLACE&& placeOf, GET&& get,
                               std::vector<VALUE>& sorted) {
  for (size_t i = 0; i < count; ++i) {
    if (const UInt32 place = placeOf(i); place != kNone) {
      ++m_islands[place].Starts[list];
    }
  }
  // from numbers to the ends of lists, which the loop below turns into their starts
  UInt32 sum = 0;
  for (SIsland& island : m_islands) {
    sum = island.Starts[list] += sum;
  }
  sorted.resize(sum);
  for (size_t i = count; i-- > 0;) {
    if (const UInt32 place = placeOf(i); place != kNone) {
      sorted[--m_islands[place].Starts[list]] = get(i);
    }
  }
}

void CRigidStepper::Sort(const SSubstep& substep) {
  ListIslands(substep);
  m_allHolds.clear();
  substep.Grips.ForEachHold([this](CRigidGrips::SHold& hold) { m_allHolds.push_back(&hold); });
  const std::vector<SRigidBody*>& bodies = substep.Active;
  const std::vector<SRigidContact>& contacts = substep.Contacts.GetContacts();
  const auto placeOf = [&](UInt32 body) {
    return m_places[substep.Contacts.GetIslandNumber(body)];
  };
  Distribute(
      kBodies, bodies.size(),
      [&](size_t i) { return bodies[i]->Asleep ? kNone : placeOf(bodies[i]->ActiveNumber); },
      [&](size_t i) { return bodies[i]; }, m_bodies);
  Distribute(
      kContacts, contacts.size(),
      [&](size_t i) { return contacts[i].IsVoid ? kNone : placeOf(contacts[i].Counted); },
      [](size_t i) { return static_cast<UInt32>(i); }, m_contacts);
  Distribute(
      kHolds, m_allHolds.size(),
      [&](size_t i) { return placeOf(m_allHolds[i]->Robot->ActiveNumber); },
      [&](size_t i) { return m_allHolds[i]; }, m_holds);
}

void CRigidStepper::Step(const SSubstep& substep, CThreadPool* pool) {
  Sort(substep);
  const size_t threads = pool != nullptr ? pool->GetNumThreads() : 1;
  if (m_spaces.size() < threads) {
    const size_t old = m_spaces.size();
    m_spaces.resize(threads);
    for (size_t i = old; i < threads; ++i) {
      m_spaces[i].Reserve();
    }
  }
  const size_t count = m_islands.size() - 1;
  const auto step = [&](size_t begin, size_t end, UInt32 thread) {
    for (size_t i = begin; i < end; ++i) {
      StepIsland(substep, i, m_spaces[thread]);
    }
  };
  if (pool != nullptr && m_contacts.size() >= kManyContacts) {
    pool->ParallelFor(count, 1, step);
  } else {
    step(0, count, 0);
  }
}

// Small islands are swept until they converge, large ones as often as their size allows; objects
// that tumble, and balls, which sweeps settle as well without extrapolation, fewer times: where
// they touch changes before that would converge.
CRigidStepper::SEffort CRigidStepper::ChooseEffort(const SSubstep& substep, size_t island,
                                                   const CImpulseSolver& solver) const {
  const UInt32 fewest = m_settings.SolverIterations;
  const bool isIterative = m_settings.Stepper == SRigidSettings::EStepper::Iterative;
  if (substep.Contacts.GetIslandByNumber(m_islands[island].Number).Rows <=
      m_settings.MaxDirectRows) {
    return {isIterative ? fewest : std::max(fewest, kMaxSweeps), kSweepTolerance, true};
  }
  const size_t blocks = solver.Blocks.size();
  const auto isPoint = [](const SBlock& block) { return block.Patch > 0.0; };
  const bool areBalls = 2 * std::count_if(solver.Blocks.begin(), solver.Blocks.end(), isPoint) >
                        static_cast<std::ptrdiff_t>(blocks);
  Real fastest = 0.0;
  if (IsTumbling(island, fastest) || areBalls) {
    return {std::min(fewest, kTumblingSweeps),
            std::max(kSweepTolerance, kRelativeTolerance * fastest), false};
  }
  const UInt32 most = static_cast<UInt32>(kMaxBlockSweeps / std::max<size_t>(blocks, 1));
  // extrapolation costs half a sweep: stacks need it, crowds of robots do not
  const bool extrapolates = blocks <= kMaxCrowdMixed || AreObjects(island);
  return {isIterative ? fewest : std::max(fewest, std::min(most, kMaxSweeps)), kSweepTolerance,
          extrapolates};
}

// Objects that begin to touch, or whose forces are forgotten because a body was placed, bear their
// weights at once.
void CRigidStepper::StartFromWeights(const SSubstep& substep, size_t island,
                                     SWorkspace& space) const {
  CImpulseSolver& solver = space.Solver;
  const Real fall = -substep.Gravity.GetZ() * substep.Length;
  const bool areNew =
      std::all_of(solver.Blocks.begin(), solver.Blocks.end(), [](const SBlock& block) {
        return block.Kind == EBlock::Contact && block.Impulses[0] == 0.0;
      });
  if (solver.Blocks.empty() || !areNew || !(fall > 0.0) || !AreObjects(island)) {
    return;
  }
  std::vector<Real>& heights = space.Weights.GetHeights();
  heights.clear();
  for (const SMember& member : space.Members) {
    heights.push_back(member.Centre.GetZ());
  }
  space.Weights.Apply(solver, fall);
}

bool CRigidStepper::AreObjects(size_t island) const {
  return std::none_of(m_bodies.begin() + m_islands[island].Starts[kBodies],
                      m_bodies.begin() + m_islands[island + 1].Starts[kBodies],
                      [](const SRigidBody* body) { return body->HasDrive(); });
}

// @return true if all bodies are objects of which more than half tumble. @param fastest  receives
// the greatest speed of the bodies, m/s.
bool CRigidStepper::IsTumbling(size_t island, Real& fastest) const {
  const UInt32 begin = m_islands[island].Starts[kBodies];
  const UInt32 end = m_islands[island + 1].Starts[kBodies];
  UInt32 count = 0;
  for (UInt32 i = begin; i < end; ++i) {
    const Real speed = FromODE(dBodyGetLinearVel(m_bodies[i]->Body)).Length();
    fastest = std::max(fastest, speed);
    count += speed > kTumblingSpeed ? 1 : 0;
  }
  return 2 * count > end - begin && AreObjects(island);
}

void CRigidStepper::StepIsland(const SSubstep& substep, size_t island, SWorkspace& space) {
  const SIsland& begin = m_islands[island];
  const SIsland& end = m_islands[island + 1];
  CImpulseSolver& solver = space.Solver;
  solver.Clear();
  space.Members.assign(1, {});
  for (UInt32 i = begin.Starts[kBodies]; i < end.Starts[kBodies]; ++i) {
    AddBody(substep, *m_bodies[i], space);
  }
  for (UInt32 i = begin.Starts[kContacts]; i < end.Starts[kContacts]; ++i) {
    AddContact(substep, substep.Contacts.GetContacts()[m_contacts[i]], space);
  }
  for (UInt32 i = begin.Starts[kHolds]; i < end.Starts[kHolds]; ++i) {
    AddHold(substep, *m_holds[i], space);
  }
  for (UInt32 i = begin.Starts[kBodies]; i < end.Starts[kBodies]; ++i) {
    if (m_bodies[i]->HasPlanarDrive()) {
      AddDrive(substep, *m_bodies[i], space);
    }
  }
  StartFromWeights(substep, island, space);
  solver.Prepare();
  const SEffort effort = ChooseEffort(substep, island, solver);
  solver.Solve(effort.Sweeps, effort.Tolerance, effort.Extrapolates);
  StoreForces(substep, island, space);
  Rest(substep, island, space);
  for (UInt32 i = 1; i < space.Members.size(); ++i) {
    Move(substep, i, space);
  }
}

void CRigidStepper::AddBody(const SSubstep& substep, SRigidBody& body, SWorkspace& space) const {
  const UInt32 number = static_cast<UInt32>(space.Members.size());
  body.SolverBody = number;
  body.SolverRotor = static_cast<UInt32>(space.Solver.Rotors.size());
  SMember& member = space.Members.emplace_back();
  member.Body = &body;
  CImpulseSolver::SBody& added = space.Solver.Bodies.emplace_back();
  const CVector3 place = FromODE(dBodyGetPosition(body.Body));
  added.Turn = FromODE(dBodyGetAngularVel(body.Body));
  added.Velocity = FromODE(dBodyGetLinearVel(body.Body));
  member.Centre = place;
  if (dBodyIsKinematic(body.Body) != 0) {
    return;
  }
  const SJointMass mass = AddUpParts(body);
  const dReal* const rotation = dBodyGetRotation(body.Body);
  member.Offset = mass.Offset;
  const CVector3 offset = InWorld(rotation, mass.Offset);
  member.Centre += offset;
  added.Velocity += Cross(added.Turn, offset);
  added.InverseMass = 1.0 / mass.Mass;
  added.InverseInertia = InWorld(rotation, mass.Inertia.Inverted());
  if (dBodyGetGyroscopicMode(body.Body) != 0) {
    added.Turn = TurnFreely(added.Turn, rotation, mass.Inertia, substep.Length);
  }
  const CVector3 force = FromODE(dBodyGetForce(body.Body));
  const CVector3 torque = FromODE(dBodyGetTorque(body.Body)) - Cross(offset, force);
  member.IsPushed = force.SquareLength() > 0.0 || torque.SquareLength() > 0.0;
  added.Velocity += (substep.Gravity + force * added.InverseMass) * substep.Length;
  added.Turn += added.InverseInertia * torque * substep.Length;
  AddRotors(body, substep.Length, number, space);
}

void CRigidStepper::AddRotors(const SRigidBody& body, Real length, UInt32 number,
                              SWorkspace& space) const {
  const auto add = [&](dBodyID part, dJointID joint, UInt32 axis, Real torque) {
    dMass mass;
    dBodyGetMass(part, &mass);
    const dReal* const rotation = dBodyGetRotation(body.Body);
    CImpulseSolver::SRotor& rotor = space.Solver.Rotors.emplace_back();
    rotor.Body = number;
    rotor.Axis.Set(rotation[axis], rotation[4 + axis], rotation[8 + axis]);
    rotor.InverseInertia = 1.0 / mass.I[0];
    rotor.Spin = FromODE(dBodyGetAngularVel(part)).DotProduct(rotor.Axis);
    rotor.Target = dJointGetHingeParam(joint, dParamVel);
    rotor.Limit = dJointGetHingeParam(joint, dParamFMax) * length;
    rotor.Impulse = torque * length;
  };
  for (size_t i = 0; body.HasWheels() && i < body.Wheels.size(); ++i) {
    add(body.Wheels[i], body.Axles[i], 1, body.AxleTorques[i]);
  }
  if (body.TurretBody != nullptr) {
    const auto hold = std::find_if(m_allHolds.begin(), m_allHolds.end(),
                                   [&](const auto* each) { return each->Robot == &body; });
    add(body.TurretBody, (*hold)->Pivot, 2, (*hold)->Torque);
  }
}

void CRigidStepper::AddContact(const SSubstep& substep, const SRigidContact& contact,
                               SWorkspace& space) const {
  const dSurfaceParameters& surface = contact.Contact.surface;
  SBlock& block = space.Solver.Blocks.emplace_back();
  block.First = IsOwn(contact.First) ? contact.First->SolverBody : 0;
  block.Second = IsOwn(contact.Second) ? contact.Second->SolverBody : 0;
  const CVector3 point = FromODE(contact.Contact.geom.pos);
  block.FirstArm = point - space.Members[block.First].Centre;
  block.SecondArm = point - space.Members[block.Second].Centre;
  block.Directions[0] = FromODE(contact.Contact.geom.normal);
  SetAcross(block.Directions);
  block.Friction = surface.mu;
  block.Patch = contact.Patch;
  block.RollArm = kRollShare * contact.Patch;
  block.Impulses[0] = contact.Force * substep.Length;
  block.Settled = contact.Settled * substep.Length;
  const CVector3 friction = contact.Friction * substep.Length;
  block.Impulses[1] = friction.DotProduct(block.Directions[1]);
  block.Impulses[2] = friction.DotProduct(block.Directions[2]);

  Real reduction = m_settings.ErrorReduction;
  if (contact.Wheel != SRigidContact::kNoWheel) {
    const dBodyID wheel = contact.First->Wheels[contact.Wheel];
    block.Rotor = contact.First->SolverRotor + contact.Wheel;
    block.RotorArm = point - FromODE(dBodyGetPosition(wheel));
    reduction = surface.soft_erp;
    block.Softness = surface.soft_cfm / substep.Length;
  }
  const Real depth = std::max(0.0, contact.Contact.geom.depth - m_settings.SurfaceLayer);
  Real speed = reduction * depth / substep.Length;
  if ((surface.mode & dContactMotionN) != 0) {
    speed += surface.motionN;
  }
  speed = std::min(speed, m_settings.MaxCorrectingSpeed);
  if ((surface.mode & dContactBounce) != 0) {
    // before gravity and other forces act
    const auto velocityOf = [&](const SRigidBody& body, const CVector3& arm, UInt32 number) {
      return number == CImpulseSolver::kGround
                 ? CVector3()
                 : PointVelocity({FromODE(dBodyGetLinearVel(body.Body)),
                                  FromODE(dBodyGetAngularVel(body.Body)),
                                  0.0,
                                  {}},
                                 arm);
    };
    const Real approach =
        -block.Directions[0].DotProduct(velocityOf(*contact.First, block.FirstArm, block.First) -
                                        velocityOf(*contact.Second, block.SecondArm, block.Second));
    if (approach > surface.bounce_vel) {
      speed = std::max(speed, surface.bounce * approach);
    }
  }
  block.Targets[0] = speed;
}

void CRigidStepper::AddHold(const SSubstep& substep, const CRigidGrips::SHold& hold,
                            SWorkspace& space) const {
  dVector3 arm;
  dVector3 grip;
  dJointGetBallAnchor(hold.Hold, arm);
  dJointGetBallAnchor2(hold.Hold, grip);
  SBlock& block = space.Solver.Blocks.emplace_back();
  block.Kind = EBlock::Ball;
  block.ForceLimit = hold.Robot->Source.Description->Gripper->MaxForce * substep.Length;
  block.First = hold.Robot->SolverBody;
  block.Second = hold.Held->SolverBody;
  block.Directions = {CVector3::X, CVector3::Y, CVector3::Z};
  block.FirstArm = FromODE(arm) - space.Members[block.First].Centre;
  block.SecondArm = FromODE(grip) - space.Members[block.Second].Centre;
  if (hold.Pivot != nullptr) {
    block.Rotor = hold.Robot->SolverRotor + (hold.Robot->HasWheels() ? 2 : 0);
    block.RotorArm = FromODE(arm) - FromODE(dBodyGetPosition(hold.Robot->Body));
  }
  const CVector3 error = FromODE(arm) - FromODE(grip);
  for (UInt32 i = 0; i < 3; ++i) {
    block.Targets[i] = -m_settings.ErrorReduction * error[i] / substep.Length;
    block.Impulses[i] = hold.Force[i] * substep.Length;
  }
}

void CRigidStepper::AddDrive(const SSubstep& substep, const SRigidBody& body, SWorkspace& space) {
  SBlock& block = space.Solver.Blocks.emplace_back();
  block.Kind = EBlock::Drive;
  block.First = body.SolverBody;
  block.Directions = {CVector3::Z, CVector3::X, CVector3::Y};
  dVector3 ahead;
  dVector3 aside;
  dJointGetLMotorAxis(body.PlanarMotor, 0, ahead);
  dJointGetLMotorAxis(body.PlanarMotor, 1, aside);
  const CVector3 target = FromODE(ahead) * dJointGetLMotorParam(body.PlanarMotor, dParamVel) +
                          FromODE(aside) * dJointGetLMotorParam(body.PlanarMotor, dParamVel2);
  block.Targets = {dJointGetAMotorParam(body.YawMotor, dParamVel), target.GetX(), target.GetY()};
  block.TorqueLimit = dJointGetAMotorParam(body.YawMotor, dParamFMax) * substep.Length;
  block.ForceLimit = dJointGetLMotorParam(body.PlanarMotor, dParamFMax) * substep.Length;
  for (size_t i = 0; i < 3; ++i) {
    block.Impulses[i] = body.DriveForces[i] * substep.Length;
  }
}

void CRigidStepper::StoreForces(const SSubstep& substep, size_t island, SWorkspace& space) {
  const SIsland& begin = m_islands[island];
  const SIsland& end = m_islands[island + 1];
  const CImpulseSolver& solver = space.Solver;
  const SBlock* block = solver.Blocks.data();
  const Real rate = 1.0 / substep.Length;
  for (UInt32 i = begin.Starts[kContacts]; i < end.Starts[kContacts]; ++i, ++block) {
    SRigidContact& contact = substep.Contacts.GetContacts()[m_contacts[i]];
    contact.Force = block->Impulses[0] * rate;
    // so that what becomes lighter is not lifted
    contact.Settled = std::min(block->Settled * rate, contact.Force);
    contact.Friction =
        (block->Directions[1] * block->Impulses[1] + block->Directions[2] * block->Impulses[2]) *
        rate;
  }
  for (UInt32 i = begin.Starts[kHolds]; i < end.Starts[kHolds]; ++i, ++block) {
    CRigidGrips::SHold& hold = *m_holds[i];
    for (UInt32 axis = 0; axis < 3; ++axis) {
      hold.Force[axis] = hold.Pull.f1[axis] = block->Impulses[axis] * rate;
    }
    hold.Torque = hold.Pivot != nullptr ? solver.Rotors[block->Rotor].Impulse * rate : 0.0;
  }
  for (UInt32 i = begin.Starts[kBodies]; i < end.Starts[kBodies]; ++i) {
    SRigidBody& body = *m_bodies[i];
    for (size_t j = 0; body.HasPlanarDrive() && j < 3; ++j) {
      body.DriveForces[j] = block->Impulses[j] * rate;
    }
    block += body.HasPlanarDrive() ? 1 : 0;
    for (size_t j = 0; body.HasWheels() && j < body.Wheels.size(); ++j) {
      body.AxleTorques[j] = solver.Rotors[body.SolverRotor + j].Impulse * rate;
    }
  }
}

// An island that stands on something and in which no body is faster than its share of gravity in a
// substep does not move: what is left of its speeds is the error of the solver, and would be a
// force if the next substep went on from it.
void CRigidStepper::Rest(const SSubstep& substep, size_t island, SWorkspace& space) const {
  std::vector<CImpulseSolver::SBody>& moved = space.Solver.Bodies;
  const Real most = kRestShare * substep.Gravity.Length() * substep.Length;
  bool rests = substep.Contacts.GetIslandByNumber(m_islands[island].Number).Supported &&
               m_islands[island].Starts[kHolds] == m_islands[island + 1].Starts[kHolds];
  for (UInt32 i = 1; rests && i < space.Members.size(); ++i) {
    const SRigidBody& body = *space.Members[i].Body;
    rests = !body.HasDrive() && !space.Members[i].IsPushed && body.Source.Quadrotor == nullptr &&
            moved[i].Velocity.SquareLength() < most * most &&
            moved[i].Turn.Length() * body.Narrowest < most;
  }
  for (UInt32 i = 1; i < space.Members.size(); ++i) {
    space.Members[i].Body->Rests = rests;
    if (rests) {
      moved[i].Velocity = moved[i].Turn = CVector3();
    }
  }
}

// Wheels and turrets move with their robot.
void CRigidStepper::Move(const SSubstep& substep, UInt32 number, const SWorkspace& space) {
  const SMember& member = space.Members[number];
  const CImpulseSolver::SBody& moved = space.Solver.Bodies[number];
  const SRigidBody& body = *member.Body;
  const CQuaternion before = QuaternionFromODE(dBodyGetQuaternion(body.Body));
  const CVector3 centre = member.Centre + moved.Velocity * substep.Length;
  const CQuaternion after = Rotate(before, moved.Turn * substep.Length);
  PutOrientation(body.Body, after);
  const dReal* const rotation = dBodyGetRotation(body.Body);
  const CVector3 offset = InWorld(rotation, member.Offset);
  PutMotion(body.Body, centre - offset, moved.Velocity - Cross(moved.Turn, offset), moved.Turn);

  const auto follow = [&](dBodyID part, const CVector3& place, UInt32 rotor, const CVector3& own) {
    const CImpulseSolver::SRotor& spun = space.Solver.Rotors[body.SolverRotor + rotor];
    const Real spin = spun.Spin - spun.Axis.DotProduct(moved.Turn);
    const CQuaternion relative = before.Inverse() * QuaternionFromODE(dBodyGetQuaternion(part));
    PutOrientation(part, after * Rotate(relative, own * (spin * substep.Length)));
    PutMotion(part, place, moved.Velocity + Cross(moved.Turn, place - centre),
              moved.Turn + InWorld(rotation, own) * spin);
  };
  const CVector3 main = centre - offset;
  UInt32 rotors = 0;
  for (size_t i = 0; body.HasWheels() && i < body.Wheels.size(); ++i) {
    follow(body.Wheels[i], main + InWorld(rotation, body.Rollers[i].Offset), rotors++, CVector3::Y);
  }
  if (body.TurretBody != nullptr) {
    follow(body.TurretBody, main, rotors, CVector3::Z);
  }
}

}  // namespace argos
