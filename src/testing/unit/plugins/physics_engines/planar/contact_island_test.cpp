// Compares the impulses that are found with the laws that they have to obey.

#include <argos3/plugins/simulator/physics_engines/planar/contact_island.h>

#include <argos3/core/utility/math/random_stream.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

namespace argos::contact_island_test {

namespace {

template <typename NUMBER>
struct SIsland {
  std::vector<SIslandBody<NUMBER>> Bodies;
  std::vector<SIslandContact<NUMBER>> Contacts;
  std::vector<SIslandGrip<NUMBER>> Grips;

  SIslandBody<NUMBER>& AddBody(NUMBER mass, NUMBER inertia, NUMBER most, NUMBER angularMost) {
    SIslandBody<NUMBER>& body = Bodies.emplace_back();
    body.Most = most;
    body.AngularMost = angularMost;
    body.Mass = mass;
    body.Inertia = inertia;
    body.InverseMass = mass > 0 ? 1 / mass : 0;
    body.InverseInertia = inertia > 0 ? 1 / inertia : 0;
    return body;
  }
};

// Two robots drive and turn against a cylinder of 0.2 kg from two sides, as in the benchmark's
// scene "shove": friction drags the cylinder along, and the robots apart.
template <typename NUMBER>
SIsland<NUMBER> MakeRubbedCylinder() {
  SIsland<NUMBER> island;
  const auto addBody = [&](NUMBER x, NUMBER y, NUMBER turn, NUMBER mass, NUMBER inertia,
                           NUMBER most, NUMBER angularMost) -> SIslandBody<NUMBER>& {
    SIslandBody<NUMBER>& body = island.AddBody(mass, inertia, most, angularMost);
    body.Velocity.Set({x, y, turn});
    return body;
  };
  const NUMBER turning[3] = {NUMBER(0), NUMBER(0), NUMBER(0.857)};
  const NUMBER driving[3] = {NUMBER(0.00263), NUMBER(-0.0117), NUMBER(0.771)};
  std::copy_n(turning, 3,
              addBody(NUMBER(0.0853), NUMBER(-0.000523), NUMBER(0.636), NUMBER(1.6),
                      NUMBER(0.02314), NUMBER(0.75), NUMBER(7.5))
                  .Target);
  std::copy_n(driving, 3,
              addBody(NUMBER(-0.102), NUMBER(-0.0284), NUMBER(-0.201), NUMBER(1.6), NUMBER(0.02314),
                      NUMBER(0.75), NUMBER(7.5))
                  .Target);
  addBody(NUMBER(-0.167), NUMBER(-0.356), NUMBER(-11.5), NUMBER(0.2), NUMBER(0.001), NUMBER(0.0745),
          NUMBER(0.0745));
  addBody(0, 0, 0, 0, 0, 0, 0);
  const auto touch = [&](UInt32 robot, NUMBER angle, NUMBER approach) {
    SIslandContact<NUMBER>& contact = island.Contacts.emplace_back();
    contact.A = robot;
    contact.B = 2;
    contact.NX = std::cos(angle);
    contact.NY = std::sin(angle);
    contact.TangentLeverA = NUMBER(0.085);
    contact.TangentLeverB = NUMBER(-0.1);
    contact.Approach = approach;
    contact.Friction = NUMBER(0.49);
    const SIslandBody<NUMBER>& a = island.Bodies[robot];
    const SIslandBody<NUMBER>& b = island.Bodies[2];
    contact.InverseMass = a.InverseMass + b.InverseMass;
    contact.InverseTangentMass = contact.InverseMass +
                                 a.InverseInertia * contact.TangentLeverA * contact.TangentLeverA +
                                 b.InverseInertia * contact.TangentLeverB * contact.TangentLeverB;
    contact.Mass = 1 / contact.InverseMass;
    contact.TangentMass = 1 / contact.InverseTangentMass;
  };
  touch(0, NUMBER(2.68), NUMBER(0.00073));
  touch(1, NUMBER(-0.95), NUMBER(0));
  return island;
}

template <typename NUMBER>
void CheckContact(const SIsland<NUMBER>& island, const SIslandContact<NUMBER>& contact,
                  NUMBER tolerance) {
  const NUMBER* const a = island.Bodies[contact.A].Velocity.Now;
  const NUMBER* const b = island.Bodies[contact.B].Velocity.Now;
  const NUMBER x = b[kAxisX] - a[kAxisX];
  const NUMBER y = b[kAxisY] - a[kAxisY];
  const NUMBER approach = a[kAxisTurn] * contact.NormalLeverA -
                          b[kAxisTurn] * contact.NormalLeverB - (x * contact.NX + y * contact.NY) -
                          contact.Approach;
  const NUMBER slip = y * contact.NX - x * contact.NY + b[kAxisTurn] * contact.TangentLeverB -
                      a[kAxisTurn] * contact.TangentLeverA;
  const NUMBER normal = contact.Impulse.Now[kAxisNormal];
  const NUMBER tangent = contact.Impulse.Now[kAxisTangent];
  const NUMBER most = contact.Friction * normal;
  CAPTURE(contact.A, approach, slip, normal, tangent);
  CHECK(normal >= 0);
  CHECK(approach <= tolerance);
  CHECK((normal == 0 || approach >= -tolerance));
  CHECK(std::abs(tangent) <= most * NUMBER(1.00001));
  // friction that is not at its bound stops, at the bound it opposes
  CHECK((std::abs(tangent) >= most * NUMBER(0.99999) || std::abs(slip) <= tolerance));
  CHECK(slip * tangent <= tolerance * most);
}

template <typename NUMBER>
void CheckDrive(const SIslandBody<NUMBER>& body, NUMBER tolerance) {
  const NUMBER x = body.Target[kAxisX] - body.Velocity.Now[kAxisX];
  const NUMBER y = body.Target[kAxisY] - body.Velocity.Now[kAxisY];
  const NUMBER* const impulse = body.Impulse.Now;
  const NUMBER length = std::hypot(impulse[kAxisX], impulse[kAxisY]);
  CAPTURE(x, y, impulse[kAxisX], impulse[kAxisY], body.Most);
  CHECK(length <= body.Most * NUMBER(1.00001));
  CHECK((length >= body.Most * NUMBER(0.99999) || std::hypot(x, y) <= tolerance));
  // at its bound it aims at the target
  CHECK(x * impulse[kAxisX] + y * impulse[kAxisY] >=
        std::hypot(x, y) * length - tolerance * body.Most);
}

// the same of its torque; @param tolerance  rad/s
template <typename NUMBER>
void CheckTorque(const SIslandBody<NUMBER>& body, NUMBER tolerance) {
  const NUMBER turn = body.Target[kAxisTurn] - body.Velocity.Now[kAxisTurn];
  const NUMBER impulse = body.Impulse.Now[kAxisTurn];
  CAPTURE(turn, impulse, body.AngularMost);
  CHECK(std::abs(impulse) <= body.AngularMost);
  CHECK((std::abs(impulse) >= body.AngularMost * NUMBER(0.99999) || std::abs(turn) <= tolerance));
  CHECK(turn * impulse >= -tolerance * body.AngularMost);
}

// Bodies with drives of any strength, or none, that touch each other, and something immovable, at
// random places and angles, with and without friction.
SIsland<Real> MakeRandomIsland(int numContacts, unsigned seed) {
  CRandomStream random(seed, "test", "contact island", "random");
  const auto pick = [&random](std::initializer_list<Real> values) {
    const auto place = static_cast<size_t>(random.Uniform(0.0, static_cast<Real>(values.size())));
    return values.begin()[std::min(place, values.size() - 1)];
  };
  SIsland<Real> island;
  const int numBodies = std::max(2, 2 * numContacts / 3);
  for (int i = 0; i < numBodies; ++i) {
    const Real mass = pick({0.1, 1.0, 10.0});
    SIslandBody<Real>& body = island.AddBody(mass, 0.005 * mass, pick({0.0, 0.02, 10.0}) * mass,
                                             pick({0.0, 1e-4, 0.1}) * mass);
    body.Velocity.Set(
        {random.Uniform(-0.1, 0.1), random.Uniform(-0.1, 0.1), random.Uniform(-0.5, 0.5)});
    for (Real& target : body.Target) {
      target = random.Uniform(-0.1, 0.1);
    }
  }
  island.AddBody(0, 0, 0, 0);
  for (int i = 0; i < numContacts; ++i) {
    SIslandContact<Real>& contact = island.Contacts.emplace_back();
    contact.B = static_cast<UInt32>(i % numBodies);
    // the last one is immovable
    contact.A = (contact.B + 1 + static_cast<UInt32>(random.Uniform(0.0, numBodies))) %
                static_cast<UInt32>(numBodies + 1);
    const Real angle = random.Uniform(-4.0, 4.0);
    contact.NX = std::cos(angle);
    contact.NY = std::sin(angle);
    for (Real* const lever : {&contact.NormalLeverA, &contact.TangentLeverA, &contact.NormalLeverB,
                              &contact.TangentLeverB}) {
      *lever = random.Uniform(-0.1, 0.1);
    }
    contact.Approach = pick({0.0, 0.01});
    contact.Friction = pick({0.0, 0.3, 1.0});
    const SIslandBody<Real>& a = island.Bodies[contact.A];
    const SIslandBody<Real>& b = island.Bodies[contact.B];
    const auto compute = [&](Real leverA, Real leverB) {
      return a.InverseMass + b.InverseMass + a.InverseInertia * leverA * leverA +
             b.InverseInertia * leverB * leverB;
    };
    contact.InverseMass = compute(contact.NormalLeverA, contact.NormalLeverB);
    contact.InverseTangentMass = compute(contact.TangentLeverA, contact.TangentLeverB);
    contact.Mass = 1.0 / contact.InverseMass;
    contact.TangentMass = 1.0 / contact.InverseTangentMass;
  }
  return island;
}

template <typename NUMBER>
void CheckRubbedCylinder() {
  // that of the crowd solver, m/s
  const auto tolerance = NUMBER(1.7e-4);
  SIsland<NUMBER> island = MakeRubbedCylinder<NUMBER>();
  const UInt32 sweeps =
      CContactIsland<NUMBER>(island.Bodies, island.Contacts).Solve(tolerance, 150);
  // the conjugate gradient method alone takes more than 1,000
  CHECK(sweeps <= 40);
  // what a sweep would still change, and what its contacts change of the drives
  const NUMBER accuracy = 4 * tolerance;
  for (const SIslandContact<NUMBER>& contact : island.Contacts) {
    CheckContact(island, contact, accuracy);
  }
  for (const SIslandBody<NUMBER>& body : island.Bodies) {
    CheckDrive(body, accuracy);
  }
}

// A robot that drives and turns, and a load that it holds ahead of it by its turret, in a substep
// of 10 ms.
template <typename NUMBER>
SIsland<NUMBER> MakeTow(Real mass, Real torque, bool hasTurret) {
  SIsland<NUMBER> island;
  const auto load = static_cast<NUMBER>(mass);
  SIslandBody<NUMBER>& robot =
      island.AddBody(NUMBER(1.6), NUMBER(0.02314), NUMBER(0.15), NUMBER(0.01));
  robot.Target[kAxisX] = NUMBER(-0.1);
  robot.Target[kAxisTurn] = NUMBER(0.4);
  island.AddBody(load, load * NUMBER(0.004), NUMBER(0.0149), NUMBER(0.0149));
  island.AddBody(0, 0, 0, 0);
  SIslandGrip<NUMBER>& grip = island.Grips.emplace_back();
  grip.A = 0;
  grip.B = 1;
  grip.NX = NUMBER(0.8);
  grip.NY = NUMBER(0.6);
  NUMBER* const lever = hasTurret ? grip.ArmLever : grip.BaseLever;
  lever[kAxisAcross] = NUMBER(0.09);
  grip.HeldLever[kAxisAlong] = NUMBER(0.02);
  grip.HeldLever[kAxisAcross] = NUMBER(-0.1);
  grip.Softness[kAxisAlong] = NUMBER(0.3);
  grip.Bias[kAxisAlong] = NUMBER(0.01);
  if (hasTurret) {
    grip.InverseArmInertia = NUMBER(1e4);
    grip.MotorRate = NUMBER(0.7);
    grip.MotorMost = static_cast<NUMBER>(0.01 * torque);
  }
  return island;
}

// the arm's end has the speed of the held point, and the motor that which it aims at or its bound;
// @param accuracy  m/s
template <typename NUMBER>
void CheckGrip(const SIsland<NUMBER>& island, const SIslandGrip<NUMBER>& grip, NUMBER accuracy) {
  const SIslandBody<NUMBER>& holder = island.Bodies[grip.A];
  NUMBER speeds[2];
  ComputeGripSpeeds(grip, GetGripMotion(holder), GetGripMotion(island.Bodies[grip.B]), speeds);
  for (const int axis : {kAxisAlong, kAxisAcross}) {
    const NUMBER rest =
        speeds[axis] + grip.Bias[axis] + grip.Softness[axis] * grip.Impulse.Now[axis];
    CHECK(std::abs(rest) <= accuracy);
  }
  const NUMBER motor = grip.Impulse.Now[kAxisMotor];
  const NUMBER late = grip.MotorRate + holder.Velocity.Now[kAxisTurn] - grip.ArmRate.Now[0];
  CHECK(std::abs(motor) <= grip.MotorMost * NUMBER(1.00001));
  if (grip.HasTurret() && std::abs(motor) < grip.MotorMost * NUMBER(0.99999)) {
    CHECK(std::abs(late) <= NUMBER(1e-3));
  }
  CHECK(late * motor >= -NUMBER(1e-3) * grip.MotorMost);
}

template <typename NUMBER>
void CheckTow(Real mass, Real torque, bool hasTurret) {
  CAPTURE(mass, torque, hasTurret);
  const auto tolerance = NUMBER(1e-5);  // m/s
  SIsland<NUMBER> island = MakeTow<NUMBER>(mass, torque, hasTurret);
  const UInt32 sweeps =
      CContactIsland<NUMBER>(island.Bodies, island.Contacts, island.Grips).Solve(tolerance, 150);
  CHECK(sweeps <= 20);
  for (const SIslandBody<NUMBER>& body : island.Bodies) {
    CheckDrive(body, 4 * tolerance);
  }
  CheckGrip(island, island.Grips.front(), 4 * tolerance);
}

// Two foot-bots that hold each other, side by side at a random angle, in a substep of 50 ms: each
// holds the other's turret, and the turrets turn as they like, with a torque of 150 N m.
SIsland<float> MakeEmbrace(unsigned seed) {
  CRandomStream random(seed, "test", "contact island", "embrace");
  SIsland<float> island;
  const auto draw = [&random](Real most) {
    return static_cast<float>(random.Uniform(-most, most));
  };
  constexpr float kDuration = 0.05F;  // s
  for (int i = 0; i < 2; ++i) {
    SIslandBody<float>& robot =
        island.AddBody(1.6F, 0.02314F, 15.0F * kDuration, 150.0F * kDuration);
    robot.Target[kAxisX] = draw(0.12);
    robot.Target[kAxisY] = draw(0.12);
    robot.Target[kAxisTurn] = draw(1.0);
  }
  for (UInt32 holder = 0; holder < 2; ++holder) {
    SIslandGrip<float>& grip = island.Grips.emplace_back();
    grip.A = holder;
    grip.B = 1 - holder;
    const float angle = draw(4.0);
    grip.NX = std::cos(angle);
    grip.NY = std::sin(angle);
    grip.ArmLever[kAxisAcross] = 0.09F;
    grip.ArmLever[kAxisAlong] = draw(0.002);
    const float held = draw(4.0);
    grip.HeldLever[kAxisAlong] = 0.085F * std::sin(held);
    grip.HeldLever[kAxisAcross] = 0.085F * std::cos(held);
    grip.Softness[kAxisAlong] = 0.15F;
    grip.Bias[kAxisAlong] = draw(0.01);
    grip.Bias[kAxisAcross] = draw(0.01);
    grip.InverseArmInertia = 1.0F / 0.02314F;
    grip.MotorRate = draw(1.0);
    grip.MotorMost = 150.0F * kDuration;
  }
  return island;
}

}  // namespace

TEST_CASE("contact island: the forces are found on an object that two robots rub",
          "[unit][planar]") {
  CheckRubbedCylinder<double>();
  CheckRubbedCylinder<float>();
}

TEST_CASE("contact island: any bodies with any contacts obey the laws", "[unit][planar]") {
  // Newton's method has room for 96 contacts, or 48 that stick
  const int numContacts = GENERATE(1, 2, 5, 20, 60, 120);
  const unsigned seed = GENERATE(range(1U, 6U));
  CAPTURE(numContacts, seed);
  constexpr Real kTolerance = 1e-9;  // m/s
  constexpr UInt32 kMaxSweeps = 100000;
  SIsland<Real> island = MakeRandomIsland(numContacts, seed);
  CContactIsland<Real> solver(island.Bodies, island.Contacts);
  CHECK(solver.Solve(kTolerance, kMaxSweeps) < kMaxSweeps);
  CHECK(solver.GetChange() <= kTolerance);
  const Real accuracy = 1e3 * kTolerance;
  for (const SIslandContact<Real>& contact : island.Contacts) {
    CheckContact(island, contact, accuracy);
  }
  for (size_t i = 0; i + 1 < island.Bodies.size(); ++i) {
    CheckDrive(island.Bodies[i], accuracy);
    CheckTorque(island.Bodies[i], 20.0 * accuracy);
  }
  // what is immovable has not moved
  for (const Real speed : island.Bodies.back().Velocity.Now) {
    CHECK(speed == 0.0);
  }
}

TEST_CASE("contact island: a grip, the motor of its turret and both bodies agree",
          "[unit][planar][grip]") {
  const Real mass = GENERATE(0.01, 0.3, 5.0, 100.0);  // kg
  // N m: friction only, less than the load needs, as much as any
  const Real torque = GENERATE(0.0, 1e-4, 0.05, 150.0);
  CheckTow<double>(mass, torque, true);
  CheckTow<float>(mass, torque, true);
  CheckTow<double>(mass, torque, false);
  CheckTow<float>(mass, torque, false);
}

TEST_CASE("contact island: robots that hold each other agree, whatever their turrets want",
          "[unit][planar][grip]") {
  constexpr float kTolerance = 1.7e-4F;  // m/s, that of the crowd solver
  constexpr int kNum = 200;
  UInt32 sweeps = 0;
  int converged = 0;
  for (unsigned seed = 1; seed <= kNum; ++seed) {
    CAPTURE(seed);
    SIsland<float> island = MakeEmbrace(seed);
    CContactIsland<float> solver(island.Bodies, island.Contacts, island.Grips);
    sweeps += solver.Solve(kTolerance, 150);
    if (solver.GetChange() > kTolerance) {
      continue;
    }
    ++converged;
    for (const SIslandBody<float>& body : island.Bodies) {
      CheckDrive(body, 10 * kTolerance);
    }
    for (const SIslandGrip<float>& grip : island.Grips) {
      CheckGrip(island, grip, 10 * kTolerance);
    }
  }
  // 199 in 14 sweeps on average; 118 in 115, if the drives and the motors that turn against them
  // are swept one after the other
  CHECK(converged >= 198);
  CHECK(sweeps <= 20 * kNum);
}

}  // namespace argos::contact_island_test
