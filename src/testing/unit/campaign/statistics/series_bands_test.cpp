#include "hostile_values.h"

#include <argos3/campaign/statistics/sample_checks.h>
#include <argos3/campaign/statistics/series_bands.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace series_bands_test {

using Catch::Contains;
using namespace argos;

TEST_CASE("bands of series: median and quartiles at each tick", "[campaign][statistics]") {
  const std::vector<std::vector<Real>> series = {
      {1.0, 10.0, 5.0}, {8.0, 20.0}, {2.0, 40.0, 7.0}, {4.0, kNaN}, {}};
  const SSeriesBands bands = ComputeSeriesBands(series);
  // quantiles of type 7 of {1, 2, 4, 8}, {10, 20, 40} and {5, 7}
  CHECK(bands.Counts == std::vector<size_t>{4, 3, 2});
  CHECK(bands.Lower == std::vector<Real>{1.75, 15.0, 5.5});
  CHECK(bands.Median == std::vector<Real>{3.0, 20.0, 6.0});
  CHECK(bands.Upper == std::vector<Real>{5.0, 30.0, 6.5});
}

TEST_CASE("bands of series: other probabilities", "[campaign][statistics]") {
  const std::vector<std::vector<Real>> series = {{1.0}, {2.0}, {4.0}};
  const SSeriesBands bands = ComputeSeriesBands(series, 0.0, 1.0);
  CHECK(bands.Lower[0] == 1.0);
  CHECK(bands.Median[0] == 2.0);
  CHECK(bands.Upper[0] == 4.0);
}

TEST_CASE("bands of series: ticks without values", "[campaign][statistics]") {
  const SSeriesBands bands =
      ComputeSeriesBands(std::vector<std::vector<Real>>{{kNaN, 3.0}, {kNaN}});
  CHECK(bands.Counts == std::vector<size_t>{0, 1});
  CHECK(std::isnan(bands.Median[0]));
  CHECK(std::isnan(bands.Lower[0]));
  CHECK(std::isnan(bands.Upper[0]));
  CHECK(bands.Median[1] == 3.0);
  CHECK(ComputeSeriesBands(std::vector<std::vector<Real>>{{}, {}}).Counts.empty());
}

TEST_CASE("bands of series: hostile input", "[campaign][statistics]") {
  CHECK_THROWS_WITH(ComputeSeriesBands({}), Contains("there is no series"));
  const std::vector<std::vector<Real>> infinite = {{1.0, 2.0}, {1.0, -kInfinity}};
  CHECK_THROWS_WITH(ComputeSeriesBands(infinite), Contains("series 2, tick 2: value -inf"));
  const std::vector<std::vector<Real>> one = {{1.0}};
  CHECK_THROWS_WITH(ComputeSeriesBands(one, -0.1, 0.5), Contains("lower probability"));
  CHECK_THROWS_WITH(ComputeSeriesBands(one, 0.1, kNaN), Contains("upper probability"));
  CHECK_THROWS_WITH(ComputeSeriesBands(one, 0.6, 0.5), Contains("must not be greater"));
  // the limits themselves
  CHECK(ComputeSeriesBands(one, 0.5, 0.5).Lower == std::vector<Real>{1.0});
  const std::vector<std::vector<Real>> greatest = {{-kMaxValue, kMaxValue}};
  CHECK(ComputeSeriesBands(greatest).Median == greatest[0]);
}

TEST_CASE("series bands: what counts of series that have ended", "[campaign][statistics]") {
  const auto apply = [](EEndedRuns rule) {
    std::vector<std::vector<Real>> series = {
        {1.0, 2.0, 3.0, 4.0}, {5.0, 6.0}, {7.0, 8.0, kNaN}, {kNaN, kNaN}};
    ApplyToEndedRuns(series, rule);
    return ComputeSeriesBands(series);
  };
  const SSeriesBands survivors = apply(EEndedRuns::Survivors);
  CHECK(survivors.Counts == std::vector<size_t>{3, 3, 1, 1});
  CHECK(survivors.Median == std::vector<Real>{5.0, 6.0, 3.0, 4.0});
  // a value that is missing within a series stays so
  const SSeriesBands held = apply(EEndedRuns::Hold);
  CHECK(held.Counts == std::vector<size_t>{3, 3, 2, 3});
  CHECK(held.Median == std::vector<Real>{5.0, 6.0, 4.5, 6.0});
  const SSeriesBands dropped = apply(EEndedRuns::Drop);
  CHECK(dropped.Counts == std::vector<size_t>{3, 3});
  CHECK(dropped.Median == std::vector<Real>{5.0, 6.0});
  std::vector<std::vector<Real>> none;
  CHECK_NOTHROW(ApplyToEndedRuns(none, EEndedRuns::Hold));
}

}  // namespace series_bands_test
