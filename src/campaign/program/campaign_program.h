#ifndef ARGOS3_CAMPAIGN_PROGRAM_CAMPAIGN_PROGRAM_H
#define ARGOS3_CAMPAIGN_PROGRAM_CAMPAIGN_PROGRAM_H

namespace argos {

/**
 * The program argos3-campaign. Never throws: errors are printed on the standard error.
 *
 * @return the exit status: 0 if all runs are done; 1 after an error; 3 if some runs have failed;
 *   128 + signal if a signal has stopped the campaign.
 */
int RunCampaignProgram(int argc, const char* const* argv) noexcept;

}  // namespace argos

#endif
