// Tests that each scene of the benchmark runs, that the rows of the accuracy benchmark are
// complete, and that their values for exact engines are right.

#include <argos3/testing/scenario/command_line/program_run.h>
#include <argos3/testing/support/overlap.h>
#include <argos3/testing/support/robot_sizes.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <sstream>

namespace argos::benchmarks_test {

using testing::MeasureOverlaps;
using testing::SOverlaps;

namespace {

using TRow = std::map<std::string, std::string>;

std::vector<std::string> Split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) {
    fields.push_back(field);
  }
  return fields;
}

std::vector<TRow> ReadCsv(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> names = Split(line);
  std::vector<TRow> rows;
  while (std::getline(lines, line)) {
    const std::vector<std::string> fields = Split(line);
    REQUIRE(fields.size() == names.size());
    TRow row;
    for (size_t i = 0; i < names.size(); ++i) {
      row[names[i]] = fields[i];
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

TEST_CASE("benchmark: every scene runs", "[scenario][benchmark]") {
  const CTestFolder folder;
  const std::string refusal = folder.RunProgram("argos3_benchmark", {"--scene", "?"}).Err;
  const size_t open = refusal.find('{');
  const size_t close = refusal.find('}');
  CAPTURE(refusal);
  REQUIRE(open < close);
  REQUIRE(close < refusal.size());
  const std::vector<std::string> scenes = Split(refusal.substr(open + 1, close - open - 1));
  CHECK(scenes.size() >= 13);
  for (const std::string& scene : scenes) {
    const bool isInSpace = scene == "towers" || scene == "stack" || scene == "pile";
    const SProgramRun run = folder.RunProgram(
        "argos3_benchmark",
        {"--scene", scene, "--engine", isInSpace ? "dynamics3d" : "dynamics2d", "--robots", "12",
         "--ticks", "2", "--warm-up", "1", "--bare-up-to", "0"});
    CAPTURE(scene, run.Out, run.Err);
    REQUIRE(run.Status == 0);
    const std::vector<TRow> rows = ReadCsv(run.Out);
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].at("scene") == scene);
    CHECK(std::stod(rows[0].at("total_us")) > 0.0);
  }
}

TEST_CASE("accuracy benchmark: has a row with finite numbers for each engine and stepper",
          "[scenario][benchmark]") {
  const CTestFolder folder;
  const SProgramRun run = folder.RunProgram(
      "argos3_accuracy_benchmark", {"--robots", "40", "--iterations", "0,5", "--rooms-ticks", "2",
                                    "--crowd-ticks", "2", "--warm-up", "15"});
  CAPTURE(run.Out, run.Err);
  REQUIRE(run.Status == 0);
  const std::vector<TRow> rows = ReadCsv(run.Out);
  // kinematics2d, dynamics2d, dynamics3d with three steppers, pointmass3d
  REQUIRE(rows.size() == 6 * 2);
  std::map<std::string, int> rowsOf;
  for (const TRow& row : rows) {
    const std::string& engine = row.at("engine");
    ++rowsOf[engine + " " + row.at("stepper")];
    const bool hasCrowd = engine != "pointmass3d" && row.at("stepper") != "direct";
    for (const auto& [name, field] : row) {
      CAPTURE(engine, name, field);
      const bool isText = name == "engine" || name == "stepper" || name == "iterations";
      const bool isOfCrowd = name.rfind("crowd", 0) == 0;
      const bool isOfContact = name.find("_pct") != std::string::npos && name != "arc_error_pct";
      if (isText || (isOfCrowd && !hasCrowd) || (field == "-" && isOfContact && !isOfCrowd)) {
        CHECK((isText || field == "-"));
        continue;
      }
      size_t length = 0;
      const Real value = std::stod(field, &length);
      CHECK(length == field.size());
      CHECK(std::isfinite(value));
      CHECK(value >= 0.0);
    }
    // limits for free robots in a minute, from the READMEs of the
    // engines: 1e-9 m, or 2 % of the path
    if (engine != "dynamics3d") {
      CHECK(std::stod(row.at("arc_error_mm")) <= 1e-6);
    } else if (row.at("stepper") != "iterative") {
      CHECK(std::stod(row.at("arc_error_pct")) <= 2.0);
    }
    if (row.at("iterations") == "5") {
      CHECK(row.at("substeps") == "5");
    }
    if (hasCrowd) {
      // within 15 ticks robots with gaps of 3 mm press against each other
      CHECK(std::stod(row.at("crowd_touching_pct")) > 90.0);
    }
    if (engine == "kinematics2d") {
      CHECK(std::stod(row.at("crowd_overlap_max_pct")) <= 1e-9);
      CHECK(std::stod(row.at("crowd_wall_max_pct")) <= 1e-9);
    }
  }
  CHECK(rowsOf.size() == 6);
}

TEST_CASE("accuracy benchmark: unknown engines are refused", "[scenario][benchmark]") {
  const CTestFolder folder;
  const SProgramRun run =
      folder.RunProgram("argos3_accuracy_benchmark", {"--engine", "dynamics4d"});
  CHECK(run.Status != 0);
  CHECK_THAT(run.Err, Catch::Matchers::Contains("dynamics4d"));
}

TEST_CASE("overlap: tilted robots are measured at their nearest ends", "[scenario][benchmark]") {
  constexpr Real kRadius = kEPuckRadius;
  constexpr Real kHeight = 0.086;  // m
  const Real distance = GENERATE(0.075, 0.0775);
  CAPTURE(distance);
  // the second robot tilts towards the first by 5 degrees
  SRobotExperiment experiment;
  experiment.Arena =
      Robot("e-puck", "a", "position='0,0,0'") +
      Robot("e-puck", "b", "position='" + ToText(distance) + ",0,0' orientation='0,-5,0'") +
      Robot("e-puck", "far", "position='1,0,0'");
  CRobotWorld world(experiment);
  world.Step();
  SOverlaps overlaps;
  MeasureOverlaps(world.GetSpace(), overlaps);
  const Real depth = 2.0 * kRadius - (distance - kHeight * std::sin(5.0 * ARGOS_PI / 180.0));
  REQUIRE(overlaps.WithRobots.size() == 3);
  // the first distance gives an overlap of 2.5 mm, the second a gap of 5 um
  const std::vector<Real> expected = {std::max(0.0, depth / kRadius),
                                      std::max(0.0, depth / kRadius), 0.0};
  for (size_t i = 0; i < 3; ++i) {
    CHECK_THAT(overlaps.WithRobots[i], Catch::Matchers::WithinAbs(expected[i], 1e-9));
  }
  CHECK(overlaps.Touching.size() == 2);
}

}  // namespace argos::benchmarks_test
