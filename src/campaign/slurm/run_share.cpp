#include <argos3/campaign/slurm/run_share.h>

#include <argos3/campaign/store/experiment_files.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <fmt/format.h>

#include <limits>
#include <map>

namespace argos {

namespace {

bool IsSequential(const SCampaign& campaign) {
  return !campaign.Stopping.Metric.empty();
}

bool IsInShare(const SRunShare& share, size_t combination, size_t placeOfSeed) {
  return (combination + placeOfSeed) % share.Count == share.Number - 1;
}

UInt32 ParseCount(const std::string& text, const std::string& whole) {
  UInt32 count = 0;
  if (ParseNumber(text, count) != ENumberParsing::Ok || count == 0) {
    THROW_ARGOSEXCEPTION("a share is NUMBER/COUNT, such as 2/4, both at least 1; found \"" << whole
                                                                                           << '"');
  }
  return count;
}

}  // namespace

SRunShare ParseRunShare(const std::string& text) {
  const size_t slash = text.find('/');
  SRunShare share;
  share.Number = ParseCount(text.substr(0, slash), text);
  share.Count = ParseCount(slash == std::string::npos ? "" : text.substr(slash + 1), text);
  if (share.Number > share.Count) {
    THROW_ARGOSEXCEPTION("the share \"" << text << "\": there are " << share.Count << " only");
  }
  return share;
}

SCampaign SelectCombinations(const SCampaign& campaign, const SRunShare& share) {
  SCampaign selected = campaign;
  if (IsSequential(campaign)) {
    selected.Combinations.clear();
    for (size_t i = 0; i < campaign.Combinations.size(); ++i) {
      if (IsInShare(share, i, 0)) {
        selected.Combinations.push_back(campaign.Combinations[i]);
      }
    }
  }
  return selected;
}

std::vector<SKnownRun> SelectKnownRuns(const SCampaign& selected, const SRunShare& share,
                                       const std::vector<SKnownRun>& known) {
  if (IsSequential(selected)) {
    return known;
  }
  std::map<UInt32, size_t> placeOf;
  for (size_t place = 0; place < selected.Stopping.Seeds.size(); ++place) {
    placeOf.emplace(selected.Stopping.Seeds[place], place);
  }
  std::vector<SKnownRun> ofShare;
  for (const SKnownRun& run : known) {
    const auto place = placeOf.find(run.Seed);
    if (place != placeOf.end() && IsInShare(share, run.Combination, place->second)) {
      ofShare.push_back(run);
    }
  }
  return ofShare;
}

std::unique_ptr<CRunPlan> CreateSharePlan(const SCampaign& selected, const SRunShare& share,
                                          const std::vector<SKnownRun>& known) {
  std::vector<SKnownRun> notToBeRun = known;
  if (!IsSequential(selected)) {
    // runs of other shares need not be executed, as if they were known
    for (size_t place = 0; place < selected.Stopping.Seeds.size(); ++place) {
      for (size_t i = 0; i < selected.Combinations.size(); ++i) {
        if (!IsInShare(share, i, place)) {
          notToBeRun.push_back(
              {i, selected.Stopping.Seeds[place], std::numeric_limits<Real>::quiet_NaN()});
        }
      }
    }
  }
  return CRunPlan::Create(selected, notToBeRun);
}

std::string ComputeSubmissionDigest(const SCampaign& campaign) {
  const SStopping& stopping = campaign.Stopping;
  std::string text = campaign.ExperimentText;
  for (const SCombination& combination : campaign.Combinations) {
    text += combination.ComputeKey() + "\n";
  }
  for (const UInt32 seed : stopping.Seeds) {
    text += fmt::format("{} ", seed);
  }
  text += fmt::format("\n{} {} {} {} {} {} {}\n", stopping.Metric, stopping.Level, stopping.Width,
                      stopping.Relative, stopping.MinRuns, stopping.MaxRuns, stopping.FirstSeed);
  for (const SCollectedMetric& metric : campaign.Metrics) {
    text += fmt::format("{} {} {} {} {} {} {} {}\n", metric.Name, static_cast<int>(metric.Source),
                        static_cast<int>(metric.Reduction), metric.IsSeries, metric.Every,
                        metric.Pattern, metric.TimeColumn, metric.ValueColumn);
  }
  return ComputeTextDigest(text);
}

void ThrowIfChanged(const SCampaign& campaign, const std::string& submissionDigest) {
  if (ComputeSubmissionDigest(campaign) != submissionDigest) {
    THROW_ARGOSEXCEPTION(campaign.File
                         << " or its experiment has changed since it was submitted: the shares of "
                            "its tasks would not fit together. Undo the change, or cancel what is "
                            "queued and submit the campaign again");
  }
}

}  // namespace argos
