#ifndef ARGOS3_CAMPAIGN_DESIGN_COMBINATION_FILTER_H
#define ARGOS3_CAMPAIGN_DESIGN_COMBINATION_FILTER_H

#include <argos3/campaign/design/campaign.h>

#include <string>

namespace argos {

/**
 * @return the campaign with those combinations only for which a Lua expression of the factors, such
 *   as "robots > 5 and kind == 'a'", is true.
 * @throws CARGoSException if the expression fails, or is true for no combination.
 */
SCampaign SelectCombinations(const SCampaign& campaign, const std::string& where);

}  // namespace argos

#endif
