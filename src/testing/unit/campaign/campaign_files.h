#ifndef ARGOS3_TESTING_UNIT_CAMPAIGN_CAMPAIGN_FILES_H
#define ARGOS3_TESTING_UNIT_CAMPAIGN_CAMPAIGN_FILES_H

#include <argos3/campaign/design/campaign.h>
#include <argos3/campaign/store/result_store.h>
#include <argos3/testing/support/temporary_folder.h>

#include <string>

namespace argos {

/** An experiment with two controllers, a <distribute> and attributes to be varied. */
extern const char* const kCampaignExperiment;

/** Writes test.argos and test.xml, a campaign with the given contents. */
std::string WriteCampaign(const CTemporaryFolder& folder, const std::string& contents);

/** Reads such a campaign. */
SCampaign ReadTestCampaign(const CTemporaryFolder& folder, const std::string& contents);

/** @return the text of the exception that reading it throws; empty if it throws none. */
std::string ReadCampaignError(const std::string& contents);

/** A done run with the metric "delivered", and the series "spread" of three ticks. */
SStoredRun MakeRun(UInt32 combination, UInt32 seed, Real delivered);

/** @return the text of the exception that a function throws; empty if it throws none. */
template <typename FUNCTION>
std::string CatchText(const FUNCTION& function) {
  try {
    function();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace argos

#endif
