#ifndef ARGOS3_CAMPAIGN_EXECUTION_COLLECTED_COLUMNS_H
#define ARGOS3_CAMPAIGN_EXECUTION_COLLECTED_COLUMNS_H

#include <argos3/campaign/design/campaign.h>
#include <argos3/campaign/execution/run_result.h>

#include <string>
#include <vector>

namespace argos {

/**
 * Adds the metrics that are columns of CSV files, which the run has written to its folder.
 *
 * A file has a line of names, and values separated by commas, semicolons, tabs or blanks; lines
 * that begin with '#' are comments. A pattern has the wildcards of the shell and is relative to
 * the folder; of several files that match, the first by name counts. The metric is the value in
 * the last row; its series has a tick for each value in the column of times, which are whole
 * ticks. A value that is no number is NaN.
 *
 * @throws CARGoSException if no file matches, a column is missing, or a time is no tick.
 */
void CollectColumns(const std::vector<SCollectedMetric>& metrics, const std::string& folder,
                    SRunResult& result);

}  // namespace argos

#endif
