#ifndef ARGOS3_CAMPAIGN_SLURM_PART_MERGING_H
#define ARGOS3_CAMPAIGN_SLURM_PART_MERGING_H

#include <argos3/campaign/design/campaign.h>
#include <argos3/campaign/store/result_store.h>

#include <string>
#include <vector>

namespace argos {

/** What MergeParts() has done. */
struct SMergedParts {
  UInt32 Parts = 0; /**< merged, and removed */
  UInt64 Runs = 0; /**< copied */
  std::vector<std::string> Problems; /**< a text for each part that could not be merged */
};

/**
 * Merges the databases of tasks, moves the files that runs have left to NAME.runs, and removes
 * what is merged. A part that is being written, or is damaged, stays where it is. May be killed and
 * repeated at any time: a run that is there already is not copied again.
 */
SMergedParts MergeParts(const SCampaign& campaign, CResultStore& store);

}  // namespace argos

#endif
