#include <argos3/campaign/store/failed_runs.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace argos {

namespace {

constexpr size_t kMaxMessageLength = 300;

bool IsPlain(const std::string& word) {
  constexpr char kPlain[] =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./,:@%+=";
  return !word.empty() && word.find_first_not_of(kPlain) == std::string::npos;
}

}  // namespace

std::string DescribeLevels(const SCampaign& campaign, const SCombination& combination) {
  std::string text;
  for (size_t i = 0; i < combination.Values.size() && i < campaign.Factors.size(); ++i) {
    text += campaign.Factors[i].Name + "=" + combination.Values[i] + ", ";
  }
  return text;
}

namespace {

// the last line of an error, without those that only add details to it: tracebacks and lists
size_t FindLastError(const std::string& log) {
  constexpr char kMark[] = "[FATAL] ";
  constexpr size_t kMarkLength = sizeof(kMark) - 1;
  size_t place = log.rfind(kMark);
  while (place != std::string::npos && place > 0) {
    const char first = place + kMarkLength < log.size() ? log[place + kMarkLength] : '\n';
    const bool isDetail =
        first == ' ' || first == '\t' || log.compare(place + kMarkLength, 6, "stack ") == 0;
    if (!isDetail) {
      break;
    }
    place = log.rfind(kMark, place - 1);
  }
  return place;
}

}  // namespace

std::string FindErrorMessage(const std::string& log) {
  size_t place = log.rfind("[FATAL] crash");
  if (place == std::string::npos) {
    place = FindLastError(log);
  }
  if (place == std::string::npos) {
    return "";
  }
  size_t end = log.find('\n', place);
  if (end != std::string::npos && log.compare(end + 1, 7, "[FATAL]") == 0) {
    end = log.find('\n', end + 1);
  }
  std::string message = log.substr(place, std::min(end - place, kMaxMessageLength));
  std::replace(message.begin(), message.end(), '\n', ' ');
  return message;
}

std::string QuoteForShell(const std::string& word) {
  if (IsPlain(word)) {
    return word;
  }
  std::string quoted = "'";
  for (const char character : word) {
    // a quote ends the quoted part, is escaped, and begins the next one
    quoted += character == '\'' ? "'\\''" : std::string(1, character);
  }
  return quoted + "'";
}

std::string MakeRepeatCommand(const SCampaign& campaign, const SCombination& combination,
                              UInt32 seed) {
  std::string command =
      fmt::format("argos3 -zc {} --seed {}", QuoteForShell(campaign.ExperimentFile), seed);
  for (const std::vector<SSetting>* settings : {&campaign.Constants, &combination.Settings}) {
    for (const SSetting& setting : *settings) {
      command += " --set " + QuoteForShell(setting.Path + "=" + setting.Value);
    }
  }
  return command;
}

std::string DescribeFailedRuns(const SCampaign& campaign, const CResultStore& store, size_t most) {
  std::map<UInt32, const SCombination*> combinations;
  std::map<std::string, const SCombination*> byKey;
  for (const SCombination& combination : campaign.Combinations) {
    byKey.emplace(combination.ComputeKey(), &combination);
  }
  for (const SStoredCombination& stored : store.ListCombinations()) {
    const auto place = byKey.find(stored.Key);
    if (place != byKey.end()) {
      combinations.emplace(stored.Id, place->second);
    }
  }
  std::string text;
  size_t count = 0;
  for (const SStoredRun& run : store.ListRuns()) {
    const auto combination = combinations.find(run.Combination);
    if (run.Result.Status == ERunStatus::Done || combination == combinations.end()) {
      continue;
    }
    if (++count > most) {
      continue;
    }
    const std::optional<SStoredRun> whole = store.FindRun(run.Id);
    const std::string message = whole ? FindErrorMessage(whole->Result.Log) : "";
    text += fmt::format("  {}seed={}: {}\n", DescribeLevels(campaign, *combination->second),
                        run.Seed, ToText(run.Result.Status));
    text += message.empty() ? "" : "    " + message + "\n";
    text += "    " + MakeRepeatCommand(campaign, *combination->second, run.Seed) + "\n";
  }
  if (count > most) {
    text += fmt::format("  and {} more\n", count - most);
  }
  return count == 0 ? "" : fmt::format("{} run{} failed:\n", count, count == 1 ? "" : "s") + text;
}

}  // namespace argos
