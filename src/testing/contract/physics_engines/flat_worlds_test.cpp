// Runs one experiment in each engine: on a flat floor a free robot takes the same path.

#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/support/closed_form/differential_drive.h>

#include <argos3/core/utility/math/random_stream.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

namespace argos::flat_worlds_test {

using testing::IntegrateDifferentialDrive;
using testing::SPose;

namespace {

constexpr Real kTick = 0.1;  // s
constexpr int kTicks = 600;
constexpr Real kFootBotAxis = 0.14;  // m, between the wheels
const SPose kStart{1.5, -0.8, 0.6};

struct SSpeeds {
  Real Left, Right;  // cm/s
};

// orders to the wheels, tick by tick
struct SSchedule {
  std::string Name;
  std::vector<SSpeeds> Orders;  // one for each tick

  // path length of the faster wheel, m
  Real Length() const {
    Real sum = 0.0;
    for (const SSpeeds& order : Orders) {
      sum += 0.01 * std::max(std::abs(order.Left), std::abs(order.Right)) * kTick;
    }
    return sum;
  }
  // exact poses, after each tick
  std::vector<SPose> Integrate() const {
    std::vector<SPose> poses = {kStart};
    for (const SSpeeds& order : Orders) {
      poses.push_back(IntegrateDifferentialDrive(poses.back(), 0.01 * order.Left,
                                                 0.01 * order.Right, kFootBotAxis, kTick));
    }
    return poses;
  }
};

std::ostream& operator<<(std::ostream& stream, const SSchedule& schedule) {
  return stream << schedule.Name;
}

SSchedule Constant(const std::string& name, Real left, Real right) {
  return {name, std::vector<SSpeeds>(kTicks, {left, right})};
}

// different speeds every two seconds
SSchedule Changing() {
  SSchedule schedule{"changing", {}};
  CRandomStream random(1, "test", "flat worlds", "speeds");
  while (schedule.Orders.size() < kTicks) {
    const SSpeeds order{random.Uniform(-8.0, 14.0), random.Uniform(-8.0, 14.0)};
    schedule.Orders.insert(schedule.Orders.end(), 20, order);
  }
  return schedule;
}

// a square with rounded corners and a stop at each
SSchedule Square() {
  SSchedule schedule{"square", {}};
  const auto add = [&schedule](Real left, Real right, int ticks) {
    schedule.Orders.insert(schedule.Orders.end(), ticks, {left, right});
  };
  while (schedule.Orders.size() < kTicks) {
    add(10, 10, 40);
    add(0, 0, 10);
    add(-2, 8, 22);
    add(5, 5, 28);
  }
  schedule.Orders.resize(kTicks);
  return schedule;
}

// positions after each tick
std::vector<CVector3> Drive(const std::string& engine, const SSchedule& schedule) {
  CDriveWorld world(
      engine, DriverXml("foot-bot", "r", kStart.X, kStart.Y, kStart.Yaw * 180.0 / ARGOS_PI, 0, 0));
  std::vector<CVector3> places;
  CContractDriver& driver = world.Driver("r");
  for (const SSpeeds& order : schedule.Orders) {
    // orders of one tick act in the next
    driver.Left = order.Left;
    driver.Right = order.Right;
    world.Step();
    places.push_back(world.Position("r"));
  }
  world.Step();
  places.push_back(world.Position("r"));
  return places;
}

}  // namespace

TEST_CASE("flat worlds: a free robot takes the same path in every engine", "[contract][engine]") {
  const SSchedule schedule =
      GENERATE(Constant("straight", 10, 10), Constant("arc", 10, 8), Constant("tight arc", 2, 11),
               Constant("turn in place", -5, 5), Constant("reverse", -7, -7),
               Constant("reverse arc", -9, -6), Changing(), Square());
  CAPTURE(schedule);
  const std::vector<SPose> exact = schedule.Integrate();
  std::vector<std::vector<CVector3>> accurate;  // from engines without slip
  for (const SEngineType& engine : kEnginesWithWheels) {
    CAPTURE(engine);
    const std::vector<CVector3> places = Drive(engine.ToPromptXml(), schedule);
    REQUIRE(places.size() == exact.size());
    Real worst = 0.0;
    for (size_t i = 0; i < places.size(); ++i) {
      worst = std::max(worst, Distance(places[i], CVector3(exact[i].X, exact[i].Y, 0.0)));
    }
    INFO("farthest from the closed form, m: " << worst);
    // 1 mm; engines without slip lose up to a hundredth of it to rounding and inertia
    CHECK(worst <= 1e-3 + engine.Slip * schedule.Length());
    if (engine.Slip == 0.0) {
      accurate.push_back(places);
    }
  }
  REQUIRE(accurate.size() == 3);
  for (size_t i = 0; i < exact.size(); ++i) {
    for (size_t engine = 1; engine < accurate.size(); ++engine) {
      REQUIRE(Distance(accurate[engine][i], accurate[0][i]) <= 1e-3);
    }
  }
}

}  // namespace argos::flat_worlds_test
