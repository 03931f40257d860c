#ifndef ARGOS3_CAMPAIGN_REPORT_EQUAL_LEVELS_H
#define ARGOS3_CAMPAIGN_REPORT_EQUAL_LEVELS_H

#include <argos3/campaign/report/report_data.h>

#include <string>
#include <vector>

namespace argos {

/**
 * Finds factors that may be without effect: levels between which no run differs.
 *
 * Two levels are equal if all runs of the newest generation that are done, and that differ in the
 * level only, not in the seed or in the level of another factor, have equal digests; there must be
 * one pair at least. Factors that set the number of threads are left out, since results do not
 * depend on it, and so are those with more than kMaxComparedLevels levels.
 *
 * @return a warning for each such factor.
 */
std::vector<std::string> WarnOfEqualLevels(const CReportData& data);

}  // namespace argos

#endif
