// CMetrics and CRobotRecords by themselves; what robots do with them is in determinism/.

#include <argos3/core/simulator/space/metrics.h>
#include <argos3/core/simulator/space/robot_records.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace space_metrics_test {

using namespace argos;
using Catch::Contains;

namespace {

constexpr Real kNaN = std::numeric_limits<Real>::quiet_NaN();
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

void CheckNumbers(const CMetrics::SMetric& metric, UInt64 count, const std::vector<Real>& numbers) {
  CHECK(metric.Count == count);
  CHECK(std::vector<Real>{metric.Value, metric.Sum, metric.Min, metric.Max, metric.Last} ==
        numbers);
}

}  // namespace

TEST_CASE("metrics: records of a tick are reduced, and a single one is the value",
          "[core][metrics]") {
  CMetrics metrics;
  metrics.Record("food", 0.1);
  CheckNumbers(*metrics.Find("food"), 1, {0.1, 0.1, 0.1, 0.1, 0.1});
  metrics.Record("food", 6.0);
  metrics.Record("food", -3.1);
  CheckNumbers(*metrics.Find("food"), 3,
               {(0.1 + 6.0 + -3.1) / 3.0, 0.1 + 6.0 + -3.1, -3.1, 6.0, -3.1});
}

TEST_CASE("metrics: Set() replaces the records of the tick, and Record() adds to it",
          "[core][metrics]") {
  CMetrics metrics;
  metrics.Record("food", 1.0);
  metrics.Record("food", 2.0);
  metrics.Set("food", 5.0);
  CheckNumbers(*metrics.Find("food"), 1, {5.0, 5.0, 5.0, 5.0, 5.0});
  metrics.Record("food", 6.0);
  CheckNumbers(*metrics.Find("food"), 2, {5.5, 11.0, 5.0, 6.0, 6.0});
  metrics.Set("food", kNaN);
  CHECK(metrics.Find("food")->Count == 0);
  CHECK(std::isnan(metrics.Find("food")->Value));
  metrics.Record("food", 7.0);
  CheckNumbers(*metrics.Find("food"), 1, {7.0, 7.0, 7.0, 7.0, 7.0});
}

TEST_CASE("metrics: names and units are kept when values are forgotten", "[core][metrics]") {
  CMetrics metrics;
  metrics.Record("length", 1.0, "m");
  metrics.Set("number", 2.0);
  metrics.ForgetValues();
  REQUIRE(metrics.GetAll().size() == 2);
  for (const CMetrics::SMetric& metric : metrics.GetAll()) {
    CHECK(metric.Count == 0);
    CHECK(std::isnan(metric.Value));
    CHECK(std::isnan(metric.Sum));
  }
  CHECK(metrics.GetAll()[0].Name == "length");
  CHECK(metrics.GetAll()[0].Unit == "m");
  CHECK(metrics.Find("lengt") == nullptr);
  // the first record after that stands alone
  metrics.Record("length", 3.0);
  CheckNumbers(metrics.GetAll()[0], 1, {3.0, 3.0, 3.0, 3.0, 3.0});
}

TEST_CASE("metrics: wrong names, units and values are errors and record nothing",
          "[core][metrics]") {
  CMetrics metrics;
  metrics.Record("length", 1.0, "m");
  for (const std::string name : {"", "1st", "a b", "_x", "x-y", "ä"}) {
    CAPTURE(name);
    CHECK_THROWS_WITH(metrics.Record(name, 1.0),
                      Contains("letters, digits and '_'") && Contains("found \"" + name + '"'));
    CHECK_THROWS_WITH(metrics.Set(name, 1.0), Contains("letters, digits and '_'"));
  }
  CHECK_THROWS_WITH(metrics.Record("length", 1.0, "cm"),
                    Contains("\"length\" has the unit \"m\", found \"cm\""));
  CHECK_THROWS_WITH(metrics.Set("length", 1.0, "cm"), Contains("has the unit \"m\""));
  for (const Real value : {kNaN, kInfinity, -kInfinity}) {
    CHECK_THROWS_WITH(metrics.Record("length", value), Contains("\"length\" must be a finite"));
    CHECK_THROWS_WITH(metrics.Record("width", value), Contains("\"width\" must be a finite"));
  }
  CHECK(metrics.GetAll().size() == 1);
  CheckNumbers(metrics.GetAll()[0], 1, {1.0, 1.0, 1.0, 1.0, 1.0});
}

TEST_CASE("metrics: without an experiment none can be computed", "[core][metrics]") {
  CMetrics metrics;
  CHECK_THROWS_WITH(metrics.EnableBuiltIn("dispersion"), Contains("no experiment is loaded"));
  CHECK(CMetrics::ListBuiltIns().size() >= 3);
}

TEST_CASE("metrics: records of threads are taken in the order of robots", "[core][metrics]") {
  CRobotRecords records;
  records.Begin(5, 2);
  CHECK_FALSE(records.TryAdd(0, 1.0));
  CHECK(records.IsEmpty());
  // robots 3 and 4, then 0; 1 and 2; in each run sensors come before controllers
  const auto run = [&](UInt32 thread, const std::vector<size_t>& robots, Real offset) {
    CRobotRecords::CScope scope(records, thread);
    for (const size_t robot : robots) {
      scope.SetRobot(robot);
      CHECK(records.TryAdd(0, 10.0 * static_cast<Real>(robot) + offset));
      CHECK(records.TryAdd("new", "m", 10.0 * static_cast<Real>(robot) + offset + 0.5));
    }
  };
  run(1, {3, 4}, 0.0);
  run(1, {3, 4}, 1.0);
  run(0, {1, 2}, 0.0);
  run(0, {1, 2}, 1.0);
  run(1, {0}, 0.0);
  run(1, {0}, 1.0);
  CHECK_FALSE(records.TryAdd(0, 1.0));
  std::vector<Real> values;
  records.End([&](const CRobotRecords::SRecord& record, const CRobotRecords::SNewMetric* metric) {
    values.push_back(record.Value);
    const bool isNew = std::fmod(record.Value, 1.0) == 0.5;
    CHECK((metric != nullptr) == isNew);
    if (metric != nullptr) {
      CHECK(metric->Name + metric->Unit == "newm");
    }
  });
  CHECK(values == std::vector<Real>{0.0,  0.5,  1.0,  1.5,  10.0, 10.5, 11.0, 11.5, 20.0, 20.5,
                                    21.0, 21.5, 30.0, 30.5, 31.0, 31.5, 40.0, 40.5, 41.0, 41.5});
  CHECK(records.IsEmpty());
}

TEST_CASE("metrics: what a loop that failed has recorded is dropped by the next",
          "[core][metrics]") {
  CRobotRecords records;
  records.Begin(1, 1);
  {
    CRobotRecords::CScope scope(records, 0);
    CHECK(records.TryAdd("new", "", 1.0));
  }
  CHECK_FALSE(records.IsEmpty());
  records.Begin(1, 1);
  CHECK(records.IsEmpty());
  size_t numTaken = 0;
  records.End([&](const CRobotRecords::SRecord&, const CRobotRecords::SNewMetric*) { ++numTaken; });
  CHECK(numTaken == 0);
}

TEST_CASE("metrics: a thread that runs another loop records there", "[core][metrics]") {
  CRobotRecords outer;
  CRobotRecords inner;
  outer.Begin(1, 1);
  inner.Begin(1, 1);
  const CRobotRecords::CScope outerScope(outer, 0);
  {
    const CRobotRecords::CScope innerScope(inner, 0);
    CHECK_FALSE(outer.TryAdd(0, 1.0));
    CHECK(inner.TryAdd(0, 1.0));
  }
  CHECK(outer.TryAdd(0, 1.0));
}

}  // namespace space_metrics_test
