#include <argos3/campaign/report/equal_levels.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace argos {

namespace {

constexpr size_t kMaxComparedLevels = 1000;  // levels of a factor: all pairs are compared
constexpr size_t kMaxNamedLevels = 5;  // levels that a warning names

/** The runs of a level: what they have in common with one of another level, and the digests. */
struct SLevelRuns {
  struct SRun {
    size_t Others;  // number of the values of all other factors
    UInt32 Seed;
    UInt64 Digest;
    size_t Combination;
    bool operator<(const SRun& other) const {
      return std::tie(Others, Seed) < std::tie(other.Others, other.Seed);
    }
  };
  std::string Value;
  std::vector<SRun> Runs;  // sorted
};

std::vector<SLevelRuns> CollectLevels(const CReportData& data, size_t factor) {
  std::vector<SLevelRuns> levels;
  std::map<std::string, size_t> levelOf;
  std::map<std::vector<std::string>, size_t> numberOf;
  for (const SStoredRun& run : data.GetRuns()) {
    const ERunStatus status = run.Result.Status;
    if (status != ERunStatus::Done && status != ERunStatus::RobotsStopped) {
      continue;
    }
    const size_t combination = data.GetCombination(run);
    std::vector<std::string> others = data.GetCampaign().Combinations.at(combination).Values;
    const std::string value = others.at(factor);
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(factor));
    const size_t number = numberOf.emplace(std::move(others), numberOf.size()).first->second;
    const auto [level, isNew] = levelOf.emplace(value, levels.size());
    if (isNew) {
      levels.push_back({value, {}});
    }
    levels[level->second].Runs.push_back({number, run.Seed, run.Result.Digest, combination});
  }
  for (SLevelRuns& level : levels) {
    std::sort(level.Runs.begin(), level.Runs.end());
  }
  return levels;
}

// number of pairs of runs that differ in the level only; 0 if one of them is not equal
size_t CountEqualPairs(const SLevelRuns& first, const SLevelRuns& second) {
  size_t count = 0;
  auto one = first.Runs.begin();
  auto other = second.Runs.begin();
  while (one != first.Runs.end() && other != second.Runs.end()) {
    if (*one < *other) {
      ++one;
    } else if (*other < *one) {
      ++other;
    } else if (one->Digest != other->Digest) {
      return 0;
    } else {
      ++count;
      ++one;
      ++other;
    }
  }
  return count;
}

/** Equal levels of a factor. */
struct SEqualLevels {
  std::vector<const SLevelRuns*> Levels;
  size_t NumPairs = 0;
};

// the first level that others are equal to, with all of these
SEqualLevels FindEqualLevels(const std::vector<SLevelRuns>& levels) {
  for (size_t first = 0; first < levels.size(); ++first) {
    SEqualLevels equal;
    for (size_t second = first + 1; second < levels.size(); ++second) {
      const size_t count = CountEqualPairs(levels[first], levels[second]);
      if (count > 0) {
        equal.NumPairs += count;
        equal.Levels.push_back(&levels[second]);
      }
    }
    if (!equal.Levels.empty()) {
      equal.Levels.insert(equal.Levels.begin(), &levels[first]);
      return equal;
    }
  }
  return {};
}

// true if a metric has different values in runs that differ in the level only
bool DoMetricsDiffer(const SEqualLevels& equal, const CReportData& data) {
  for (const std::string& metric : data.GetStore().ListMetrics()) {
    std::map<std::pair<size_t, UInt32>, Real> values;
    for (const SRunValue& value : data.ReadMetric(metric)) {
      values[{value.Combination, value.Seed}] = value.Value;
    }
    std::map<std::pair<size_t, UInt32>, std::string> known;  // values are texts: NaN equals itself
    for (const SLevelRuns* level : equal.Levels) {
      for (const SLevelRuns::SRun& run : level->Runs) {
        const std::string text = fmt::format("{}", values[{run.Combination, run.Seed}]);
        if (known.emplace(std::pair(run.Others, run.Seed), text).first->second != text) {
          return true;
        }
      }
    }
  }
  return false;
}

std::string NameLevels(const SEqualLevels& equal, size_t numLevels) {
  if (equal.Levels.size() == numLevels && numLevels > 2) {
    return fmt::format("all {} levels", numLevels);
  }
  std::string names;
  const size_t named = std::min(equal.Levels.size(), kMaxNamedLevels);
  for (size_t i = 0; i < named; ++i) {
    if (i > 0) {
      names += i + 1 == equal.Levels.size() ? " and " : ", ";
    }
    names += equal.Levels[i]->Value;
  }
  const size_t others = equal.Levels.size() - named;
  return "the levels " + names + (others > 0 ? fmt::format(" and {} others", others) : "");
}

}  // namespace

std::vector<std::string> WarnOfEqualLevels(const CReportData& data) {
  const std::vector<SFactor>& factors = data.GetCampaign().Factors;
  std::vector<std::string> warnings;
  for (size_t factor = 0; factor < factors.size(); ++factor) {
    if (factors[factor].SetsThreads) {
      continue;
    }
    const std::vector<SLevelRuns> levels = CollectLevels(data, factor);
    const SEqualLevels equal =
        levels.size() > kMaxComparedLevels ? SEqualLevels() : FindEqualLevels(levels);
    if (equal.Levels.empty()) {
      continue;
    }
    warnings.push_back(fmt::format(
        "{} of the factor \"{}\" have equal final states (digests) in {}: {}",
        NameLevels(equal, levels.size()), factors[factor].Name,
        equal.NumPairs == 1 ? "the only pair of runs"
                            : fmt::format("all {} pairs of runs", equal.NumPairs),
        DoMetricsDiffer(equal, data) ? "it affects metrics, but nothing in the simulation"
                                     : "it seems to be without effect; check what it "
                                       "sets, and that users' code reads that"));
  }
  return warnings;
}

}  // namespace argos
