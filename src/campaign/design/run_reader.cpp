#include <argos3/campaign/design/element_reading.h>
#include <argos3/campaign/design/factor_values.h>
#include <argos3/campaign/design/reductions.h>
#include <argos3/campaign/design/section_readers.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>
#include <limits>

namespace argos {

namespace {

// a number greater than zero; 0 if the attribute is missing
Real ReadPositive(TConfigurationNode& node, const std::string& attribute) {
  if (!NodeAttributeExists(node, attribute)) {
    return 0.0;
  }
  Real value = 0.0;
  GetNodeAttribute(node, attribute, value);
  if (!(value > 0.0)) {
    ThrowAt(node, "attribute \"" + attribute + "\": expected a number greater than 0, found " +
                      ToString(value));
  }
  return value;
}

// of seeds first, first + 1, ...
void CheckLastSeed(const TConfigurationNode& node, UInt32 first, UInt32 count) {
  if (first > std::numeric_limits<UInt32>::max() - (count - 1)) {
    ThrowAt(node, "seeds from " + std::to_string(first) + " exceed 4294967295");
  }
}

void ReadSequentialRule(TConfigurationNode& node, SStopping& stopping) {
  constexpr UInt32 kMinRuns = 2;  // an interval needs two values
  stopping.Metric = ReadName(node, "until");
  GetNodeAttributeOrDefault(node, "level", stopping.Level, stopping.Level);
  if (!(stopping.Level > 0.0 && stopping.Level < 1.0)) {
    ThrowAt(node, "attribute \"level\": expected a number between 0 and 1, such as 0.95, found " +
                      ToString(stopping.Level));
  }
  stopping.Width = ReadPositive(node, "width");
  stopping.Relative = ReadPositive(node, "relative");
  if ((stopping.Width > 0.0) == (stopping.Relative > 0.0)) {
    ThrowAt(node,
            "until=\"...\" needs either relative=\"...\" (half the interval over the mean) or "
            "width=\"...\" (of the interval)");
  }
  stopping.MinRuns = ReadCount(node, "min", kMinRuns, stopping.MinRuns);
  stopping.MaxRuns = ReadCount(node, "max", kMinRuns, stopping.MaxRuns);
  if (stopping.MaxRuns < stopping.MinRuns) {
    ThrowAt(node, "expected min <= max, found min=\"" + std::to_string(stopping.MinRuns) +
                      "\" and max=\"" + std::to_string(stopping.MaxRuns) + '"');
  }
  stopping.FirstSeed = ReadCount(node, "first", 1, 1);
  CheckLastSeed(node, stopping.FirstSeed, stopping.MaxRuns);
}

void ReadSeedCount(TConfigurationNode& node, UInt32 count, SStopping& stopping) {
  constexpr UInt32 kMaxSeeds = 1000000;
  if (count < 1 || count > kMaxSeeds) {
    ThrowAt(node, "attribute \"seeds\": expected a number of seeds from 1 to " +
                      std::to_string(kMaxSeeds) + ", or a list, found " + std::to_string(count));
  }
  stopping.FirstSeed = ReadCount(node, "first", 1, 1);
  CheckLastSeed(node, stopping.FirstSeed, count);
  for (UInt32 i = 0; i < count; ++i) {
    stopping.Seeds.push_back(stopping.FirstSeed + i);
  }
}

void ReadSeeds(TConfigurationNode& node, SStopping& stopping) {
  const std::string text = ReadText(node, "seeds");
  UInt32 count = 0;
  if (ParseNumber(text, count) == ENumberParsing::Ok) {
    ReadSeedCount(node, count, stopping);
    return;
  }
  if (NodeAttributeExists(node, "first")) {
    ThrowAt(node, "attribute \"first\" belongs to a number of seeds; the list \"" + text +
                      "\" says which");
  }
  try {
    stopping.Seeds = ParseSeeds(text);
  } catch (const CARGoSException& error) {
    ThrowAt(node, "attribute \"seeds\": " + WithoutMark(error));
  }
}

SCollectedMetric ReadMetric(TConfigurationNode& node) {
  SCollectedMetric metric;
  metric.Name = ReadName(node, "name");
  GetNodeAttributeOrDefault(node, "series", metric.IsSeries, false);
  metric.Every = ReadCount(node, "every", 1, 1);
  if (!metric.IsSeries && NodeAttributeExists(node, "every")) {
    ThrowAt(node, "attribute \"every\" belongs to series=\"true\"");
  }
  if (metric.IsSeries && NodeAttributeExists(node, "of")) {
    ThrowAt(node, "attribute \"of\" makes one number of a run: it excludes series=\"true\"");
  }
  std::vector<SChoice<SCollectedMetric::EReduction>> reductions;
  for (const SReduction& reduction : ListReductions()) {
    reductions.push_back({reduction.Word, reduction.Value});
  }
  metric.Reduction = ReadChoice(node, "of", reductions, metric.Reduction);
  return metric;
}

SCollectedMetric ReadBuiltIn(TConfigurationNode& node) {
  SCollectedMetric metric = ReadMetric(node);
  metric.Source = SCollectedMetric::ESource::BuiltIn;
  const std::vector<std::string>& known = ListBuiltInMetrics();
  metric.Library = ReadOptionalText(node, "library");
  if (metric.Library.empty() && std::find(known.begin(), known.end(), metric.Name) == known.end()) {
    ThrowAt(node, "there is no built-in metric \"" + metric.Name + '"' +
                      DidYouMean(metric.Name, known) +
                      "; one of a plug-in needs its library=\"...\"");
  }
  return metric;
}

SCollectedMetric ReadFileMetric(TConfigurationNode& node) {
  SCollectedMetric metric;
  metric.Source = SCollectedMetric::ESource::File;
  metric.Name = ReadName(node, "name");
  metric.Pattern = ReadText(node, "pattern");
  metric.ValueColumn = ReadText(node, "value");
  metric.TimeColumn = ReadOptionalText(node, "time");
  metric.IsSeries = !metric.TimeColumn.empty();
  return metric;
}

void AddMetric(const SCollectedMetric& metric, const TConfigurationNode& node,
               SCampaign& campaign) {
  for (const SCollectedMetric& other : campaign.Metrics) {
    if (StringToLowerCase(other.Name) == StringToLowerCase(metric.Name) &&
        other.IsSeries == metric.IsSeries) {
      ThrowAt(node, "the name \"" + metric.Name + "\" is given twice");
    }
  }
  campaign.Metrics.push_back(metric);
}

}  // namespace

void ReadRuns(TConfigurationNode& node, SCampaign& campaign) {
  const bool isSequential = NodeAttributeExists(node, "until");
  if (isSequential == NodeAttributeExists(node, "seeds")) {
    ThrowAt(node, "expected either seeds=\"...\" or until=\"METRIC\"");
  }
  if (isSequential) {
    ReadSequentialRule(node, campaign.Stopping);
  } else {
    ReadSeeds(node, campaign.Stopping);
  }
}

void ReadLimits(TConfigurationNode& node, SCampaign& campaign) {
  campaign.Limits.WallTime = ReadPositive(node, "wall");
  campaign.Limits.Memory = ReadSize(node, "memory", 0);
  campaign.Limits.Output = ReadSize(node, "output", campaign.Limits.Output);
}

void ReadExecution(TConfigurationNode& node, SCampaign& campaign) {
  if (NodeAttributeExists(node, "jobs")) {
    campaign.Jobs = ReadCount(node, "jobs", 1, 1);
  }
  if (campaign.Jobs > kMaxJobs) {
    ThrowAt(node, "attribute \"jobs\": expected a whole number from 1 to " +
                      std::to_string(kMaxJobs) + ", found " + std::to_string(campaign.Jobs));
  }
  campaign.Isolation = ReadChoice<EIsolation>(
      node, "isolation",
      {{"process", EIsolation::OwnProcess}, {"thread", EIsolation::SharedProcess}},
      campaign.Isolation);
  GetNodeAttributeOrDefault(node, "threads", campaign.Threads, 0u);
  campaign.Kept = ReadChoice<EKeptFiles>(
      node, "keep",
      {{"none", EKeptFiles::None}, {"failed", EKeptFiles::Failed}, {"all", EKeptFiles::All}},
      campaign.Kept);
}

bool ReadCollected(CLoadErrors& errors, TConfigurationNode& node, SCampaign& campaign) {
  size_t numElements = 0;
  const auto readWith = [&](SCollectedMetric (*read)(TConfigurationNode&)) {
    return [&, read](TConfigurationNode& element) {
      ++numElements;
      AddMetric(read(element), element, campaign);
    };
  };
  ReadChildren(errors, node,
               {{"metric", readWith(ReadMetric)},
                {"builtin", readWith(ReadBuiltIn)},
                {"file", readWith(ReadFileMetric)}});
  return campaign.Metrics.size() == numElements;
}

std::string FindMetricProblem(const SCampaign& campaign, const std::string& name, bool isSeries) {
  if (campaign.Metrics.empty()) {
    return isSeries ? "the series \"" + name + "\" is not collected: add <metric name=\"" + name +
                          "\" series=\"true\"/> to <collect>"
                    : "";
  }
  // of a series the last value is kept, too
  std::vector<std::string> known;
  bool isNumber = false;
  for (const SCollectedMetric& metric : campaign.Metrics) {
    if (metric.Name == name && (metric.IsSeries || !isSeries)) {
      return "";
    }
    isNumber = isNumber || metric.Name == name;
    if (metric.IsSeries || !isSeries) {
      known.push_back(metric.Name);
    }
  }
  if (isNumber) {
    return '"' + name + "\" is collected as one number of a run, not as a series";
  }
  return std::string(isSeries ? "the series \"" : "the metric \"") + name +
         "\" is not collected: <collect> does not name it" + DidYouMean(name, known);
}

void CheckStopping(const SCampaign& campaign, const std::string& location) {
  if (campaign.Stopping.Metric.empty()) {
    return;
  }
  const std::string problem = FindMetricProblem(campaign, campaign.Stopping.Metric, false);
  if (!problem.empty()) {
    THROW_ARGOSEXCEPTION(location << ": attribute \"until\": " << problem);
  }
}

}  // namespace argos
