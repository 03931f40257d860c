#include <argos3/campaign/slurm/part_merging.h>

#include <argos3/campaign/design/element_reading.h>
#include <argos3/campaign/slurm/submission_files.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <map>

namespace fs = std::filesystem;

namespace argos {

namespace {

// combination ids of the part -> of the results
std::map<UInt32, UInt32> MatchCombinations(const std::string& part, const CResultStore& store) {
  const CResultStore partStore(part, CResultStore::EMode::ReadOnly);
  std::map<UInt32, UInt32> ids;
  for (const SStoredCombination& combination : partStore.ListCombinations()) {
    ids.emplace(combination.Id, store.GetCombinationId(combination.Key));
  }
  return ids;
}

// the folders "combination_ID_seed_SEED" of runs whose files are kept
void MoveKeptFiles(const fs::path& from, const fs::path& to,
                   const std::map<UInt32, UInt32>& combinations) {
  if (!fs::exists(from)) {
    return;
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
    UInt32 combination = 0, seed = 0;
    if (std::sscanf(entry.path().filename().c_str(), "combination_%u_seed_%u", &combination,
                    &seed) != 2 ||
        combinations.count(combination) == 0) {
      continue;
    }
    const fs::path target =
        to / fmt::format("combination_{}_seed_{}", combinations.at(combination), seed);
    fs::create_directories(to);
    fs::remove_all(target);
    fs::rename(entry.path(), target);
  }
  fs::remove_all(from);
}

UInt64 MergePart(const SCampaign& campaign, CResultStore& store, const std::string& part) {
  {
    // undoes what a killed task has left half written; throws if a task is writing it
    const CResultStore repaired(part, CResultStore::EMode::WriteShared);
  }
  const UInt64 runs = store.Merge(part);
  const std::map<UInt32, UInt32> combinations = MatchCombinations(part, store);
  MoveKeptFiles(fs::path(part).replace_extension(".runs"),
                fs::absolute(campaign.ResultsFile).replace_extension(".runs"), combinations);
  fs::remove(part);
  return runs;
}

}  // namespace

SMergedParts MergeParts(const SCampaign& campaign, CResultStore& store) {
  SMergedParts merged;
  const SSubmissionPaths paths(campaign);
  for (const std::string& part : ListParts(paths)) {
    try {
      merged.Runs += MergePart(campaign, store, part);
      ++merged.Parts;
    } catch (const CARGoSException& error) {
      // its runs are in no danger; the other parts are merged
      merged.Problems.push_back(WithoutMark(error));
    } catch (const fs::filesystem_error& error) {
      merged.Problems.push_back(part + ": " + error.what());
    }
  }
  // a folder that is not empty stays
  std::error_code ignored;
  fs::remove(paths.Parts, ignored);
  return merged;
}

}  // namespace argos
