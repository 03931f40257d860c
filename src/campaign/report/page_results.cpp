#include <argos3/campaign/report/page_parts.h>
#include <argos3/campaign/report/report_text.h>
#include <argos3/campaign/report/summary_tables.h>
#include <argos3/campaign/store/failed_runs.h>

#include <fmt/format.h>

namespace argos {

namespace {

std::string FormatInterval(const std::optional<SConfidenceInterval>& interval) {
  return interval ? FormatRange(interval->Lower, interval->Upper) : "-";
}

std::string MakeMetricTable(const CReportData& data, const std::string& metric) {
  const SCampaign& campaign = data.GetCampaign();
  std::vector<std::string> titles = campaign.ListFactors();
  for (const char* title : {"n", "missing", "mean", "sd", "median", "quartiles",
                            "95 % t interval of the mean", "95 % BCa interval of the mean"}) {
    titles.emplace_back(title);
  }
  CHTMLTable table(titles, campaign.Factors.size());
  for (const SSummaryRow& row : SummarizeMetric(data, metric)) {
    std::vector<std::string> cells = campaign.Combinations[row.Combination].Values;
    if (!row.Problem.empty()) {
      table.AddNote(cells, row.Problem);
      continue;
    }
    const SSampleSummary& summary = row.Summary;
    for (const std::string& cell :
         {std::to_string(summary.Count), std::to_string(summary.NumMissing),
          FormatNumber(summary.Mean), FormatNumber(summary.StandardDeviation),
          FormatNumber(summary.Median), FormatRange(summary.LowerQuartile, summary.UpperQuartile),
          FormatInterval(row.MeanInterval), FormatInterval(row.BootstrapInterval)}) {
      cells.push_back(cell);
    }
    table.AddRow(cells);
  }
  return "<h3>" + EscapeHTML(MakeLabel(metric, data.GetStore().GetUnit(metric, false))) +
         "</h3>\n" + table.ToText();
}

std::string MakePairTable(const SComparisonTable& table, const SComparisonResult& result) {
  CHTMLTable pairs({"levels of " + table.Request.Factor, "n", "shift", "interval", "level", "p"},
                   1);
  for (const SPairComparison& pair : result.Pairs) {
    pairs.AddRow(
        {pair.First + ", " + pair.Second, fmt::format("{}, {}", pair.FirstCount, pair.SecondCount),
         FormatNumber(pair.Estimate), FormatRange(pair.Interval.Lower, pair.Interval.Upper),
         FormatLevel(pair.Interval.Level), FormatNumber(pair.PValue)});
  }
  return "<details><summary>All pairs</summary>\n" + pairs.ToText() + "</details>\n";
}

std::string MakeResultText(const SComparisonTable& table, const SComparisonResult& result) {
  std::string text;
  if (!result.Context.empty()) {
    text += "<p><b>" + EscapeHTML(result.Context) + "</b></p>\n";
  }
  text += "<p>" + EscapeHTML(DescribeResult(table, result)) + "</p>\n";
  if (!result.Problem.empty()) {
    return text;
  }
  text += "<ul>\n";
  for (const SPairComparison& pair : result.Pairs) {
    text += "<li>" + EscapeHTML(DescribePair(table, pair)) + "</li>\n";
  }
  text += "</ul>\n";
  if (result.NumMissing > 0) {
    text += fmt::format(
        "<p class=\"quiet\">{} left out: {}.</p>\n",
        Count(result.NumMissing, table.Request.IsPaired ? "seed" : "run"),
        table.Request.IsPaired ? "without a value at every level" : "without the value");
  }
  return text + MakePairTable(table, result);
}

std::string MakeFailedRun(const CReportData& data, const SStoredRun& listed) {
  const SCampaign& campaign = data.GetCampaign();
  const SStoredRun run = data.GetStore().FindRun(listed.Id).value_or(listed);
  const size_t combination = data.GetCombination(run);
  const std::string levels = data.DescribeCombination(combination);
  const SRunResult& result = run.Result;
  std::string how;
  if (result.Signal != 0) {
    how = fmt::format(", signal {}", result.Signal);
  } else if (result.Status == ERunStatus::Failed) {
    how = fmt::format(", exit status {}", result.ExitStatus);
  }
  std::string text = fmt::format("<h3>{}seed {}: <span class=\"status\">{}{}</span></h3>\n",
                                 EscapeHTML(levels.empty() ? "" : levels + ", "), run.Seed,
                                 ToText(result.Status), how);
  const std::string message = FindErrorMessage(result.Log);
  text += message.empty() ? "" : "<p>" + EscapeHTML(message) + "</p>\n";
  text += "<pre>" +
          EscapeHTML(MakeRepeatCommand(campaign, campaign.Combinations[combination], run.Seed)) +
          "</pre>\n";
  if (!result.Log.empty()) {
    text += fmt::format(
        "<details><summary>End of the output ({} bytes in all)</summary>\n<pre>{}"
        "</pre></details>\n",
        result.LogBytes, EscapeHTML(result.Log));
  }
  return text;
}

}  // namespace

std::string MakeMetricTables(const CReportData& data) {
  std::string text = "<h2>Metrics</h2>\n";
  const std::vector<std::string> metrics = data.GetStore().ListMetrics();
  if (metrics.empty()) {
    return text + "<p>No run has recorded a metric.</p>\n";
  }
  text +=
      "<p class=\"quiet\">Of runs that are done; missing: the run has not recorded the "
      "metric.</p>\n";
  for (const std::string& metric : metrics) {
    text += MakeMetricTable(data, metric);
  }
  return text;
}

std::string MakeSuccessTable(const CReportData& data) {
  const SCampaign& campaign = data.GetCampaign();
  std::vector<std::string> titles = campaign.ListFactors();
  for (const char* title : {"runs", "done", "success rate", "95 % Wilson interval"}) {
    titles.emplace_back(title);
  }
  CHTMLTable table(titles, campaign.Factors.size());
  for (const SRateRow& row : ComputeSuccessRates(data)) {
    std::vector<std::string> cells = campaign.Combinations[row.Combination].Values;
    cells.push_back(std::to_string(row.NumRuns));
    cells.push_back(std::to_string(row.NumDone));
    cells.push_back(row.NumRuns == 0 ? "-"
                                     : FormatNumber(static_cast<Real>(row.NumDone) /
                                                    static_cast<Real>(row.NumRuns)));
    cells.push_back(FormatInterval(row.Interval));
    table.AddRow(cells);
  }
  return "<h2>Success</h2>\n" + table.ToText();
}

std::string MakeComparisonSection(const std::vector<SComparisonTable>& tables) {
  std::string text = tables.empty() ? "" : "<h2>Comparisons</h2>\n";
  for (const SComparisonTable& table : tables) {
    text += fmt::format("<h3>{} by {}{}</h3>\n", EscapeHTML(MakeLabel(table.Request.Metric, "")),
                        EscapeHTML(table.Request.Factor),
                        table.Request.IsPaired ? ", paired by seed" : "");
    if (!table.Problem.empty()) {
      text += "<p class=\"notice\">Not compared: " + EscapeHTML(table.Problem) + ".</p>\n";
    }
    for (const SComparisonResult& result : table.Results) {
      text += MakeResultText(table, result);
    }
  }
  return text;
}

std::string MakeFailedRuns(const CReportData& data) {
  constexpr size_t kMaxRuns = 50;
  std::string text;
  size_t count = 0;
  for (const SStoredRun& run : data.GetRuns()) {
    if (run.Result.Status != ERunStatus::Done && ++count <= kMaxRuns) {
      text += MakeFailedRun(data, run);
    }
  }
  if (count == 0) {
    return "";
  }
  if (count > kMaxRuns) {
    text +=
        fmt::format("<p>And {} more; argos3-campaign export lists all.</p>\n", count - kMaxRuns);
  }
  return "<h2>Failed runs</h2>\n" + text;
}

}  // namespace argos
