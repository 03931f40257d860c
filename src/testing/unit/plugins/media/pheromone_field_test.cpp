// Compares the field of a substance with closed forms: decay, moments,
// conservation, modes, symmetry.

#include <argos3/core/utility/math/random_stream.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/media/pheromone_field.h>
#include <argos3/testing/support/no_allocation.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace argos::pheromone_field_test {

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

using TGrid = CPheromoneField::SGrid;

CThreadPool& NoThreads() {
  static CThreadPool pool(0, CreateSchedule("balance_quantity"));
  return pool;
}

// cells of 0.1 m x 0.1 m, starting at the origin
TGrid Cells(size_t numX, size_t numY, Real side = 0.1) {
  TGrid grid;
  grid.CellX = grid.CellY = side;
  grid.NumX = numX;
  grid.NumY = numY;
  return grid;
}

Real CenterX(const TGrid& grid, size_t i) {
  return grid.MinX + (static_cast<Real>(i) + 0.5) * grid.CellX;
}

Real CenterY(const TGrid& grid, size_t j) {
  return grid.MinY + (static_cast<Real>(j) + 0.5) * grid.CellY;
}

// mean and variance of the distribution of the substance
struct SMoments {
  Real Total = 0.0;
  Real MeanX = 0.0, MeanY = 0.0;  // m
  Real VarX = 0.0, VarY = 0.0;  // m^2
  Real Least = HUGE_VAL, Greatest = -HUGE_VAL;  // 1/m^2
};

SMoments MomentsOf(const CPheromoneField& field) {
  const TGrid& grid = field.GetGrid();
  SMoments m;
  const auto forCells = [&](auto&& visit) {
    for (size_t j = 0; j < grid.NumY; ++j) {
      for (size_t i = 0; i < grid.NumX; ++i) {
        visit(CenterX(grid, i), CenterY(grid, j), field.GetCell(i, j));
      }
    }
  };
  forCells([&](Real x, Real y, Real c) {
    m.Total += c;
    m.MeanX += x * c;
    m.MeanY += y * c;
    m.Least = std::min(m.Least, c);
    m.Greatest = std::max(m.Greatest, c);
  });
  m.MeanX /= m.Total;
  m.MeanY /= m.Total;
  forCells([&](Real x, Real y, Real c) {
    m.VarX += (x - m.MeanX) * (x - m.MeanX) * c / m.Total;
    m.VarY += (y - m.MeanY) * (y - m.MeanY) * c / m.Total;
  });
  m.Total *= grid.CellX * grid.CellY;
  return m;
}

void Advance(CPheromoneField& field, int times, Real seconds = 0.1) {
  for (int i = 0; i < times; ++i) {
    field.Advance(NoThreads(), seconds);
  }
}

}  // namespace

TEST_CASE("pheromone field: evaporation is exactly exponential", "[media]") {
  const Real evaporation = GENERATE(0.0, 0.03, 1.0, 50.0);
  const Real diffusion = GENERATE(0.0, 0.01, 10.0);
  CPheromoneField field(Cells(30, 20), evaporation, diffusion);
  field.Deposit(1.23, 0.77, 5.0);
  field.Deposit(2.5, 1.1, 2.0);
  Advance(field, 60);
  // diffusion does not change the total; tolerance for 60 factors and some 10^5 roundings of sums
  CHECK_THAT(field.ComputeTotal(), WithinRel(7.0 * std::exp(-evaporation * 6.0), 1e-12));
}

TEST_CASE("pheromone field: the variance of a spot grows by 2 D t along each axis", "[media]") {
  // D dt / side^2 of 0.04, 0.4 (explicit, one and three steps) and 0.9, 2.5, 8 (implicit)
  const Real diffusion = GENERATE(0.004, 0.04, 0.09, 0.25, 0.8);
  const int ticks = diffusion < 0.2 ? 40 : 4;
  TGrid grid = Cells(301, 301);
  grid.CellY = 0.15;
  CPheromoneField field(grid, 0.0, diffusion);
  // between centres of cells: the mean of the spot is at the deposit
  field.Deposit(15.03, 22.6, 3.0);
  const SMoments before = MomentsOf(field);
  CHECK_THAT(before.MeanX, WithinAbs(15.03, 1e-13));
  CHECK_THAT(before.MeanY, WithinAbs(22.6, 1e-13));
  Advance(field, ticks);
  const SMoments after = MomentsOf(field);
  const Real growth = 2.0 * diffusion * 0.1 * ticks;
  CHECK_THAT(after.VarX - before.VarX, WithinRel(growth, 1e-9));
  CHECK_THAT(after.VarY - before.VarY, WithinRel(growth, 1e-9));
  CHECK_THAT(after.MeanX, WithinAbs(15.03, 1e-10));
  CHECK_THAT(after.MeanY, WithinAbs(22.6, 1e-10));
  CHECK_THAT(after.Total, WithinRel(3.0, 1e-12));
}

TEST_CASE("pheromone field: a spot becomes a Gaussian", "[media]") {
  // D dt / side^2 = 0.1, and 500 of these: a standard deviation of 10 cells
  CPheromoneField field(Cells(201, 201), 0.0, 0.01);
  field.Deposit(10.05, 10.05, 1.0);
  Advance(field, 500);
  const Real variance = 2.0 * 0.01 * 50.0;
  for (const Real distance : {0.0, 0.5, 1.0, 2.0}) {
    const Real expected = std::exp(-0.5 * distance * distance / variance) / (2.0 * M_PI * variance);
    // Readings are equal in all directions, not only along the axes. The scheme errs in the fourth
    // moment by about (side / deviation)^2 / 4, and interpolation between centres errs by as much.
    for (int k = 0; k < 16; ++k) {
      const Real angle = M_PI * k / 8.0;
      CHECK_THAT(field.GetConcentration(10.05 + distance * std::cos(angle),
                                        10.05 + distance * std::sin(angle)),
                 WithinRel(expected, 0.01));
    }
  }
}

TEST_CASE("pheromone field: diffusion conserves the total and ends in an even field", "[media]") {
  const Real diffusion = GENERATE(0.02, 0.1, 1.0, 1e3, 1e9);
  const size_t numX = GENERATE(1, 2, 23);
  const size_t numY = GENERATE(1, 17);
  CAPTURE(diffusion, numX, numY);
  CPheromoneField field(Cells(numX, numY), 0.0, diffusion);
  CRandomStream random(1, "test", "pheromone", "places");
  const Real width = 0.1 * static_cast<Real>(numX);
  const Real depth = 0.1 * static_cast<Real>(numY);
  // deposits in corners and at borders as well
  field.Deposit(0.0, 0.0, 1.0);
  field.Deposit(width, depth, 1.0);
  for (int i = 0; i < 20; ++i) {
    field.Deposit(random.Uniform(0.0, width), random.Uniform(0.0, depth), 0.5);
  }
  CHECK_THAT(field.ComputeTotal(), WithinRel(12.0, 1e-13));
  Real greatest = MomentsOf(field).Greatest;
  for (int i = 0; i < 50; ++i) {
    field.Advance(NoThreads(), 0.1);
    const SMoments now = MomentsOf(field);
    REQUIRE(now.Least >= 0.0);
    REQUIRE(now.Greatest <= greatest * (1.0 + 1e-12));
    greatest = now.Greatest;
  }
  CHECK_THAT(field.ComputeTotal(), WithinRel(12.0, 1e-11));
  Advance(field, 4000);
  const SMoments end = MomentsOf(field);
  const Real even = 12.0 / (width * depth);
  // the slowest mode has decayed by exp(-D (PI / 2.3 m)^2 405 s) <= 3e-7
  CHECK_THAT(end.Least, WithinRel(even, 1e-5));
  CHECK_THAT(end.Greatest, WithinRel(even, 1e-5));
}

TEST_CASE("pheromone field: modes of the closed rectangle decay at the discrete rate", "[media]") {
  // cos(PI k (i + 1/2) / N) is a mode of the difference equation: a step multiplies it by
  // 1 - 4 r sin^2(PI k / 2 N), or by 1 / (1 + 4 r sin^2(...)) if it is implicit
  const Real diffusion = GENERATE(0.02, 0.08, 2.0);
  const bool alongX = GENERATE(true, false);
  const int k = GENERATE(1, 3);
  constexpr size_t kNum = 24;
  const TGrid grid = Cells(kNum, kNum);
  CPheromoneField field(grid, 0.0, diffusion);
  const auto mode = [&](size_t i, size_t j) {
    return 2.0 + std::cos(M_PI * k * (static_cast<Real>(alongX ? i : j) + 0.5) / kNum);
  };
  for (size_t j = 0; j < kNum; ++j) {
    for (size_t i = 0; i < kNum; ++i) {
      field.Deposit(CenterX(grid, i), CenterY(grid, j), mode(i, j) * 0.01);
    }
  }
  constexpr int kTicks = 30;
  Advance(field, kTicks);
  const Real r = diffusion * 0.1 / 0.01;
  const Real sine = std::sin(M_PI * k / (2.0 * kNum));
  const int numSteps = static_cast<int>(std::ceil(2.0 * r / 0.25));
  const Real factor = numSteps <= 4 ? std::pow(1.0 - 4.0 * (r / numSteps) * sine * sine, numSteps)
                                    : 1.0 / (1.0 + 4.0 * r * sine * sine);
  const Real left = std::pow(factor, kTicks);
  for (size_t i = 0; i < kNum; ++i) {
    const size_t other = (7 * i) % kNum;
    const Real expected = 2.0 + (mode(alongX ? i : other, alongX ? other : i) - 2.0) * left;
    CHECK_THAT(field.GetCell(alongX ? i : other, alongX ? other : i), WithinAbs(expected, 1e-12));
  }
  // the decay is close to that of the differential equation
  const Real exact = std::exp(-diffusion * std::pow(M_PI * k / 2.4, 2.0) * 0.1 * kTicks);
  CHECK_THAT(left, WithinAbs(exact, diffusion < 1.0 ? 0.01 : 0.05));
}

TEST_CASE("pheromone field: diffusion is symmetric in all directions", "[media]") {
  // Explicit steps are symmetric bit by bit; implicit ones eliminate from one side to the other,
  // with twice 41 roundings in each of twice 25 sweeps.
  const Real diffusion = GENERATE(0.01, 0.05, 0.1, 0.5);
  const Real tolerance = diffusion < 0.1 ? 0.0 : 1e-12;
  constexpr size_t kNum = 41;
  const TGrid grid = Cells(kNum, kNum);
  CPheromoneField field(grid, 0.0, diffusion);
  field.SetCell(20, 20, 100.0);
  Advance(field, 25);
  for (size_t j = 0; j < kNum; ++j) {
    for (size_t i = 0; i < kNum; ++i) {
      const Real here = field.GetCell(i, j);
      CHECK_THAT(field.GetCell(kNum - 1 - i, j), WithinAbs(here, tolerance * here));
      CHECK_THAT(field.GetCell(i, kNum - 1 - j), WithinAbs(here, tolerance * here));
      CHECK_THAT(field.GetCell(j, i), WithinAbs(here, tolerance * here));
    }
  }
}

TEST_CASE("pheromone field: readings are bilinear, and 0 outside", "[media]") {
  const TGrid grid = Cells(4, 3);
  CPheromoneField field(grid, 0.0, 0.0);
  field.Deposit(CenterX(grid, 1), CenterY(grid, 1), 0.04);
  // 0.04 in a cell of 0.01 m^2
  CHECK_THAT(field.GetCell(1, 1), WithinAbs(4.0, 1e-14));
  CHECK_THAT(field.GetConcentration(0.15, 0.15), WithinAbs(4.0, 1e-13));
  CHECK_THAT(field.GetConcentration(0.2, 0.15), WithinAbs(2.0, 1e-13));
  CHECK_THAT(field.GetConcentration(0.2, 0.1), WithinAbs(1.0, 1e-13));
  CHECK_THAT(field.GetConcentration(0.225, 0.15), WithinAbs(1.0, 1e-13));
  CHECK_THAT(field.GetConcentration(0.25, 0.15), WithinAbs(0.0, 1e-13));
  // between the outermost centres and the border the reading is that of the nearest centre
  field.Deposit(0.0, 0.0, 0.02);
  CHECK_THAT(field.GetCell(0, 0), WithinAbs(2.0, 1e-14));
  CHECK_THAT(field.GetConcentration(0.0, 0.0), WithinAbs(2.0, 1e-14));
  CHECK_THAT(field.GetConcentration(0.04, 0.03), WithinAbs(2.0, 1e-14));
  // on the far border, the outermost centres are the last ones
  field.Deposit(0.4, 0.3, 0.03);
  CHECK_THAT(field.GetCell(3, 2), WithinAbs(3.0, 1e-14));
  CHECK_THAT(field.GetConcentration(0.4, 0.3), WithinAbs(3.0, 1e-14));
  CHECK_THAT(field.GetConcentration(0.38, 0.26), WithinAbs(3.0, 1e-13));
  const Real total = field.ComputeTotal();
  for (const Real outside : {-1e-9, 0.4001, std::nan(""), HUGE_VAL}) {
    CHECK(field.GetConcentration(outside, 0.1) == 0.0);
    field.Deposit(outside, 0.1, 1.0);
  }
  CHECK(field.GetConcentration(0.1, 0.3001) == 0.0);
  CHECK(field.ComputeTotal() == total);
  field.Clear();
  CHECK(field.ComputeTotal() == 0.0);
}

TEST_CASE("pheromone field: a deposit is distributed bilinearly to the nearest cells", "[media]") {
  const TGrid grid = Cells(4, 4);
  CPheromoneField field(grid, 0.0, 0.0);
  // a quarter of the way from the centre of cell (1,1) to that of (2,1), and half up
  field.Deposit(0.175, 0.2, 0.08);
  CHECK_THAT(field.GetCell(1, 1), WithinAbs(3.0, 1e-13));
  CHECK_THAT(field.GetCell(2, 1), WithinAbs(1.0, 1e-13));
  CHECK_THAT(field.GetCell(1, 2), WithinAbs(3.0, 1e-13));
  CHECK_THAT(field.GetCell(2, 2), WithinAbs(1.0, 1e-13));
}

TEST_CASE("pheromone field: no cell exceeds the maximum", "[media]") {
  CPheromoneField field(Cells(10, 10), 0.5, 0.01, 7.0);
  for (int tick = 0; tick < 50; ++tick) {
    field.Deposit(0.55, 0.55, 10.0);
    CHECK_THAT(field.GetCell(5, 5), WithinRel(7.0, 1e-13));
    field.Advance(NoThreads(), 0.1);
    REQUIRE(MomentsOf(field).Greatest < 7.0);
  }
}

TEST_CASE("pheromone field: cells are set to what they may contain", "[media]") {
  CPheromoneField field(Cells(4, 3), 0.0, 0.0, 7.0);
  field.SetCell(3, 2, 7.0);
  field.SetCell(0, 0, 0.0);
  CHECK(field.GetCell(3, 2) == 7.0);
  CHECK_THAT(field.ComputeTotal(), WithinRel(0.07, 1e-12));
  for (const auto& [i, j] : {std::pair<size_t, size_t>(4, 0), std::pair<size_t, size_t>(0, 3)}) {
    CHECK_THROWS_WITH(field.SetCell(i, j, 1.0), Catch::Contains("among 4 x 3"));
  }
  for (const Real bad : {7.001, -1e-9, HUGE_VAL, std::nan("")}) {
    CHECK_THROWS_WITH(field.SetCell(1, 1, bad), Catch::Contains("must be in [0,7]"));
  }
  CHECK_THAT(field.ComputeTotal(), WithinRel(0.07, 1e-12));
}

TEST_CASE("pheromone field: a field that is empty again spreads nothing", "[media]") {
  CPheromoneField field(Cells(5, 5), 0.0, 0.01);
  field.SetCell(2, 2, 0.0);
  Advance(field, 3);
  CHECK(field.ComputeTotal() == 0.0);
  field.SetCell(2, 2, 1.0);
  // what is set after that does not count as nothing
  field.SetCell(0, 0, 0.0);
  Advance(field, 3);
  CHECK(field.GetCell(1, 2) > 0.0);
  CHECK_THAT(field.ComputeTotal(), WithinRel(0.01, 1e-12));
}

TEST_CASE("pheromone field: evaporation below the smallest number gives 0, and new deposits stay",
          "[media]") {
  CPheromoneField field(Cells(30, 20), 400.0, GENERATE(0.0, 0.01, 10.0));
  field.Advance(NoThreads(), 0.1);
  CHECK(field.ComputeTotal() == 0.0);
  field.Deposit(1.5, 1.0, 1.0);
  // exp(-400) is still a normal number
  Advance(field, 10);
  CHECK_THAT(std::log(field.ComputeTotal()), WithinAbs(-400.0, 1e-9));
  Advance(field, 10);
  CHECK(field.ComputeTotal() == 0.0);
  field.Deposit(1.5, 1.0, 2.0);
  CHECK_THAT(field.ComputeTotal(), WithinRel(2.0, 1e-12));
  field.Advance(NoThreads(), 0.1);
  CHECK_THAT(field.ComputeTotal(), WithinRel(2.0 * std::exp(-40.0), 1e-12));
}

TEST_CASE("pheromone field: results are equal bit by bit for any number of threads",
          "[media][threads]") {
  const Real diffusion = GENERATE(0.01, 0.1, 3.0);
  const UInt32 threads = GENERATE(1U, 4U);
  const std::string method = GENERATE("balance_quantity", "balance_length");
  CThreadPool pool(threads, CreateSchedule(method));
  const TGrid grid = Cells(203, 157);
  CPheromoneField a(grid, 0.1, diffusion);
  CPheromoneField b(grid, 0.1, diffusion);
  CRandomStream random(2, "test", "pheromone", "places");
  bool same = true;
  for (int tick = 0; tick < 30; ++tick) {
    const Real x = random.Uniform(0.0, 20.0);
    const Real y = random.Uniform(0.0, 15.0);
    a.Deposit(x, y, 1.0);
    b.Deposit(x, y, 1.0);
    a.Advance(NoThreads(), 0.1);
    b.Advance(pool, 0.1);
    for (size_t j = 0; j < grid.NumY; ++j) {
      for (size_t i = 0; i < grid.NumX; ++i) {
        same = same && a.GetCell(i, j) == b.GetCell(i, j);
      }
    }
  }
  CHECK(same);
}

TEST_CASE("pheromone field: a step in steady state allocates nothing", "[media][allocation]") {
  const Real diffusion = GENERATE(0.0, 0.01, 10.0);
  CPheromoneField field(Cells(100, 100), 100.0, diffusion);
  field.Advance(NoThreads(), 0.1);
  CheckAllocatesNothing([&] {
    for (int i = 0; i < 20; ++i) {
      field.Deposit(3.0, 3.0, 1.0);
      field.Advance(NoThreads(), 0.1);
    }
  });
}

TEST_CASE("pheromone field: with joined borders nothing depends on where they are",
          "[media][pheromone][torus]") {
  // a few explicit steps, and what takes an implicit one with closed borders
  const Real diffusion = GENERATE(0.002, 0.3);
  const bool joinsY = GENERATE(true, false);
  CAPTURE(diffusion, joinsY);
  TGrid grid = Cells(12, 9);
  grid.JoinsX = true;
  grid.JoinsY = joinsY;
  CPheromoneField one(grid, 0.0, diffusion);
  CPheromoneField moved(grid, 0.0, diffusion);
  const Real wayX = 0.5;
  const Real wayY = joinsY ? -0.4 : 0.0;
  CRandomStream random(1, "test", "pheromone", "joined");
  for (int tick = 0; tick < 30; ++tick) {
    const Real x = random.Uniform(0.0, 1.2);
    const Real y = random.Uniform(0.0, 0.9);
    one.Deposit(x, y, 1.0);
    moved.Deposit(x + wayX, y + wayY, 1.0);
    one.Advance(NoThreads(), 0.1);
    moved.Advance(NoThreads(), 0.1);
    for (int query = 0; query < 10; ++query) {
      const Real u = random.Uniform(0.0, 1.2);
      const Real v = random.Uniform(0.0, 0.9);
      REQUIRE_THAT(moved.GetConcentration(u + wayX, v + wayY),
                   WithinAbs(one.GetConcentration(u, v), 1e-9));
    }
  }
  CHECK_THAT(one.ComputeTotal(), WithinRel(30.0, 1e-12));
}

}  // namespace argos::pheromone_field_test
