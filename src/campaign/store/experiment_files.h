#ifndef ARGOS3_CAMPAIGN_STORE_EXPERIMENT_FILES_H
#define ARGOS3_CAMPAIGN_STORE_EXPERIMENT_FILES_H

#include <string>
#include <vector>

namespace argos {

/**
 * Describes the libraries and scripts that an experiment names, and @p furtherFiles: a line "name
 * size digest" for each that is found, in the order of the file. Names are searched as for runs: in
 * ARGOS_PLUGIN_PATH, then in the current folder; also beside the experiment.
 */
std::string DescribeExperimentFiles(const std::string& experimentText,
                                    const std::string& experimentFile,
                                    const std::vector<std::string>& furtherFiles);

/** @return the names whose lines differ, separated by ", "; empty if there is none. */
std::string ListChangedFiles(const std::string& before, const std::string& now);

/** 16 hexadecimal digits. */
std::string ComputeTextDigest(const std::string& text);

/**
 * The first line in which two texts differ: 'line 12: "..." instead of "..."'; empty if they are
 * equal.
 */
std::string DescribeFirstDifference(const std::string& before, const std::string& now);

}  // namespace argos

#endif
