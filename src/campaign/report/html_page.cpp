#include <argos3/campaign/report/html_page.h>

#include <argos3/campaign/report/page_parts.h>
#include <argos3/campaign/report/report_text.h>
#include <argos3/core/config.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace argos {

namespace {

std::string MakeFigureSection(const std::vector<SDrawnFigure>& figures) {
  if (figures.empty()) {
    return "";
  }
  std::string text = "<h2>Figures</h2>\n";
  size_t number = 0;
  for (const SDrawnFigure& figure : figures) {
    ++number;
    if (figure.SVG.empty()) {
      text += fmt::format("<p class=\"notice\">Figure {} ({}) was not drawn: {}.</p>\n", number,
                          EscapeHTML(figure.Name), EscapeHTML(figure.Problem));
      continue;
    }
    text += fmt::format(
        "<figure id=\"figure{0}\" class=\"{4}\">\n{1}\n<figcaption><b>Figure {0}.</b> {2} Files: "
        "figures/{3}.svg, "
        ".png, .dat, .gp</figcaption>\n</figure>\n",
        number, figure.SVG, EscapeHTML(figure.Caption), EscapeHTML(figure.Name),
        EscapeHTML(figure.Kind));
  }
  return text;
}

constexpr const char* kMethods = R"(<h2>Methods</h2>
<p class="quiet">Quartiles are those of definition 7 of Hyndman and Fan (1996), as in R. Intervals of
means are Student's t intervals and BCa bootstrap intervals (9999 resamples); intervals of success
rates are Wilson's. Shifts are Hodges and Lehmann's estimates with intervals that belong to Wilcoxon's
tests. Tests have two sides; with several pairs of levels, p values are adjusted by Holm's method and
intervals are not. A difference is reported if p is below 0.05: with few runs, no difference found does
not mean that there is none.</p>
)";

// none of a text that is no number, or one with an exponent
std::optional<size_t> FindDecimals(const std::string& cell) {
  const size_t first = cell.rfind('-', 0) == 0 ? 1 : 0;
  const size_t point = std::min(cell.find('.'), cell.size());
  const bool isNumber = point > first &&
                        cell.find_first_not_of("0123456789.", first) == std::string::npos &&
                        cell.find('.', point + 1) == std::string::npos;
  return isNumber ? std::optional(point == cell.size() ? 0 : cell.size() - point - 1)
                  : std::nullopt;
}

// spaces as wide as the point and the digits that a number has less than others of its column
std::string MakePadding(const std::string& cell, size_t wanted) {
  constexpr const char* kPoint = "\u2008";
  constexpr const char* kDigit = "\u2007";
  const std::optional<size_t> found = FindDecimals(cell);
  if (!found || *found >= wanted) {
    return "";
  }
  std::string padding = *found == 0 ? kPoint : "";
  for (size_t i = *found; i < wanted; ++i) {
    padding += kDigit;
  }
  return padding;
}

}  // namespace

CHTMLTable::CHTMLTable(const std::vector<std::string>& titles, size_t numTextColumns)
    : m_titles(titles), m_numTextColumns(numTextColumns) {}

void CHTMLTable::AddRow(const std::vector<std::string>& cells) {
  m_rows.push_back({cells, ""});
}

void CHTMLTable::AddNote(const std::vector<std::string>& cells, const std::string& note) {
  m_rows.push_back({cells, note});
}

std::vector<size_t> CHTMLTable::CountDecimals() const {
  std::vector<size_t> numbers(m_titles.size());
  for (const SRow& row : m_rows) {
    for (size_t i = m_numTextColumns; i < row.Cells.size(); ++i) {
      numbers[i] = std::max(numbers[i], FindDecimals(row.Cells[i]).value_or(0));
    }
  }
  return numbers;
}

std::string CHTMLTable::ToText() const {
  std::string text = "<div class=\"wide\"><table>\n<thead><tr>";
  for (size_t i = 0; i < m_titles.size(); ++i) {
    text += fmt::format("<th{}>{}</th>", i < m_numTextColumns ? " class=\"text\"" : "",
                        EscapeHTML(m_titles[i]));
  }
  text += "</tr></thead>\n<tbody>\n";
  const std::vector<size_t> decimals = CountDecimals();
  for (const SRow& row : m_rows) {
    text += "<tr>";
    for (size_t i = 0; i < row.Cells.size(); ++i) {
      text += i < m_numTextColumns ? "<td class=\"text\">" + EscapeHTML(row.Cells[i]) + "</td>"
                                   : "<td>" + EscapeHTML(row.Cells[i]) +
                                         MakePadding(row.Cells[i], decimals[i]) + "</td>";
    }
    if (!row.Note.empty()) {
      text += fmt::format("<td class=\"note\" colspan=\"{}\">{}</td>",
                          m_titles.size() - row.Cells.size(), EscapeHTML(row.Note));
    }
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

std::string MakePage(const CReportData& data, const std::vector<SComparisonTable>& comparisons,
                     const std::vector<SDrawnFigure>& figures) {
  const SCampaign& campaign = data.GetCampaign();
  const std::string name =
      EscapeHTML(campaign.Title.empty() ? std::filesystem::path(campaign.File).stem().string()
                                        : campaign.Title);
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\" />\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\" />\n"
      "<title>" +
      name + "</title>\n<style>" + kPageStyle + "</style>\n</head>\n<body>\n";
  page += "<header>\n<h1>" + name + "</h1>\n" + MakeOverview(data) + "</header>\n<main>\n";
  page += MakeFigureSection(figures);
  page += MakeComparisonSection(comparisons);
  page += MakeMetricTables(data);
  page += MakeSuccessTable(data);
  page += MakeFailedRuns(data);
  page += MakeSetUp(data);
  page += MakeMachines(data);
  page += kMethods;
  page += "</main>\n<footer><p>argos3-campaign " ARGOS_VERSION "-" ARGOS_RELEASE
          "</p></footer>\n</body>\n</html>\n";
  return page;
}

}  // namespace argos
