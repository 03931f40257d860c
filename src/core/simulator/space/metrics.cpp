#include <argos3/core/simulator/space/metrics.h>

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/space/built_in_metric.h>
#include <argos3/core/simulator/space/robot_records.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/text/names.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace argos {

namespace {

void CheckName(std::string_view name) {
  if (!IsName(name)) {
    THROW_ARGOSEXCEPTION(
        "the name of a metric consists of letters, digits and '_', and begins with a letter; found "
        "\""
        << name << '"');
  }
  if (CMetrics::IsReserved(name)) {
    THROW_ARGOSEXCEPTION("a metric must not have the name \""
                         << name
                         << "\", because every table of metrics has a column of that name (run, "
                            "tick, time, robots, stopped): record it under another name");
  }
}

}  // namespace

bool CMetrics::IsReserved(std::string_view name) {
  constexpr std::array<std::string_view, 5> kReserved = {"run", "tick", "time", "robots",
                                                         "stopped"};
  return std::find(kReserved.begin(), kReserved.end(), name) != kReserved.end();
}

CMetrics::CMetrics() : m_records(std::make_unique<CRobotRecords>()) {}

CMetrics::~CMetrics() = default;

void CMetrics::Record(std::string_view name, Real value, std::string_view unit) {
  if (!std::isfinite(value)) {
    THROW_ARGOSEXCEPTION("the value of the metric \""
                         << name << "\" must be a finite number, found " << value);
  }
  const size_t number = FindNumber(name);
  bool isOfRobot = false;
  if (number != kUnknown) {
    Check(number, unit);
    isOfRobot = m_records->TryAdd(static_cast<UInt32>(number), value);
  } else {
    CheckName(name);
    isOfRobot = m_records->TryAdd(name, unit, value);
  }
  if (!isOfRobot) {
    if (m_context != nullptr) {
      m_context->Run.CheckIsNotInPhase("CMetrics::Record()",
                                       "it is possible in code of robots, and in hooks");
    }
    Add(m_metrics[GetOrCreate(name, unit)], value);
  }
}

void CMetrics::Set(const std::string& name, Real value, const std::string& unit) {
  if (m_context != nullptr) {
    m_context->Run.CheckIsNotInPhase("CMetrics::Set()",
                                     "it is possible in hooks; robots call CMetrics::Record()");
  }
  Replace(m_metrics[GetOrCreate(name, unit)], value);
}

const CMetrics::SMetric* CMetrics::Find(std::string_view name) const {
  const size_t number = FindNumber(name);
  return number == kUnknown ? nullptr : &m_metrics[number];
}

size_t CMetrics::FindNumber(std::string_view name) const {
  const auto found = m_numbers.find(name);
  return found == m_numbers.end() ? kUnknown : found->second;
}

size_t CMetrics::GetOrCreate(std::string_view name, std::string_view unit) {
  const size_t number = FindNumber(name);
  if (number == kUnknown) {
    CheckName(name);
    return Create(name, unit);
  }
  Check(number, unit);
  return number;
}

size_t CMetrics::Create(std::string_view name, std::string_view unit) {
  ARGOS_ASSERT(FindNumber(name) == kUnknown, "there is already a metric \"" << name << '"');
  SMetric& metric = m_metrics.emplace_back();
  metric.Name = name;
  metric.Unit = unit;
  m_numbers.emplace(metric.Name, m_metrics.size() - 1);
  return m_metrics.size() - 1;
}

// throws if code must not record the metric so
void CMetrics::Check(size_t number, std::string_view unit) const {
  ARGOS_ASSERT(number < m_metrics.size(), "there is no metric number " << number);
  const SMetric& metric = m_metrics[number];
  if (metric.IsBuiltIn) {
    THROW_ARGOSEXCEPTION("the metric \"" << metric.Name
                                         << "\" is built in, and the program computes it in this "
                                            "run: record yours under another name");
  }
  if (!unit.empty() && unit != metric.Unit) {
    THROW_ARGOSEXCEPTION("the metric \"" << metric.Name << "\" has the unit \"" << metric.Unit
                                         << "\", found \"" << unit << '"');
  }
}

UInt32 CMetrics::GetTick() const {
  return m_context != nullptr ? *m_context->Clock : 0;
}

void CMetrics::Add(SMetric& metric, Real value) const {
  if (metric.Count == 0 || metric.Tick != GetTick() || metric.Period != m_period) {
    Replace(metric, value);
    return;
  }
  ++metric.Count;
  metric.Sum += value;
  metric.Min = std::min(metric.Min, value);
  metric.Max = std::max(metric.Max, value);
  metric.Last = value;
  metric.Value = metric.Sum / static_cast<Real>(metric.Count);
}

void CMetrics::Replace(SMetric& metric, Real value) const {
  metric.Value = metric.Sum = metric.Min = metric.Max = metric.Last = value;
  metric.Count = std::isnan(value) ? 0 : 1;
  metric.Tick = GetTick();
  metric.Period = m_period;
}

bool CMetrics::HasLateRecords() const {
  return std::any_of(m_metrics.begin(), m_metrics.end(), [this](const SMetric& metric) {
    return metric.Count > 0 && metric.Period == m_period && metric.Tick == GetTick();
  });
}

const std::vector<CMetrics::SFailure>& CMetrics::TakeRobotRecords() {
  m_failures.clear();
  m_records->End(
      [this](const CRobotRecords::SRecord& record, const CRobotRecords::SNewMetric* newMetric) {
        if (newMetric == nullptr) {
          ARGOS_ASSERT(record.Metric < m_metrics.size(), "a robot has recorded metric number "
                                                             << record.Metric << " of "
                                                             << m_metrics.size());
          Add(m_metrics[record.Metric], record.Value);
          return;
        }
        // the first robot decides about the unit
        try {
          Add(m_metrics[GetOrCreate(newMetric->Name, newMetric->Unit)], record.Value);
        } catch (const CARGoSException&) {
          if (m_failures.empty() || m_failures.back().Robot != record.Robot) {
            m_failures.push_back({record.Robot, std::current_exception()});
          }
        }
      });
  return m_failures;
}

void CMetrics::ForgetValues() {
  for (SMetric& metric : m_metrics) {
    Replace(metric, kNone);
    metric.Tick = 0;
  }
  for (const SBuiltIn& builtIn : m_builtIns) {
    builtIn.Metric->Reset();
  }
}

std::vector<std::string> CMetrics::ListBuiltIns() {
  return CFactory<CBuiltInMetric>::GetLabels();
}

void CMetrics::EnableBuiltIn(const std::string& name) {
  if (m_context == nullptr) {
    THROW_ARGOSEXCEPTION("no experiment is loaded: there is nothing to compute \"" << name
                                                                                   << "\" from");
  }
  m_context->Run.CheckIsNotInPhase("CMetrics::EnableBuiltIn()", "it is possible in hooks");
  if (!CFactory<CBuiltInMetric>::Exists(name)) {
    THROW_ARGOSEXCEPTION("there is no built-in metric \"" << name << '"'
                                                          << DidYouMean(name, ListBuiltIns()));
  }
  const SMetric* const known = Find(name);
  if (m_context->IsReplay) {
    if (known == nullptr) {
      LOGERR << "[WARNING] the recorded run had no metric \"" << name
             << "\": built-in metrics are computed in a run, not in a replay" << std::endl;
    }
    return;
  }
  if (known != nullptr) {
    if (!known->IsBuiltIn) {
      THROW_ARGOSEXCEPTION(
          "code of the experiment has recorded a metric of its own with the name "
          "of the built-in metric \""
          << name << "\": give it another name");
    }
    return;
  }
  SBuiltIn builtIn{std::unique_ptr<CBuiltInMetric>(CFactory<CBuiltInMetric>::New(name)),
                   m_metrics.size()};
  try {
    builtIn.Metric->Init(*m_context->Space);
  } catch (...) {
    ThrowWithCause("the built-in metric \"" + name + "\" cannot be computed in this experiment");
  }
  SMetric& metric = m_metrics[Create(name, builtIn.Metric->GetUnit())];
  metric.IsBuiltIn = true;
  metric.IsReproducible = builtIn.Metric->IsReproducible();
  m_builtIns.push_back(std::move(builtIn));
  if (!m_context->Loading.IsLoading()) {
    Update(m_builtIns.back());
  }
}

void CMetrics::Update(const SBuiltIn& builtIn) {
  ARGOS_ASSERT(builtIn.Number < m_metrics.size() && m_metrics[builtIn.Number].IsBuiltIn,
               "metric number " << builtIn.Number << " is not built in");
  SMetric& metric = m_metrics[builtIn.Number];
  try {
    Replace(metric, builtIn.Metric->Compute());
  } catch (...) {
    ThrowWithCause("the built-in metric \"" + metric.Name + "\" threw in tick " +
                   std::to_string(GetTick()));
  }
}

void CMetrics::UpdateBuiltIns() {
  for (const SBuiltIn& builtIn : m_builtIns) {
    Update(builtIn);
  }
}

}  // namespace argos
