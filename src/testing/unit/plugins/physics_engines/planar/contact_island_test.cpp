// Compares the impulses that are found with the laws that they have to obey.

#include <argos3/plugins/simulator/physics_engines/planar/contact_island.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace argos::contact_island_test {

namespace {

template <typename NUMBER>
struct SIsland {
  std::vector<SIslandBody<NUMBER>> Bodies;
  std::vector<SIslandContact<NUMBER>> Contacts;
};

// Two robots drive and turn against a cylinder of 0.2 kg from two sides, as in the benchmark's
// scene "shove": friction drags the cylinder along, and the robots apart.
template <typename NUMBER>
SIsland<NUMBER> MakeRubbedCylinder() {
  SIsland<NUMBER> island;
  const auto addBody = [&](NUMBER x, NUMBER y, NUMBER turn, NUMBER mass, NUMBER inertia,
                           NUMBER most, NUMBER angularMost) -> SIslandBody<NUMBER>& {
    SIslandBody<NUMBER>& body = island.Bodies.emplace_back();
    body.Velocity.Set({x, y, turn});
    body.Most = most;
    body.AngularMost = angularMost;
    body.Mass = mass;
    body.Inertia = inertia;
    body.InverseMass = mass > 0 ? 1 / mass : 0;
    body.InverseInertia = inertia > 0 ? 1 / inertia : 0;
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
  const NUMBER approach = -(x * contact.NX + y * contact.NY) - contact.Approach;
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

}  // namespace

TEST_CASE("contact island: the forces are found on an object that two robots rub",
          "[unit][planar]") {
  CheckRubbedCylinder<double>();
  CheckRubbedCylinder<float>();
}

}  // namespace argos::contact_island_test
