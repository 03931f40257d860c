#ifndef ARGOS3_CAMPAIGN_REPORT_PAGE_PARTS_H
#define ARGOS3_CAMPAIGN_REPORT_PAGE_PARTS_H

// private: sections of the page

#include <argos3/campaign/report/html_page.h>

#include <string>
#include <vector>

namespace argos {

/** A table of a page; all texts are escaped. */
class CHTMLTable {
 public:
  /** @param numTextColumns  the first ones are aligned to the left. */
  CHTMLTable(const std::vector<std::string>& titles, size_t numTextColumns);

  void AddRow(const std::vector<std::string>& cells);
  /** A row with a text over the columns after the first ones. */
  void AddNote(const std::vector<std::string>& cells, const std::string& note);
  std::string ToText() const;

 private:
  void Add(const std::vector<std::string>& cells);

  size_t m_numColumns;
  size_t m_numTextColumns;
  std::string m_text;
};

/** The style sheet of a page. */
extern const char* const kPageStyle;

std::string MakeOverview(const CReportData& data);
std::string MakeSetUp(const CReportData& data);
std::string MakeMachines(const CReportData& data);
std::string MakeMetricTables(const CReportData& data);
std::string MakeSuccessTable(const CReportData& data);
std::string MakeComparisonSection(const std::vector<SComparisonTable>& tables);
std::string MakeFailedRuns(const CReportData& data);

}  // namespace argos

#endif
