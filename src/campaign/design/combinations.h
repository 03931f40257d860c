#ifndef ARGOS3_CAMPAIGN_DESIGN_COMBINATIONS_H
#define ARGOS3_CAMPAIGN_DESIGN_COMBINATIONS_H

// private: from factors to combinations

#include <argos3/campaign/design/campaign.h>
#include <argos3/campaign/design/factor_reader.h>
#include <argos3/core/simulator/context/load_errors.h>

namespace argos {

/**
 * Fills Factors, Combinations, NumExcluded and Warnings of a campaign. The last factor varies
 * fastest in a full design. Errors are recorded.
 * @param design  continuous factors get their levels.
 */
void MakeCombinations(CLoadErrors& errors, SDesignSource& design, SCampaign& campaign);

}  // namespace argos

#endif
