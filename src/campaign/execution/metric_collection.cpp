#include <argos3/campaign/execution/metric_collection.h>

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/metrics.h>
#include <argos3/core/simulator/space/space.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace argos {

namespace {

constexpr Real kNone = std::numeric_limits<Real>::quiet_NaN();

struct SReading {
  Real Value = kNone;
  std::string Unit;
};

SReading Read(CSimulator& simulator, const SCollectedMetric& metric) {
  const CMetrics::SMetric* const present = simulator.GetMetrics().Find(metric.Name);
  return present == nullptr ? SReading() : SReading{present->Value, present->Unit};
}

bool IsObserved(const SCollectedMetric& metric) {
  return metric.Source != SCollectedMetric::ESource::File &&
         (metric.IsSeries || metric.Reduction != SCollectedMetric::EReduction::Last);
}

}  // namespace

bool IsCollectedAsNumber(const std::vector<SCollectedMetric>& metrics, const std::string& name) {
  return std::any_of(metrics.begin(), metrics.end(), [&name](const SCollectedMetric& metric) {
    return metric.Name == name && !metric.IsSeries;
  });
}

CMetricCollection::CMetricCollection(const std::vector<SCollectedMetric>& metrics)
    : m_metrics(metrics),
      m_states(metrics.size()),
      m_isObserver(std::any_of(metrics.begin(), metrics.end(), &IsObserved)) {}

void CMetricCollection::Begin(CSimulator& simulator) {
  for (const SCollectedMetric& metric : m_metrics) {
    if (metric.Source == SCollectedMetric::ESource::BuiltIn) {
      simulator.GetMetrics().EnableBuiltIn(metric.Name);
    }
  }
}

void CMetricCollection::Observe(CSimulator& simulator) {
  const UInt32 tick = simulator.GetSpace().GetSimulationClock();
  for (size_t i = 0; i < m_metrics.size(); ++i) {
    const SCollectedMetric& metric = m_metrics[i];
    if (!IsObserved(metric)) {
      continue;
    }
    const SReading reading = Read(simulator, metric);
    SState& state = m_states[i];
    if (!std::isnan(reading.Value)) {
      state.Min = state.Count == 0 ? reading.Value : std::min(state.Min, reading.Value);
      state.Max = state.Count == 0 ? reading.Value : std::max(state.Max, reading.Value);
      state.Sum += reading.Value;
      ++state.Count;
    }
    if (metric.IsSeries && tick % std::max(1U, metric.Every) == 0) {
      state.Series.Unit = reading.Unit;
      state.Series.Ticks.push_back(tick);
      state.Series.Values.push_back(reading.Value);
    }
  }
}

Real CMetricCollection::Reduce(const SState& state, SCollectedMetric::EReduction reduction) {
  using enum SCollectedMetric::EReduction;
  if (state.Count == 0) {
    return kNone;
  }
  switch (reduction) {
    case Mean:
      return state.Sum / static_cast<Real>(state.Count);
    case Sum:
      return state.Sum;
    case Min:
      return state.Min;
    case Max:
      return state.Max;
    default:
      return kNone;
  }
}

void CMetricCollection::Finish(CSimulator& simulator, SRunResult& result) {
  if (m_metrics.empty()) {
    for (const CMetrics::SMetric& metric : simulator.GetMetrics().GetAll()) {
      result.Metrics.push_back({metric.Name, metric.Unit, metric.Value});
    }
    return;
  }
  for (size_t i = 0; i < m_metrics.size(); ++i) {
    const SCollectedMetric& metric = m_metrics[i];
    if (metric.Source == SCollectedMetric::ESource::File) {
      continue;
    }
    const SReading last = Read(simulator, metric);
    const bool isLast = metric.Reduction == SCollectedMetric::EReduction::Last;
    if (!metric.IsSeries || !IsCollectedAsNumber(m_metrics, metric.Name)) {
      result.Metrics.push_back(
          {metric.Name, last.Unit, isLast ? last.Value : Reduce(m_states[i], metric.Reduction)});
    }
    if (metric.IsSeries) {
      m_states[i].Series.Name = metric.Name;
      result.Series.push_back(std::move(m_states[i].Series));
    }
  }
}

}  // namespace argos
