#include <argos3/campaign/report/comparisons.h>

#include <argos3/campaign/report/report_text.h>
#include <argos3/campaign/report/summary_tables.h>
#include <argos3/campaign/statistics/dunn_test.h>
#include <argos3/campaign/statistics/friedman_test.h>
#include <argos3/campaign/statistics/kruskal_wallis_test.h>
#include <argos3/campaign/statistics/p_value_adjustment.h>
#include <argos3/campaign/statistics/rank_sum_test.h>
#include <argos3/campaign/statistics/signed_rank_test.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace argos {

namespace {

typedef std::map<UInt32, Real> TValuesOfSeeds;

// the levels that are compared in one context
struct SLevelSamples {
  std::vector<std::string> Levels;
  std::vector<TValuesOfSeeds> Values;  // (Levels.size()), without missing ones
  size_t NumMissing = 0;
};

SRankTestOptions MakeOptions() {
  SRankTestOptions options;
  options.Level = kReportLevel;
  return options;
}

std::vector<std::vector<Real>> GetGroups(const SLevelSamples& samples) {
  std::vector<std::vector<Real>> groups;
  for (const TValuesOfSeeds& values : samples.Values) {
    std::vector<Real>& group = groups.emplace_back();
    for (const auto& [seed, value] : values) {
      group.push_back(value);
    }
  }
  return groups;
}

// keeps the seeds that all levels have
void KeepCommonSeeds(SLevelSamples& samples) {
  std::map<UInt32, size_t> counts;
  for (const TValuesOfSeeds& values : samples.Values) {
    for (const auto& [seed, value] : values) {
      ++counts[seed];
    }
  }
  samples.NumMissing = 0;
  for (const auto& [seed, count] : counts) {
    if (count == samples.Values.size()) {
      continue;
    }
    ++samples.NumMissing;
    for (TValuesOfSeeds& values : samples.Values) {
      values.erase(seed);
    }
  }
}

SPairComparison MakePair(const SLevelSamples& samples, const std::vector<std::vector<Real>>& groups,
                         size_t first, size_t second, bool isPaired, Real& statistic) {
  const SRankTestResult test =
      isPaired ? TestSignedRankOfPairs(groups[second], groups[first], MakeOptions())
               : TestRankSum(groups[second], groups[first], MakeOptions());
  statistic = test.Statistic;
  return {
      samples.Levels[first], samples.Levels[second], groups[first].size(), groups[second].size(),
      test.Estimate,         test.Interval,          test.PValue};
}

void CompareTwo(const SLevelSamples& samples, const std::vector<std::vector<Real>>& groups,
                bool isPaired, SComparisonResult& result) {
  Real statistic = 0.0;
  result.Pairs.push_back(MakePair(samples, groups, 0, 1, isPaired, statistic));
  result.Test = isPaired ? "Wilcoxon's signed-rank test" : "Wilcoxon's rank-sum test";
  result.Statistic = fmt::format("{} = {}", isPaired ? 'V' : 'W', FormatNumber(statistic));
  result.PValue = result.Pairs.front().PValue;
}

SChiSquareResult TestBlocks(const std::vector<std::vector<Real>>& groups) {
  std::vector<std::vector<Real>> blocks(groups.front().size());
  for (size_t block = 0; block < blocks.size(); ++block) {
    for (const std::vector<Real>& group : groups) {
      blocks[block].push_back(group[block]);
    }
  }
  return TestFriedman(blocks);
}

void CompareMany(const SLevelSamples& samples, const std::vector<std::vector<Real>>& groups,
                 bool isPaired, SComparisonResult& result) {
  const SChiSquareResult test = isPaired ? TestBlocks(groups) : TestKruskalWallis(groups);
  result.Test = isPaired
                    ? "Friedman's test, pairs by Wilcoxon's signed-rank test with Holm's method"
                    : "Kruskal and Wallis' test, pairs by Dunn's test with Holm's method";
  result.Statistic = fmt::format("{} = {}, {} degrees of freedom", isPaired ? "chi square" : "H",
                                 FormatNumber(test.Statistic), test.DegreesOfFreedom);
  result.PValue = test.PValue;
  std::vector<Real> pValues;
  for (size_t first = 0; first < groups.size(); ++first) {
    for (size_t second = first + 1; second < groups.size(); ++second) {
      Real statistic = 0.0;
      result.Pairs.push_back(MakePair(samples, groups, first, second, isPaired, statistic));
      pValues.push_back(result.Pairs.back().PValue);
    }
  }
  if (isPaired) {
    pValues = AdjustPValues(pValues, EPValueAdjustment::Holm);
  } else {
    // Dunn's pairs have the same order
    const std::vector<SGroupComparison> dunn = CompareByDunn(groups, EPValueAdjustment::Holm);
    std::ranges::transform(dunn, pValues.begin(), &SGroupComparison::AdjustedPValue);
  }
  for (size_t i = 0; i < pValues.size(); ++i) {
    result.Pairs[i].PValue = pValues[i];
  }
}

SComparisonResult Compare(const std::string& context, SLevelSamples samples, bool isPaired) {
  SComparisonResult result;
  result.Context = context;
  if (isPaired) {
    KeepCommonSeeds(samples);
  }
  result.NumMissing = samples.NumMissing;
  for (size_t i = 0; i < samples.Levels.size(); ++i) {
    if (samples.Values[i].empty()) {
      result.Problem = isPaired ? "no seed has a value at every level"
                                : "there is no value at the level " + samples.Levels[i];
      return result;
    }
  }
  try {
    const std::vector<std::vector<Real>> groups = GetGroups(samples);
    if (groups.size() == 2) {
      CompareTwo(samples, groups, isPaired, result);
    } else {
      CompareMany(samples, groups, isPaired, result);
    }
  } catch (const CARGoSException& error) {
    result.Problem = DescribeProblem(error);
  }
  return result;
}

// adds values to the last level
void AddValues(const std::vector<SRunValue>& values, SLevelSamples& samples) {
  for (const SRunValue& value : values) {
    if (std::isnan(value.Value)) {
      ++samples.NumMissing;
    } else {
      samples.Values.back().emplace(value.Seed, value.Value);
    }
  }
}

// groups by levels of the other factors, in the order of the combinations
std::vector<std::pair<std::string, SLevelSamples>> CollectContexts(const CReportData& data,
                                                                   const std::string& metric,
                                                                   size_t factor) {
  std::vector<std::vector<SRunValue>> byCombination(data.GetCampaign().Combinations.size());
  for (const SRunValue& value : data.ReadMetric(metric)) {
    byCombination[value.Combination].push_back(value);
  }
  std::vector<std::string> names;
  std::map<std::string, std::map<size_t, std::vector<size_t>>> combinationsOf;  // indexed by level
  for (size_t i = 0; i < byCombination.size(); ++i) {
    const std::string context = data.DescribeCombination(i, {factor});
    if (combinationsOf.count(context) == 0) {
      names.push_back(context);
    }
    combinationsOf[context][data.GetLevel(i, factor)].push_back(i);
  }
  std::vector<std::pair<std::string, SLevelSamples>> contexts;
  for (const std::string& name : names) {
    SLevelSamples samples;
    for (const auto& [level, combinations] : combinationsOf[name]) {
      samples.Levels.push_back(data.GetLevels(factor).at(level));
      samples.Values.emplace_back();
      for (const size_t combination : combinations) {
        AddValues(byCombination[combination], samples);
      }
    }
    contexts.emplace_back(name, samples);
  }
  return contexts;
}

}  // namespace

SComparisonTable CompareLevels(const CReportData& data, const SComparison& request) {
  const size_t factor = data.FindFactor(request.Factor);
  if (data.GetLevels(factor).size() < 2) {
    THROW_ARGOSEXCEPTION("the factor \"" << request.Factor
                                         << "\" has one level only: there is nothing to compare");
  }
  SComparisonTable table;
  table.Request = request;
  table.Unit = data.GetStore().GetUnit(request.Metric, false);
  for (auto& [name, samples] : CollectContexts(data, request.Metric, factor)) {
    // other levels are excluded, or the design is no full one
    if (samples.Levels.size() >= 2) {
      table.Results.push_back(Compare(name, samples, request.IsPaired));
    }
  }
  if (table.Results.empty()) {
    THROW_ARGOSEXCEPTION("no two combinations differ in \"" << request.Factor
                                                            << "\" only, so that its levels cannot "
                                                               "be compared");
  }
  return table;
}

std::vector<SComparisonTable> CompareAll(const CReportData& data) {
  std::vector<SComparisonTable> tables;
  for (const SComparison& request : data.GetCampaign().Comparisons) {
    try {
      tables.push_back(CompareLevels(data, request));
    } catch (const CARGoSException& error) {
      SComparisonTable& table = tables.emplace_back();
      table.Request = request;
      table.Problem = DescribeProblem(error);
    }
  }
  return tables;
}

}  // namespace argos
