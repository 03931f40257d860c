#ifndef ARGOS3_CAMPAIGN_SLURM_SUBMISSION_FILES_H
#define ARGOS3_CAMPAIGN_SLURM_SUBMISSION_FILES_H

#include <argos3/campaign/design/campaign.h>

#include <string>
#include <vector>

namespace argos {

/** Where the files of a campaign's submissions are: beside the results NAME.sqlite. */
struct SSubmissionPaths {
  explicit SSubmissionPaths(const SCampaign& campaign);

  std::string Folder; /**< NAME.slurm: scripts, logs, jobs; absolute */
  std::string Parts; /**< NAME.parts: TASK.sqlite, a database for each task; absolute */
  std::string JobsFile; /**< NAME.slurm/jobs */
};

/** What was queued at once. */
struct SSubmittedJobs {
  UInt32 Number = 0; /**< 1, 2, ...; it is in the names of scripts and logs */
  std::string Runs; /**< number of the array job */
  std::string Merging; /**< id of the job that waits for it; empty if it could not be queued */

  std::vector<std::string> List() const;
};

/** @return the submissions in the order of their numbers. @throws CARGoSException */
std::vector<SSubmittedJobs> ReadJobs(const SSubmissionPaths& paths);
/** Replaces the one with the same number, or adds one. @throws CARGoSException */
void WriteJobs(const SSubmissionPaths& paths, const SSubmittedJobs& jobs);

/** @return the paths of the parts that are there, sorted. */
std::vector<std::string> ListParts(const SSubmissionPaths& paths);

/** Replaces a text file at once. @throws CARGoSException */
void WriteTextFile(const std::string& path, const std::string& text);

}  // namespace argos

#endif
