#ifndef ARGOS3_CAMPAIGN_REPORT_CAMPAIGN_REPORT_H
#define ARGOS3_CAMPAIGN_REPORT_CAMPAIGN_REPORT_H

#include <argos3/campaign/design/campaign.h>
#include <argos3/campaign/store/result_store.h>

#include <string>
#include <vector>

namespace argos {

/** What was written. */
struct SReportFiles {
  std::string Page; /**< path of the HTML file */
  size_t NumFigures = 0; /**< drawn ones */
  std::vector<std::string> Problems; /**< figures and comparisons that could not be made */
};

/**
 * Writes a report of the newest generation into a folder, which is created: report.html;
 * tables/summary.csv and tables/comparisons.csv; figures/NAME.svg, .png, .dat and .gp.
 * @throws CARGoSException if a file cannot be written, or a figure's attribute is wrong.
 */
SReportFiles WriteReport(const SCampaign& campaign, const CResultStore& store,
                         const std::string& folder);

}  // namespace argos

#endif
