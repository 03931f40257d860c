#include <argos3/campaign/design/reductions.h>

#include <iterator>

namespace argos {

namespace {

Real ReduceToMean(const SObservedValues& values) {
  return values.Sum / static_cast<Real>(values.Count);
}

Real ReduceToSum(const SObservedValues& values) {
  return values.Sum;
}

Real ReduceToMin(const SObservedValues& values) {
  return values.Min;
}

Real ReduceToMax(const SObservedValues& values) {
  return values.Max;
}

constexpr SReduction kReductions[] = {{SCollectedMetric::EReduction::Last, "last", nullptr},
                                      {SCollectedMetric::EReduction::Mean, "mean", &ReduceToMean},
                                      {SCollectedMetric::EReduction::Sum, "sum", &ReduceToSum},
                                      {SCollectedMetric::EReduction::Min, "min", &ReduceToMin},
                                      {SCollectedMetric::EReduction::Max, "max", &ReduceToMax}};

constexpr bool IsInOrder() {
  for (size_t i = 0; i < std::size(kReductions); ++i) {
    if (static_cast<size_t>(kReductions[i].Value) != i) {
      return false;
    }
  }
  return true;
}

static_assert(IsInOrder(), "a row is found by its enumerator; stored results have its number");

}  // namespace

std::span<const SReduction> ListReductions() {
  return kReductions;
}

const SReduction& FindReduction(SCollectedMetric::EReduction value) {
  return kReductions[static_cast<size_t>(value)];
}

}  // namespace argos
