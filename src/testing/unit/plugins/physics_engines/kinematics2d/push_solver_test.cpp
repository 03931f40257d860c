// Compares motions of bodies pushed against friction with statics computed by hand.

#include <argos3/plugins/simulator/physics_engines/kinematics2d/push_solver.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace argos::push_solver_test {

using Catch::Matchers::WithinAbs;

namespace {

constexpr UInt32 kNone = CPushSolver::kNone;
constexpr Real kNeed = 0.01;  // m, planned step of robots
constexpr Real kDrive = 15.0;  // N
constexpr Real kPrecision = 1e-6 * kNeed;  // m
// squared radius of gyration of a square of 0.2 m: side^2 / 6, m^2
constexpr Real kSquaredGyration = 0.2 * 0.2 / 6.0;
constexpr Real kHeld = 1e6;  // N m; a torque of friction that nothing here overcomes
// what resists, over what pushes
constexpr Real kRatios[] = {0.5, 0.9, 0.99, 1.01, 1.1, 2.0, 1e6};

UInt32 AddRobot(CPushSolver& solver, Real x, Real y = 0.0) {
  return solver.AddBody({x, y, 0.0}, kDrive, CPushSolver::kUnlimited, 1.0);
}

UInt32 AddBox(CPushSolver& solver, Real force, Real torque = kHeld) {
  return solver.AddBody({}, force, torque, kSquaredGyration);
}

}  // namespace

TEST_CASE("push solver: robots side by side move what the sum of their forces overcomes",
          "[unit][kinematics2d]") {
  const Real ratio = GENERATE(from_range(std::begin(kRatios), std::end(kRatios)));
  const int robots = GENERATE(1, 2, 3, 10, 30);
  CAPTURE(ratio, robots);
  CPushSolver solver;
  const UInt32 box = AddBox(solver, ratio * robots * kDrive);
  for (int i = 0; i < robots; ++i) {
    const Real lever = 0.2 * (i - 0.5 * (robots - 1));
    solver.AddContact({AddRobot(solver, kNeed), box, {1.0, 0.0}, 0.0, lever, 0.0});
  }
  solver.Solve();
  CHECK_THAT(solver.GetTwist(box).X, WithinAbs(ratio < 1.0 ? kNeed : 0.0, kPrecision));
  CHECK_THAT(solver.GetTwist(box).Y, WithinAbs(0.0, kPrecision));
  CHECK_THAT(solver.GetTwist(box).Turn, WithinAbs(0.0, kPrecision));
}

TEST_CASE("push solver: a robot moves a row if its force overcomes the sum of frictions",
          "[unit][kinematics2d]") {
  const Real ratio = GENERATE(from_range(std::begin(kRatios), std::end(kRatios)));
  const int boxes = GENERATE(2, 5, 10, 20);
  const bool backwards = GENERATE(false, true);
  CAPTURE(ratio, boxes, backwards);
  CPushSolver solver;
  std::vector<UInt32> row;
  for (int i = 0; i < boxes; ++i) {
    row.push_back(AddBox(solver, ratio * kDrive / boxes, 1.49));
  }
  if (backwards) {
    std::reverse(row.begin(), row.end());
  }
  solver.AddContact({AddRobot(solver, kNeed), row[0], {1.0, 0.0}, 0.0, 0.0, 0.0});
  for (size_t i = 1; i < row.size(); ++i) {
    // both ends of a face
    solver.AddContact({row[i - 1], row[i], {1.0, 0.0}, 0.1, 0.1, 0.0});
    solver.AddContact({row[i - 1], row[i], {1.0, 0.0}, -0.1, -0.1, 0.0});
  }
  solver.Solve();
  for (const UInt32 box : row) {
    CHECK_THAT(solver.GetTwist(box).X, WithinAbs(ratio < 1.0 ? kNeed : 0.0, 1e-4 * kNeed));
    CHECK_THAT(solver.GetTwist(box).Turn, WithinAbs(0.0, 1e-4 * kNeed));
  }
}

TEST_CASE("push solver: rows of a block that touch sideways move as each would alone",
          "[unit][kinematics2d]") {
  constexpr int kRows = 20;
  constexpr int kBoxes = 20;
  CPushSolver solver;
  std::vector<std::vector<UInt32>> rows(kRows);
  const auto ratioOf = [](int row) { return kRatios[row % std::size(kRatios)]; };
  // both ends of a face
  const auto join = [&solver](UInt32 a, UInt32 b, Real x, Real y) {
    solver.AddContact({a, b, {x, y}, 0.1, 0.1, 0.0});
    solver.AddContact({a, b, {x, y}, -0.1, -0.1, 0.0});
  };
  for (int row = 0; row < kRows; ++row) {
    for (int i = 0; i < kBoxes; ++i) {
      rows[row].push_back(AddBox(solver, ratioOf(row) * kDrive / kBoxes, 1.49));
      if (i > 0) {
        join(rows[row][i - 1], rows[row][i], 1.0, 0.0);
      }
      if (row > 0) {
        join(rows[row - 1][i], rows[row][i], 0.0, 1.0);
      }
    }
    solver.AddContact({AddRobot(solver, kNeed), rows[row][0], {1.0, 0.0}, 0.0, 0.0, 0.0});
  }
  solver.Solve();
  for (int row = 0; row < kRows; ++row) {
    for (const UInt32 box : rows[row]) {
      CAPTURE(row, ratioOf(row), box);
      const STwist& twist = solver.GetTwist(box);
      CHECK_THAT(twist.X, WithinAbs(ratioOf(row) < 1.0 ? kNeed : 0.0, 1e-4 * kNeed));
      CHECK_THAT(twist.Y, WithinAbs(0.0, 1e-4 * kNeed));
      CHECK_THAT(twist.Turn, WithinAbs(0.0, 1e-4 * kNeed));
    }
  }
}

TEST_CASE("push solver: a couple turns a bar if its torque overcomes that of friction",
          "[unit][kinematics2d]") {
  constexpr Real kLever = 0.4;  // m
  const Real ratio = GENERATE(from_range(std::begin(kRatios), std::end(kRatios)));
  CAPTURE(ratio);
  CPushSolver solver;
  // of a bar of 1 m x 0.1 m
  const UInt32 bar = solver.AddBody({}, 1.49, ratio * 2.0 * kDrive * kLever, 1.01 / 12.0);
  for (const Real side : {-1.0, 1.0}) {
    const UInt32 robot = AddRobot(solver, 0.0, side * kNeed);
    solver.AddContact({robot, bar, {0.0, side}, 0.0, kLever, 0.0});
  }
  solver.Solve();
  CHECK_THAT(solver.GetTwist(bar).Turn,
             WithinAbs(ratio < 1.0 ? kNeed / kLever : 0.0, kPrecision / kLever));
  CHECK_THAT(solver.GetTwist(bar).X, WithinAbs(0.0, kPrecision));
  CHECK_THAT(solver.GetTwist(bar).Y, WithinAbs(0.0, kPrecision));
}

TEST_CASE("push solver: the force of a drive bounds the sum of its contacts",
          "[unit][kinematics2d]") {
  // between two discs, which it pushes apart at an angle to each side
  const Real cosine = std::cos(0.5);
  const Real sine = std::sin(0.5);
  const Real ratio = GENERATE(from_range(std::begin(kRatios), std::end(kRatios)));
  CAPTURE(ratio);
  CPushSolver solver;
  const UInt32 robot = AddRobot(solver, kNeed);
  UInt32 discs[2];
  for (int i = 0; i < 2; ++i) {
    discs[i] = AddBox(solver, ratio * 0.5 * kDrive / cosine);
    solver.AddContact({robot, discs[i], {cosine, i == 0 ? sine : -sine}, 0.0, 0.0, 0.0});
  }
  solver.Solve();
  const Real made = ratio < 1.0 ? kNeed : 0.0;
  CHECK_THAT(solver.GetTwist(robot).X, WithinAbs(made, kPrecision));
  for (const UInt32 disc : discs) {
    CHECK_THAT(solver.GetTwist(disc).X, WithinAbs(made * cosine * cosine, kPrecision));
    CHECK_THAT(std::abs(solver.GetTwist(disc).Y), WithinAbs(made * cosine * sine, kPrecision));
  }
}

TEST_CASE("push solver: more robots push fewer ones back", "[unit][kinematics2d]") {
  const int left = GENERATE(1, 2, 3);
  const int right = GENERATE(1, 2, 3);
  CAPTURE(left, right);
  CPushSolver solver;
  const UInt32 box = AddBox(solver, 1.49);
  std::vector<UInt32> opposing;
  for (int i = 0; i < left + right; ++i) {
    const bool isLeft = i < left;
    const Real side = isLeft ? 1.0 : -1.0;
    const Real y = isLeft ? 0.25 * (i - 0.5 * (left - 1)) : 0.25 * (i - left - 0.5 * (right - 1));
    const UInt32 robot = AddRobot(solver, side * kNeed);
    solver.AddContact({robot, box, {side, 0.0}, 0.0, -side * y, 0.0});
    if (!isLeft) {
      opposing.push_back(robot);
    }
  }
  solver.Solve();
  const Real moved = left == right ? 0.0 : (left > right ? kNeed : -kNeed);
  CHECK_THAT(solver.GetTwist(box).X, WithinAbs(moved, kPrecision));
  for (const UInt32 robot : opposing) {
    CHECK_THAT(solver.GetTwist(robot).X, WithinAbs(moved, kPrecision));
  }
}

TEST_CASE("push solver: an off-centre push turns a body if it exceeds the torque limit",
          "[unit][kinematics2d]") {
  constexpr Real kLever = 0.08;  // m
  constexpr Real kForce = 1.49;  // N
  // sliding friction transmits at least kForce at the lever
  const Real ratio = GENERATE(0.0, 0.5, 0.9, 0.99, 1.01, 1.1, 2.0, 1e6);
  CAPTURE(ratio);
  CPushSolver solver;
  const UInt32 body = AddBox(solver, kForce, ratio * kForce * kLever);
  solver.AddContact({AddRobot(solver, kNeed), body, {1.0, 0.0}, 0.0, -kLever, 0.0});
  solver.Solve();
  const STwist& twist = solver.GetTwist(body);
  // the pushed point moves as far as wanted
  CHECK_THAT(twist.X - kLever * twist.Turn, WithinAbs(kNeed, kPrecision));
  // the friction torque of the body balances a push of torque / lever, below its friction force
  const Real turn = ratio < 1.0 ? -kNeed / kLever : 0.0;
  CHECK_THAT(twist.Turn, WithinAbs(turn, 1e-4 * kNeed / kLever));
  CHECK_THAT(twist.X, WithinAbs(ratio < 1.0 ? 0.0 : kNeed, 1e-4 * kNeed));
}

TEST_CASE("push solver: a pushed body does not penetrate an immovable one",
          "[unit][kinematics2d]") {
  const int robots = GENERATE(1, 10);
  CAPTURE(robots);
  CPushSolver solver;
  const UInt32 body = AddBox(solver, 1.49, 1.49);
  for (int i = 0; i < robots; ++i) {
    const Real lever = 0.2 * (i - 0.5 * (robots - 1));
    solver.AddContact({AddRobot(solver, kNeed), body, {1.0, 0.0}, 0.0, lever, 0.0});
  }
  // a wall 3 mm ahead
  for (const Real lever : {-0.1, 0.1}) {
    solver.AddContact({kNone, body, {-1.0, 0.0}, 0.0, lever, -0.003});
  }
  solver.Solve();
  CHECK_THAT(solver.GetTwist(body).X, WithinAbs(0.003, kPrecision));
}

TEST_CASE("push solver: a body slides along a wall that is inclined", "[unit][kinematics2d]") {
  const Real ratio = GENERATE(from_range(std::begin(kRatios), std::end(kRatios)));
  CAPTURE(ratio);
  const Real cosine = std::sqrt(0.5);
  CPushSolver solver;
  // the push along the wall is what overcomes friction
  const UInt32 body = AddBox(solver, ratio * kDrive * cosine);
  solver.AddContact({AddRobot(solver, kNeed), body, {1.0, 0.0}, 0.0, 0.0, 0.0});
  solver.AddContact({kNone, body, {-cosine, cosine}, 0.0, 0.0, 0.0});
  solver.Solve();
  const Real made = ratio < 1.0 ? kNeed : 0.0;
  CHECK_THAT(solver.GetTwist(body).X, WithinAbs(made, kPrecision));
  CHECK_THAT(solver.GetTwist(body).Y, WithinAbs(made, kPrecision));
}

TEST_CASE("push solver: bodies of which a contact requires it separate, whatever their friction",
          "[unit][kinematics2d]") {
  const Real friction = GENERATE(0.0, 1.49, 1e6);
  CAPTURE(friction);
  CPushSolver solver;
  const UInt32 a = AddBox(solver, friction, friction);
  const UInt32 b = AddBox(solver, friction, friction);
  solver.AddContact({a, b, {1.0, 0.0}, 0.0, 0.0, 0.002});
  solver.Solve();
  CHECK_THAT(solver.GetTwist(b).X - solver.GetTwist(a).X, WithinAbs(0.002, kPrecision));
}

TEST_CASE("push solver: the result depends neither on the order nor on the axes",
          "[unit][kinematics2d][determinism]") {
  // two robots push a pile of discs in a hexagonal packing, at a side and at a corner
  constexpr int kRows = 5;
  constexpr Real kRadius = 0.1;  // m
  const auto solve = [&](Real angle, bool reversed) {
    struct SDisc {
      Real X, Y;
    };
    std::vector<SDisc> discs;
    for (int i = 0; i < kRows; ++i) {
      for (int j = 0; j <= i; ++j) {
        discs.push_back({std::sqrt(3.0) * kRadius * i, 2.0 * kRadius * (j - 0.5 * i)});
      }
    }
    const Real cosine = std::cos(angle);
    const Real sine = std::sin(angle);
    std::vector<size_t> order(discs.size());
    std::iota(order.begin(), order.end(), size_t(0));
    if (reversed) {
      std::reverse(order.begin(), order.end());
    }
    CPushSolver solver;
    std::vector<UInt32> numbers(discs.size());
    for (const size_t i : order) {
      numbers[i] = solver.AddBody({}, 1.0, 1.49, 0.5 * kRadius * kRadius);
    }
    for (const size_t i : order) {
      for (const size_t j : order) {
        const Real dx = (discs[j].X - discs[i].X) / (2.0 * kRadius);
        const Real dy = (discs[j].Y - discs[i].Y) / (2.0 * kRadius);
        if (i < j && std::abs(dx * dx + dy * dy - 1.0) < 1e-6) {
          const SPlanarVector normal = {cosine * dx - sine * dy, sine * dx + cosine * dy};
          solver.AddContact({numbers[i], numbers[j], normal, 0.0, 0.0, 0.0});
        }
      }
    }
    const UInt32 first = AddRobot(solver, kNeed * cosine, kNeed * sine);
    solver.AddContact({first, numbers[0], {cosine, sine}, 0.0, 0.0, 0.0});
    const UInt32 second = AddRobot(solver, kNeed * sine, -kNeed * cosine);
    solver.AddContact({second, numbers.back(), {sine, -cosine}, 0.0, 0.0, 0.0});
    solver.Solve();
    std::vector<STwist> twists;
    for (const UInt32 number : numbers) {
      const STwist& twist = solver.GetTwist(number);
      twists.push_back(
          {cosine * twist.X + sine * twist.Y, cosine * twist.Y - sine * twist.X, twist.Turn});
    }
    return twists;
  };
  const std::vector<STwist> expected = solve(0.0, false);
  const Real angle = GENERATE(0.0, 1.0, 3.0);
  const bool reversed = GENERATE(false, true);
  CAPTURE(angle, reversed);
  const std::vector<STwist> found = solve(angle, reversed);
  for (size_t i = 0; i < expected.size(); ++i) {
    CAPTURE(i);
    CHECK_THAT(found[i].X, WithinAbs(expected[i].X, 1e-3 * kNeed));
    CHECK_THAT(found[i].Y, WithinAbs(expected[i].Y, 1e-3 * kNeed));
  }
}

namespace {

// A robot pushes the first box of a block, askew; a wall is behind one of them.
std::vector<STwist> SolveBlock(CPushSolver& solver, Real step, int boxes) {
  constexpr int kColumns = 3;
  solver.Clear();
  std::vector<UInt32> block;
  for (int i = 0; i < boxes; ++i) {
    block.push_back(solver.AddBody({}, 3.0, 0.5, kSquaredGyration, static_cast<UInt32>(i)));
  }
  const UInt32 robot = solver.AddBody({step, 0.2 * step, 0.0}, kDrive, CPushSolver::kUnlimited, 1.0,
                                      static_cast<UInt32>(1000));
  solver.AddContact({robot, block[0], {1.0, 0.0}, 0.0, 0.04, 0.0});
  for (int i = kColumns; i < boxes; ++i) {
    solver.AddContact({block[i - kColumns], block[i], {1.0, 0.0}, 0.1, 0.1, 0.0});
    solver.AddContact({block[i - kColumns], block[i], {1.0, 0.0}, -0.1, -0.1, 0.0});
  }
  for (int i = 1; i < boxes; ++i) {
    if (i % kColumns != 0) {
      solver.AddContact({block[i - 1], block[i], {0.0, 1.0}, 0.1, -0.1, 0.0});
    }
  }
  solver.AddContact({kNone, block.back(), {-1.0, 0.0}, 0.0, 0.0, 0.0});
  solver.Solve();
  solver.Remember();
  std::vector<STwist> twists;
  for (const UInt32 box : block) {
    twists.push_back(solver.GetTwist(box));
  }
  return twists;
}

Real FindGreatestDifference(const std::vector<STwist>& a, const std::vector<STwist>& b) {
  Real greatest = 0.0;
  for (size_t i = 0; i < a.size(); ++i) {
    greatest = std::max({greatest, std::abs(a[i].X - b[i].X), std::abs(a[i].Y - b[i].Y),
                         std::abs(a[i].Turn - b[i].Turn) * std::sqrt(kSquaredGyration)});
  }
  return greatest;
}

}  // namespace

TEST_CASE("push solver: a solution that is remembered does not change the next one",
          "[unit][kinematics2d]") {
  // what the block has held, and what it gets next; 24 boxes hold the robot, 6 do not
  const Real before = GENERATE(0.01, 0.005, -0.01, 0.0);
  const int boxesBefore = GENERATE(24, 6, 23);
  const int boxes = GENERATE(24, 6);
  CAPTURE(before, boxesBefore, boxes);
  CPushSolver cold, solver;
  const std::vector<STwist> expected = SolveBlock(cold, kNeed, boxes);
  SolveBlock(solver, before, boxesBefore);
  CHECK(FindGreatestDifference(SolveBlock(solver, kNeed, boxes), expected) <= 1e-4 * kNeed);
  // and again, from itself
  CHECK(FindGreatestDifference(SolveBlock(solver, kNeed, boxes), expected) <= 1e-4 * kNeed);
}

}  // namespace argos::push_solver_test
