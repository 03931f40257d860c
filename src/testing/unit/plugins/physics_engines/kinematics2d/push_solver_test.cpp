// Compares motions of bodies pushed against friction with statics computed by hand.

#include <argos3/plugins/simulator/physics_engines/kinematics2d/push_solver.h>

#include <catch2/catch.hpp>

namespace argos::push_solver_test {

using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kNeed = 0.01;  // m
// m; the solver stops when a sweep changes 1e-9 of the need
constexpr Real kPrecision = 1e-6 * kNeed;
// squared radius of gyration of a square of 0.2 m: side^2 / 6, m^2
constexpr Real kSquaredGyration = 0.2 * 0.2 / 6.0;

}  // namespace

TEST_CASE("push solver: a body moves as wanted if the push exceeds friction, else stays",
          "[unit][kinematics2d]") {
  const Real cap = GENERATE(1.48, 1.5, 15.0);
  CAPTURE(cap);
  CPushSolver solver;
  const UInt32 body = solver.AddBody({}, 1.49, 1.49, kSquaredGyration);
  solver.AddContact({CPushSolver::kNone, body, 1.0, 0.0, 0.0, 0.0, kNeed, cap, 0.0});
  solver.Solve();
  CHECK_THAT(solver.GetTwist(body).X, WithinAbs(cap > 1.49 ? kNeed : 0.0, kPrecision));
  CHECK(solver.GetTwist(body).Y == 0.0);
  CHECK(solver.GetTwist(body).Turn == 0.0);
}

TEST_CASE("push solver: forces of several pushers add up, also through other bodies",
          "[unit][kinematics2d]") {
  const Real friction = GENERATE(25.0, 35.0);
  CAPTURE(friction);
  CPushSolver solver;
  const UInt32 body = solver.AddBody({}, friction, 10.0, kSquaredGyration);
  for (const Real lever : {-0.05, 0.05}) {
    solver.AddContact({CPushSolver::kNone, body, 1.0, 0.0, 0.0, lever, kNeed, 15.0, 0.0});
  }
  solver.Solve();
  CHECK_THAT(solver.GetTwist(body).X, WithinAbs(friction < 30.0 ? kNeed : 0.0, kPrecision));

  // a row of three bodies: the push on the first must overcome the friction of all
  CPushSolver row;
  UInt32 bodies[3];
  for (UInt32& each : bodies) {
    each = row.AddBody({}, friction / 3.0, 10.0, kSquaredGyration);
  }
  row.AddContact({CPushSolver::kNone, bodies[0], 1.0, 0.0, 0.0, 0.0, kNeed, 30.0, 0.0});
  row.AddContact({bodies[0], bodies[1], 1.0, 0.0, 0.0, 0.0, 0.0, CPushSolver::kUnlimited, 0.0});
  row.AddContact({bodies[1], bodies[2], 1.0, 0.0, 0.0, 0.0, 0.0, CPushSolver::kUnlimited, 0.0});
  row.Solve();
  for (const UInt32 each : bodies) {
    CHECK_THAT(row.GetTwist(each).X, WithinAbs(friction < 30.0 ? kNeed : 0.0, 1e-2 * kNeed));
  }
}

TEST_CASE("push solver: two opposite pushers hold a body in place", "[unit][kinematics2d]") {
  CPushSolver solver;
  const UInt32 body = solver.AddBody({}, 1.49, 1.49, kSquaredGyration);
  solver.AddContact({CPushSolver::kNone, body, 1.0, 0.0, 0.0, 0.0, kNeed, 15.0, 0.0});
  solver.AddContact({CPushSolver::kNone, body, -1.0, 0.0, 0.0, 0.0, kNeed, 15.0, 0.0});
  solver.Solve();
  CHECK_THAT(solver.GetTwist(body).X, WithinAbs(0.0, kPrecision));
}

TEST_CASE("push solver: an off-centre push turns a body if it exceeds the torque limit",
          "[unit][kinematics2d]") {
  constexpr Real kLever = 0.08;  // m
  constexpr Real kForce = 1.49;  // N
  // sliding friction transmits at least kForce at the lever
  const Real torque = GENERATE(0.5 * kForce * kLever, 2.0 * kForce * kLever);
  CAPTURE(torque);
  CPushSolver solver;
  const UInt32 body = solver.AddBody({}, kForce, torque, kSquaredGyration);
  solver.AddContact({CPushSolver::kNone, body, 1.0, 0.0, 0.0, -kLever, kNeed, 15.0, 0.0});
  solver.Solve();
  const STwist& twist = solver.GetTwist(body);
  // the pushed point moves as far as wanted
  CHECK_THAT(twist.X - kLever * twist.Turn, WithinAbs(kNeed, kPrecision));
  if (torque > kForce * kLever) {
    CHECK_THAT(twist.Turn, WithinAbs(0.0, kPrecision / kLever));
  } else {
    // the friction torque of the body balances a push of torque / lever, below its friction force
    CHECK_THAT(twist.X, WithinAbs(0.0, 0.01 * kNeed));
    CHECK_THAT(twist.Turn, WithinAbs(-kNeed / kLever, 0.01 * kNeed / kLever));
  }
}

TEST_CASE("push solver: a body whose friction has no torque turns about its centre",
          "[unit][kinematics2d]") {
  constexpr Real kLever = 0.08;  // m
  CPushSolver solver;
  const UInt32 body = solver.AddBody({}, 1.49, 0.0, kSquaredGyration);
  solver.AddContact({CPushSolver::kNone, body, 1.0, 0.0, 0.0, -kLever, kNeed, 15.0, 0.0});
  solver.Solve();
  CHECK_THAT(solver.GetTwist(body).X, WithinAbs(0.0, 0.01 * kNeed));
  CHECK_THAT(solver.GetTwist(body).Turn, WithinAbs(-kNeed / kLever, 0.01 * kNeed / kLever));
}

TEST_CASE("push solver: a pushed body does not penetrate an immovable one",
          "[unit][kinematics2d]") {
  CPushSolver solver;
  const UInt32 body = solver.AddBody({}, 1.49, 1.49, kSquaredGyration);
  solver.AddContact({CPushSolver::kNone, body, 1.0, 0.0, 0.0, 0.0, kNeed, 15.0, 0.0});
  // a wall 3 mm ahead
  solver.AddContact(
      {CPushSolver::kNone, body, -1.0, 0.0, 0.0, 0.0, -0.003, CPushSolver::kUnlimited, -0.003});
  solver.Solve();
  CHECK_THAT(solver.GetTwist(body).X, WithinAbs(0.003, kPrecision));
}

}  // namespace argos::push_solver_test
