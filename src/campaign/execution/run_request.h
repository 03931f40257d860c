#ifndef ARGOS3_CAMPAIGN_EXECUTION_RUN_REQUEST_H
#define ARGOS3_CAMPAIGN_EXECUTION_RUN_REQUEST_H

#include <argos3/campaign/design/campaign.h>

#include <optional>
#include <string>
#include <vector>

namespace argos {

/** What the runs of a campaign have in common. */
struct SRunSetup {
  std::string ExperimentFile; /**< absolute path: for messages and files beside it */
  std::string ExperimentText; /**< contents of that file */
  std::vector<SSetting> Constants; /**< settings of all runs */
  std::string StartFolder; /**< absolute; relative paths of input files begin here, too */
  /** number of threads of a run that sets no other one; none: as in the experiment */
  std::optional<UInt32> Threads = 0;
  std::vector<SCollectedMetric> Metrics; /**< empty: all that a run sets */
  SRunLimits Limits;
  EIsolation Isolation = EIsolation::OwnProcess;
  EKeptFiles Kept = EKeptFiles::None;
  bool HasLiveViews = false; /**< viewers may come and go; `argos3-campaign live` lists the runs */
};

/** One run. */
struct SRunRequest {
  UInt64 Id = 0; /**< chosen by the sender: the result carries it */
  UInt32 Seed = 0;
  std::vector<SSetting> Settings;
  std::string Folder; /**< working directory of the run, created for it */
};

}  // namespace argos

#endif
