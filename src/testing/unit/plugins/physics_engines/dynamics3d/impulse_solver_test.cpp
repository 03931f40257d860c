#include <argos3/plugins/simulator/physics_engines/dynamics3d/impulse_solver.h>

#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/weight_start.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace argos::impulse_solver_test {

using Catch::Matchers::WithinAbs;
using EKind = CImpulseSolver::EKind;

namespace {

constexpr Real kTolerance = 1e-12;  // m/s

// a cube of 1 kg and side 1 m at a velocity
CImpulseSolver::SBody Cube(const CVector3& velocity, Real mass = 1.0) {
  CImpulseSolver::SBody body;
  body.Velocity = velocity;
  body.InverseMass = 1.0 / mass;
  body.InverseInertia.XX = body.InverseInertia.YY = body.InverseInertia.ZZ = 6.0 / mass;
  return body;
}

// a contact that supports a body from below
CImpulseSolver::SBlock Below(UInt32 first, UInt32 second, const CVector3& arm,
                             const CVector3& other, Real friction) {
  CImpulseSolver::SBlock block;
  block.First = first;
  block.Second = second;
  block.Directions = {CVector3::Z, CVector3::X, CVector3::Y};
  block.FirstArm = arm;
  block.SecondArm = other;
  block.Friction = friction;
  // as good as rigid
  block.Softness = 1e-12;
  return block;
}

}  // namespace

TEST_CASE("friction of a contact: it sticks within its limit, else it is opposite to the sliding",
          "[dynamics3d]") {
  CRandomStream random(3, "test", "friction", "impulses");
  for (int i = 0; i < 1000; ++i) {
    // K = L L^T
    const Real a = random.Uniform(0.1, 3.0);
    const Real b = random.Uniform(-3.0, 3.0);
    const Real c = random.Uniform(0.1, 3.0);
    const Real kxx = a * a;
    const Real kxy = a * b;
    const Real kyy = b * b + c * c;
    const SPair2 wanted{random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0)};
    const Real limit = random.Uniform(0.0, 1.0);
    CAPTURE(i, kxx, kxy, kyy, limit);
    const SPair2 p = SolveFriction(kxx, kxy, kyy, wanted, limit);
    const Real size = std::hypot(p.X, p.Y);
    CHECK(size <= limit * (1.0 + 1e-12));
    const SPair2 sliding{kxx * p.X + kxy * p.Y - wanted.X, kxy * p.X + kyy * p.Y - wanted.Y};
    const Real speed = std::hypot(sliding.X, sliding.Y);
    if (size < 0.999999 * limit) {
      CHECK(speed < 1e-9);
    } else {
      CHECK_THAT(p.X * sliding.X + p.Y * sliding.Y, WithinAbs(-size * speed, 1e-8));
    }
  }
}

TEST_CASE("impulse solver: a cube that slides on four corners loses mu g h, in any direction",
          "[dynamics3d]") {
  const Real angle = GENERATE(0.0, 0.4, 0.785, 2.0);
  CAPTURE(angle);
  CImpulseSolver solver;
  solver.Clear();
  const Real fall = 0.0981;  // m/s, of gravity in a substep
  const CVector3 ahead(std::cos(angle), std::sin(angle), 0.0);
  solver.Bodies.push_back(Cube(ahead - CVector3(0, 0, fall)));
  for (const Real x : {-0.5, 0.5}) {
    for (const Real y : {-0.5, 0.5}) {
      // at the height of the centre of mass, where friction has no lever
      solver.Blocks.push_back(Below(1, 0, CVector3(x, y, 0.0), CVector3(), 0.3));
    }
  }
  solver.Prepare();
  solver.Solve(1000, kTolerance);
  const CVector3 change = solver.Bodies[1].Velocity - ahead * (1.0 - 0.3 * fall);
  CHECK(change.Length() < 1e-9);
  CHECK(solver.Bodies[1].Turn.Length() < 1e-9);
}

TEST_CASE("impulse solver: a tower of cubes keeps its momentum, and converges within 100 sweeps",
          "[dynamics3d]") {
  constexpr UInt32 kHeight = 5;
  CImpulseSolver solver;
  solver.Clear();
  for (UInt32 i = 1; i <= kHeight; ++i) {
    solver.Bodies.push_back(Cube(CVector3(0, 0, -0.1)));
    for (const Real x : {-0.5, 0.5}) {
      for (const Real y : {-0.5, 0.5}) {
        solver.Blocks.push_back(
            Below(i, i - 1, CVector3(x, y, -0.5), CVector3(x, y, i > 1 ? 0.5 : 0.0), 0.5));
      }
    }
  }
  solver.Prepare();
  CHECK(solver.Solve(400, 1e-6) < 100);
  Real sum = 0.0;
  for (UInt32 i = 1; i <= kHeight; ++i) {
    CAPTURE(i);
    CHECK(solver.Bodies[i].Velocity.Length() < 1e-4);
    // the four contacts below bear all that is above
    sum = 0.0;
    for (UInt32 j = 0; j < 4; ++j) {
      sum += solver.Blocks[4 * (i - 1) + j].Impulses[0];
    }
    CHECK_THAT(sum, WithinAbs(0.1 * (kHeight + 1 - i), 1e-4));
  }
  // starting from the solution, one sweep is enough
  for (UInt32 i = 1; i <= kHeight; ++i) {
    solver.Bodies[i] = Cube(CVector3(0, 0, -0.1));
  }
  solver.Prepare();
  CHECK(solver.Solve(400, 1e-5) <= 2);
}

TEST_CASE("weight start: contacts bear what is above them by the law of the lever, with no sweep",
          "[dynamics3d]") {
  // a cube of 2 kg, with its middle at x = 0.2, on another one and on the ground
  constexpr Real kFall = 0.1;  // m/s
  CImpulseSolver solver;
  solver.Clear();
  solver.Bodies.push_back(Cube(CVector3(0, 0, -kFall)));
  solver.Bodies.push_back(Cube(CVector3(0, 0, -kFall), 2.0));
  for (const Real y : {-0.5, 0.5}) {
    for (const Real x : {-0.5, 0.5}) {
      solver.Blocks.push_back(Below(1, 0, CVector3(x, y, -0.5), CVector3(), 0.5));
    }
    solver.Blocks.push_back(Below(2, 1, CVector3(-0.3, y, -0.5), CVector3(-0.1, y, 0.5), 0.5));
    solver.Blocks.push_back(Below(2, 0, CVector3(0.5, y, -0.5), CVector3(), 0.5));
  }
  // a wall, which bears nothing
  solver.Blocks.push_back(Below(2, 0, CVector3(0.5, 0, 0), CVector3(), 0.5));
  solver.Blocks.back().Directions = {-CVector3::X, CVector3::Y, CVector3::Z};
  for (CImpulseSolver::SBlock& block : solver.Blocks) {
    // as of contacts in a scene
    block.Softness = 0.0;
  }
  CWeightStart weights;
  weights.GetHeights() = {0.0, 0.5, 1.5};
  weights.Apply(solver, kFall);
  // of 0.2 N s, 5/8 press on the cube below, 0.1 m beside its middle
  const Real ofBoth = 0.5 * 0.2 * 5.0 / 8.0;
  const Real wanted[] = {0.25 * (0.1 + 2.0 * ofBoth) + ofBoth * 0.1,
                         0.25 * (0.1 + 2.0 * ofBoth) - ofBoth * 0.1, ofBoth, 0.5 * 0.2 * 3.0 / 8.0};
  for (size_t i = 0; i < 8; ++i) {
    CAPTURE(i);
    CHECK_THAT(solver.Blocks[i].Impulses[0], WithinAbs(wanted[i % 4], 1e-6));
  }
  CHECK(solver.Blocks[8].Impulses[0] == 0.0);
  solver.Prepare();
  CHECK(solver.Solve(400, 1e-6) == 1);
}

TEST_CASE(
    "impulse solver: a wheel drives its body with the torque of its motor, and no more than "
    "friction",
    "[dynamics3d]") {
  // one wheel of radius 0.1 m below the centre of mass, which bears a weight of 1 N s
  const Real limit = GENERATE(0.02, 1.0);
  const Real friction = GENERATE(0.1, 2.0);
  CAPTURE(limit, friction);
  CImpulseSolver solver;
  solver.Clear();
  CImpulseSolver::SBody body = Cube(CVector3(0, 0, -1));
  // it cannot turn
  body.InverseInertia = {};
  solver.Bodies.push_back(body);
  CImpulseSolver::SRotor rotor;
  rotor.Body = 1;
  rotor.Axis = CVector3::Y;
  rotor.InverseInertia = 1e4;
  rotor.Target = 10.0;
  rotor.Limit = limit;
  solver.Rotors.push_back(rotor);
  CImpulseSolver::SBlock block = Below(1, 0, CVector3(0, 0, -0.1), CVector3(), friction);
  block.Rotor = 0;
  block.RotorArm = CVector3(0, 0, -0.1);
  solver.Blocks.push_back(block);
  solver.Prepare();
  solver.Solve(1000, kTolerance);
  // a rolling body of 1 kg and a wheel of 1e-4 kg m^2, or 0.01 kg at the rim
  const Real rolling = std::min(1.0, limit / 0.1 / 1.01);
  const Real wanted = std::min(rolling, friction);
  CHECK_THAT(solver.Bodies[1].Velocity.GetX(), WithinAbs(wanted, 1e-9));
  CHECK_THAT(solver.Bodies[1].Velocity.GetZ(), WithinAbs(0.0, 1e-9));
}

}  // namespace argos::impulse_solver_test
