#include <argos3/campaign/report/report_data.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/lists.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>
#include <tuple>

namespace argos {

namespace {

[[noreturn]] void ThrowNotRecorded(const std::string& name, const std::vector<std::string>& known,
                                   const std::vector<std::string>& others, bool isSeries) {
  const char* const kind = isSeries ? "series" : "metric";
  if (std::find(others.begin(), others.end(), name) != others.end()) {
    THROW_ARGOSEXCEPTION('"' << name << '"'
                             << (isSeries ? " is one number of a run, not a time series"
                                          : " is a time series, not one number of a run"));
  }
  THROW_ARGOSEXCEPTION("no run has recorded the " << kind << " \"" << name << '"'
                                                  << DidYouMean(name, known));
}

bool Contains(const std::vector<size_t>& indices, size_t index) {
  return std::find(indices.begin(), indices.end(), index) != indices.end();
}

std::pair<size_t, UInt32> KeyOf(const SRunValue& value) {
  return {value.Combination, value.Seed};
}

// @return 0 if it is no number.
Real ToNumber(const std::string& text) {
  Real number = 0.0;
  ParseNumber(text, number);
  return number;
}

}  // namespace

bool ParseLevels(const std::vector<std::string>& levels, std::vector<Real>& numbers) {
  numbers.assign(levels.size(), 0.0);
  for (size_t i = 0; i < levels.size(); ++i) {
    if (ParseNumber(levels[i], numbers[i]) != ENumberParsing::Ok) {
      return false;
    }
  }
  return true;
}

CReportData::CReportData(const SCampaign& campaign, const CResultStore& store)
    : m_campaign(campaign), m_store(store) {
  ReadRuns();
  FindLevels();
}

void CReportData::ReadRuns() {
  std::map<std::string, size_t> byKey;
  for (size_t i = 0; i < m_campaign.Combinations.size(); ++i) {
    byKey.emplace(m_campaign.Combinations[i].ComputeKey(), i);
  }
  for (const SStoredCombination& stored : m_store.ListCombinations()) {
    const auto place = byKey.find(stored.Key);
    if (place != byKey.end()) {
      m_indexOf.emplace(stored.Id, place->second);
    }
  }
  for (const SStoredRun& run : m_store.ListRuns()) {
    if (m_indexOf.count(run.Combination) > 0) {
      m_runs.push_back(run);
    } else {
      ++m_numLeftOut;
    }
  }
  std::sort(m_runs.begin(), m_runs.end(), [this](const SStoredRun& a, const SStoredRun& b) {
    return std::make_tuple(GetCombination(a), a.Seed) < std::make_tuple(GetCombination(b), b.Seed);
  });
}

void CReportData::FindLevels() {
  m_levels.resize(m_campaign.Factors.size());
  for (size_t factor = 0; factor < m_levels.size(); ++factor) {
    std::vector<std::string>& levels = m_levels[factor];
    for (const SCombination& combination : m_campaign.Combinations) {
      const std::string& value = combination.Values.at(factor);
      if (std::find(levels.begin(), levels.end(), value) == levels.end()) {
        levels.push_back(value);
      }
    }
    std::vector<Real> numbers;
    if (ParseLevels(levels, numbers)) {
      std::ranges::stable_sort(levels, {}, ToNumber);
    }
  }
}

size_t CReportData::FindFactor(const std::string& name) const {
  const std::vector<std::string> names = m_campaign.ListFactors();
  const auto place = std::find(names.begin(), names.end(), name);
  if (place == names.end()) {
    THROW_ARGOSEXCEPTION("there is no factor \"" << name << '"' << DidYouMean(name, names));
  }
  return static_cast<size_t>(place - names.begin());
}

size_t CReportData::GetLevel(size_t combination, size_t factor) const {
  const std::vector<std::string>& levels = m_levels.at(factor);
  const std::string& value = m_campaign.Combinations.at(combination).Values.at(factor);
  return static_cast<size_t>(std::find(levels.begin(), levels.end(), value) - levels.begin());
}

std::string CReportData::DescribeCombination(size_t combination,
                                             const std::vector<size_t>& without) const {
  std::string text;
  const std::vector<std::string>& values = m_campaign.Combinations.at(combination).Values;
  for (size_t factor = 0; factor < values.size(); ++factor) {
    if (!Contains(without, factor)) {
      AppendItem(text, m_campaign.Factors[factor].Name + " = " + values[factor]);
    }
  }
  return text;
}

std::vector<SRunValue> CReportData::ReadMetric(const std::string& name) const {
  const std::vector<std::string> known = m_store.ListMetrics();
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    ThrowNotRecorded(name, known, m_store.ListSeries(), false);
  }
  std::vector<SRunValue> values;
  for (const CResultStore::SValue& value : m_store.ReadMetric(name)) {
    const auto index = m_indexOf.find(value.Combination);
    if (index != m_indexOf.end()) {
      values.push_back({index->second, value.Seed, value.Value});
    }
  }
  std::ranges::stable_sort(values, {}, KeyOf);
  return values;
}

std::vector<SRunSeries> CReportData::ReadSeries(const std::string& name) const {
  const std::vector<std::string> known = m_store.ListSeries();
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    ThrowNotRecorded(name, known, m_store.ListMetrics(), true);
  }
  std::vector<SRunSeries> all;
  for (CResultStore::SSeriesOfRun& series : m_store.ReadSeries(name)) {
    const auto index = m_indexOf.find(series.Combination);
    if (index != m_indexOf.end()) {
      all.push_back({index->second, series.Seed, std::move(series.Series)});
    }
  }
  return all;
}

}  // namespace argos
