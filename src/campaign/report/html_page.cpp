#include <argos3/campaign/report/html_page.h>

#include <argos3/campaign/report/page_parts.h>
#include <argos3/campaign/report/report_text.h>
#include <argos3/core/config.h>

#include <fmt/format.h>

#include <filesystem>

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

}  // namespace

CHTMLTable::CHTMLTable(const std::vector<std::string>& titles, size_t numTextColumns)
    : m_numColumns(titles.size()),
      m_numTextColumns(numTextColumns),
      m_text("<div class=\"wide\"><table>\n<thead><tr>") {
  for (size_t i = 0; i < titles.size(); ++i) {
    m_text += fmt::format("<th{}>{}</th>", i < numTextColumns ? " class=\"text\"" : "",
                          EscapeHTML(titles[i]));
  }
  m_text += "</tr></thead>\n<tbody>\n";
}

void CHTMLTable::Add(const std::vector<std::string>& cells) {
  for (size_t i = 0; i < cells.size(); ++i) {
    m_text += fmt::format("<td{}>{}</td>", i < m_numTextColumns ? " class=\"text\"" : "",
                          EscapeHTML(cells[i]));
  }
}

void CHTMLTable::AddRow(const std::vector<std::string>& cells) {
  m_text += "<tr>";
  Add(cells);
  m_text += "</tr>\n";
}

void CHTMLTable::AddNote(const std::vector<std::string>& cells, const std::string& note) {
  m_text += "<tr>";
  Add(cells);
  m_text += fmt::format("<td class=\"note\" colspan=\"{}\">{}</td></tr>\n",
                        m_numColumns - cells.size(), EscapeHTML(note));
}

std::string CHTMLTable::ToText() const {
  return m_text + "</tbody></table></div>\n";
}

std::string MakePage(const CReportData& data, const std::vector<SComparisonTable>& comparisons,
                     const std::vector<SDrawnFigure>& figures) {
  const std::string name =
      EscapeHTML(std::filesystem::path(data.GetCampaign().File).stem().string());
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
