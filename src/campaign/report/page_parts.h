#ifndef ARGOS3_CAMPAIGN_REPORT_PAGE_PARTS_H
#define ARGOS3_CAMPAIGN_REPORT_PAGE_PARTS_H

// private: sections of the page

#include <argos3/campaign/report/html_page.h>

#include <string>
#include <vector>

namespace argos {

/** A table of a page; all texts are escaped, and the points of numbers in a column are aligned. */
class CHTMLTable {
 public:
  /** @param numTextColumns  the first ones are aligned to the left. */
  CHTMLTable(const std::vector<std::string>& titles, size_t numTextColumns);

  void AddRow(const std::vector<std::string>& cells);
  /** A row with a text over the columns after the first ones. */
  void AddNote(const std::vector<std::string>& cells, const std::string& note);
  std::string ToText() const;

 private:
  struct SRow {
    std::vector<std::string> Cells;
    std::string Note;
  };

  /** Digits behind the point of each column, at most. */
  std::vector<size_t> CountDecimals() const;

  std::vector<std::string> m_titles;
  size_t m_numTextColumns;
  std::vector<SRow> m_rows;
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
