#ifndef ARGOS3_CAMPAIGN_SLURM_RUN_SHARE_H
#define ARGOS3_CAMPAIGN_SLURM_RUN_SHARE_H

#include <argos3/campaign/design/campaign.h>
#include <argos3/campaign/scheduling/run_plan.h>
#include <argos3/campaign/store/result_store.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

/**
 * Which runs of a campaign a task executes. All shares together are the campaign, no run is in two
 * of them, and which share a run is in does not depend on the runs that are stored.
 *
 * With a list of seeds, share (combination + place of the seed in the list) modulo Count: each
 * combination, which may take longer than others, is spread over all tasks. With a stopping rule,
 * whole combinations: combination modulo Count, because the rule takes the runs in order.
 */
struct SRunShare {
  UInt32 Number = 1; /**< 1 to Count */
  UInt32 Count = 1; /**< tasks */
};

/** Reads "2/4". @throws CARGoSException */
SRunShare ParseRunShare(const std::string& text);

/** @return the campaign with the combinations of which the share has runs. */
SCampaign SelectCombinations(const SCampaign& campaign, const SRunShare& share);

/** @return the runs of the share that are known. */
std::vector<SKnownRun> SelectKnownRuns(const SCampaign& selected, const SRunShare& share,
                                       const std::vector<SKnownRun>& known);

/**
 * The plan of a share.
 * @param selected  by SelectCombinations().
 * @param known     indices of combinations are those of @p selected.
 */
std::unique_ptr<CRunPlan> CreateSharePlan(const SCampaign& selected, const SRunShare& share,
                                          const std::vector<SKnownRun>& known);

/**
 * A digest of what shares depend on: combinations, seeds or stopping rule, what is collected, and
 * the experiment. Tasks of one submission must agree on it.
 */
std::string ComputeSubmissionDigest(const SCampaign& campaign);

/** @throws CARGoSException if the campaign has another digest. */
void ThrowIfChanged(const SCampaign& campaign, const std::string& submissionDigest);

}  // namespace argos

#endif
