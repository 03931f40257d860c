#ifndef ARGOS3_CAMPAIGN_REPORT_HTML_PAGE_H
#define ARGOS3_CAMPAIGN_REPORT_HTML_PAGE_H

#include <argos3/campaign/report/comparisons.h>
#include <argos3/campaign/report/figure_drawing.h>
#include <argos3/campaign/report/report_data.h>

#include <string>
#include <vector>

namespace argos {

/**
 * The report as one page that needs no other file: set-up, machines, tables, figures, comparisons
 * and failed runs. The same results give the same page. Users' text is escaped.
 */
std::string MakePage(const CReportData& data, const std::vector<SComparisonTable>& comparisons,
                     const std::vector<SDrawnFigure>& figures);

}  // namespace argos

#endif
