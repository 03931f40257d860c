#include <argos3/campaign/report/campaign_report.h>

#include <argos3/campaign/report/comparisons.h>
#include <argos3/campaign/report/figure_drawing.h>
#include <argos3/campaign/report/html_page.h>
#include <argos3/campaign/report/report_data.h>
#include <argos3/campaign/report/report_files.h>
#include <argos3/campaign/report/summary_tables.h>

#include <filesystem>

namespace argos {

SReportFiles WriteReport(const SCampaign& campaign, const CResultStore& store,
                         const std::string& folder) {
  const CReportData data(campaign, store);
  const std::filesystem::path path(folder);
  const std::vector<SFigureRequest> requests = ListFigureRequests(data);
  CreateReportFolder(path / "tables");
  WriteReportFile(path / "tables" / "summary.csv", MakeSummaryCSV(data));
  const std::vector<SComparisonTable> comparisons = CompareAll(data);
  if (!comparisons.empty()) {
    WriteReportFile(path / "tables" / "comparisons.csv", MakeComparisonCSV(comparisons));
  }
  const std::vector<SDrawnFigure> figures =
      DrawFigures(data, requests, (path / "figures").string());

  SReportFiles files;
  files.Page = (path / "report.html").string();
  WriteReportFile(files.Page, MakePage(data, comparisons, figures));
  for (const SDrawnFigure& figure : figures) {
    if (figure.Problem.empty()) {
      ++files.NumFigures;
    } else {
      files.Problems.push_back("figure " + figure.Name + ": " + figure.Problem);
    }
  }
  for (const SComparisonTable& table : comparisons) {
    if (!table.Problem.empty()) {
      files.Problems.push_back("comparison of " + table.Request.Metric + " by " +
                               table.Request.Factor + ": " + table.Problem);
    }
  }
  return files;
}

}  // namespace argos
