#include <argos3/campaign/statistics/series_bands.h>

#include <argos3/campaign/statistics/quantile.h>
#include <argos3/campaign/statistics/sample_checks.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace argos {

namespace {

// the values of one tick, ascending
void CollectTick(std::span<const std::vector<Real>> series, size_t tick,
                 std::vector<Real>& values) {
  values.clear();
  for (size_t i = 0; i < series.size(); ++i) {
    if (tick >= series[i].size() || std::isnan(series[i][tick])) {
      continue;
    }
    const Real value = series[i][tick];
    if (std::abs(value) > kMaxValue) {
      THROW_ARGOSEXCEPTION("series " << i + 1 << ", tick " << tick + 1 << ": value " << value
                                     << "; finite values up to " << kMaxValue << " are allowed");
    }
    values.push_back(value);
  }
  std::sort(values.begin(), values.end());
}

}  // namespace

void ApplyToEndedRuns(std::vector<std::vector<Real>>& series, EEndedRuns rule) {
  if (series.empty() || rule == EEndedRuns::Survivors) {
    return;
  }
  const auto [shortest, longest] = std::ranges::minmax_element(series, {}, std::ranges::size);
  const size_t length = rule == EEndedRuns::Drop ? shortest->size() : longest->size();
  for (std::vector<Real>& each : series) {
    const auto last =
        std::find_if(each.rbegin(), each.rend(), [](Real value) { return !std::isnan(value); });
    const bool hasValue = last != each.rend();
    each.resize(length, hasValue ? *last : std::numeric_limits<Real>::quiet_NaN());
  }
}

SSeriesBands ComputeSeriesBands(std::span<const std::vector<Real>> series, Real lower, Real upper) {
  RequireProbability(lower, "lower probability of a band");
  RequireProbability(upper, "upper probability of a band");
  if (lower > upper) {
    THROW_ARGOSEXCEPTION("band from probability " << lower << " to " << upper
                                                  << "; the first must not be greater");
  }
  if (series.empty()) {
    THROW_ARGOSEXCEPTION("bands of time series: there is no series");
  }
  size_t length = 0;
  for (const std::vector<Real>& each : series) {
    length = std::max(length, each.size());
  }
  constexpr Real kNone = std::numeric_limits<Real>::quiet_NaN();
  SSeriesBands bands{std::vector<size_t>(length), std::vector<Real>(length, kNone),
                     std::vector<Real>(length, kNone), std::vector<Real>(length, kNone)};
  std::vector<Real> values;
  values.reserve(series.size());
  for (size_t tick = 0; tick < length; ++tick) {
    CollectTick(series, tick, values);
    bands.Counts[tick] = values.size();
    if (!values.empty()) {
      bands.Lower[tick] = ComputeQuantile(values, lower);
      bands.Median[tick] = ComputeMedian(values);
      bands.Upper[tick] = ComputeQuantile(values, upper);
    }
  }
  return bands;
}

}  // namespace argos
