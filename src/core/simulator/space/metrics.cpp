#include <argos3/core/simulator/space/metrics.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>
#include <limits>

namespace argos {

namespace {

constexpr Real kNone = std::numeric_limits<Real>::quiet_NaN();

bool IsLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool IsName(const std::string& text) {
  return !text.empty() && IsLetter(text[0]) && std::all_of(text.begin(), text.end(), [](char c) {
    return IsLetter(c) || (c >= '0' && c <= '9') || c == '_';
  });
}

}  // namespace

void CMetrics::Set(const std::string& name, Real value, const std::string& unit) {
  for (SMetric& metric : m_metrics) {
    if (metric.Name == name) {
      if (!unit.empty() && unit != metric.Unit) {
        THROW_ARGOSEXCEPTION("the metric \"" << name << "\" has the unit \"" << metric.Unit
                                             << "\", found \"" << unit << '"');
      }
      metric.Value = value;
      return;
    }
  }
  if (!IsName(name)) {
    THROW_ARGOSEXCEPTION(
        "the name of a metric consists of letters, digits and '_', and begins with a letter; found "
        "\""
        << name << '"');
  }
  m_metrics.push_back({name, unit, value});
}

void CMetrics::ForgetValues() {
  for (SMetric& metric : m_metrics) {
    metric.Value = kNone;
  }
}

}  // namespace argos
