#include <argos3/campaign/execution/metric_collection.h>

#include <argos3/core/simulator/outputs/run_output.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/metrics.h>
#include <argos3/core/simulator/space/space.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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
         (metric.IsSeries || FindReduction(metric.Reduction).Compute != nullptr);
}

void Add(SObservedValues& values, Real value) {
  values.Min = values.Count == 0 ? value : std::min(values.Min, value);
  values.Max = values.Count == 0 ? value : std::max(values.Max, value);
  values.Sum += value;
  ++values.Count;
}

Real Reduce(const SObservedValues& values, const SReduction& reduction) {
  return values.Count == 0 ? kNone : reduction.Compute(values);
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

/* Has the rows of a table of metrics that is written in each tick, but for that of the start. */
class CMetricCollection::COutput : public CRunOutput {
 public:
  explicit COutput(CMetricCollection& collection) : m_collection(collection) {}

  void Observe(CSimulator& simulator) override {
    m_collection.TakePending();
    if (std::exchange(m_hasBegun, true)) {
      m_collection.Keep(simulator);
    }
  }

  void Finish(CSimulator& simulator) override {
    if (m_collection.m_pendingTick == simulator.GetSpace().GetSimulationClock()) {
      m_collection.Keep(simulator);
    }
    m_collection.TakePending();
  }

  void Reset() override { m_hasBegun = false; }

 private:
  CMetricCollection& m_collection;
  bool m_hasBegun = false;  // a run
};

std::unique_ptr<CRunOutput> CMetricCollection::MakeOutput() {
  return m_isObserver ? std::make_unique<COutput>(*this) : nullptr;
}

void CMetricCollection::Keep(CSimulator& simulator) {
  m_pendingTick = simulator.GetSpace().GetSimulationClock();
  for (size_t i = 0; i < m_metrics.size(); ++i) {
    if (IsObserved(m_metrics[i])) {
      SReading reading = Read(simulator, m_metrics[i]);
      m_states[i].Pending = reading.Value;
      m_states[i].Unit = std::move(reading.Unit);
    }
  }
}

void CMetricCollection::TakePending() {
  if (!m_pendingTick) {
    return;
  }
  for (size_t i = 0; i < m_metrics.size(); ++i) {
    const SCollectedMetric& metric = m_metrics[i];
    if (!IsObserved(metric)) {
      continue;
    }
    SState& state = m_states[i];
    const Real value = state.Pending;
    if (!std::isnan(value)) {
      Add(state.Values, value);
    }
    if (metric.IsSeries && *m_pendingTick % std::max(1U, metric.Every) == 0) {
      state.Series.Unit = state.Unit;
      state.Series.Ticks.push_back(*m_pendingTick);
      state.Series.Values.push_back(value);
    }
  }
  m_pendingTick.reset();
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
    const SReduction& reduction = FindReduction(metric.Reduction);
    const bool isLast = reduction.Compute == nullptr;
    if (!metric.IsSeries || !IsCollectedAsNumber(m_metrics, metric.Name)) {
      result.Metrics.push_back(
          {metric.Name, last.Unit, isLast ? last.Value : Reduce(m_states[i].Values, reduction)});
    }
    if (metric.IsSeries) {
      m_states[i].Series.Name = metric.Name;
      result.Series.push_back(std::move(m_states[i].Series));
    }
  }
}

}  // namespace argos
