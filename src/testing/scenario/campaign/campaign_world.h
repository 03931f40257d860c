#ifndef ARGOS3_TESTING_SCENARIO_CAMPAIGN_CAMPAIGN_WORLD_H
#define ARGOS3_TESTING_SCENARIO_CAMPAIGN_CAMPAIGN_WORLD_H

#include <string>

namespace argos {

/**
 * An experiment with two foot-bots and the library argos3_test_campaign: metrics "level", which
 * depends on the seed, and "ticks".
 * @param what    the controller's parameter, see the library.
 * @param seed    of the run that misbehaves.
 * @param length  s.
 */
std::string MakeCampaignExperiment(const std::string& what = "", int seed = 1, int length = 1);

}  // namespace argos

#endif
