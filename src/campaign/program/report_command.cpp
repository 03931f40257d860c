#include <argos3/campaign/design/figure_kinds.h>
#include <argos3/campaign/program/command_options.h>
#include <argos3/campaign/program/commands.h>
#include <argos3/campaign/report/campaign_report.h>
#include <argos3/campaign/report/figure_drawing.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/lists.h>

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

namespace argos {

namespace {

struct SReportOptions {
  std::string File;
  std::string Output; /**< folder of the report, or file of a figure */
  SFigureRequest Figure; /**< Kind: empty for a report */
};

void RefuseFigureOptions(const SFigureRequest& figure) {
  if (!figure.X.empty() || !figure.Y.empty() || !figure.Z.empty() || !figure.Group.empty() ||
      !figure.Title.empty() || !figure.Where.empty() || figure.IsLogarithmic ||
      figure.IsXLogarithmic || figure.Reference || figure.ShowsInterval ||
      figure.EndedRuns != EEndedRuns::Survivors) {
    THROW_ARGOSEXCEPTION(
        "--x, --y, --z, --group, --title, --where, --band, --ended, --log, --xlog and --reference "
        "describe one figure: give --plot KIND, too");
  }
}

std::vector<std::string_view> ListKindsWith(std::string_view look) {
  std::vector<std::string_view> kinds;
  for (const SFigureKind& kind : kFigureKinds) {
    if (look.empty() || kind.HasLook(look)) {
      kinds.push_back(kind.Name);
    }
  }
  return kinds;
}

// options: "--xlog belongs"; look: the attribute of a campaign file that says the same
void RequireLook(const SFigureRequest& figure, const std::string& options, std::string_view look) {
  std::vector<std::string_view> kinds = ListKindsWith(look);
  if (std::find(kinds.begin(), kinds.end(), figure.Kind) != kinds.end()) {
    return;
  }
  const std::string_view last = kinds.back();
  kinds.pop_back();
  THROW_ARGOSEXCEPTION(options << " to --plot " << JoinItems(kinds)
                               << (kinds.empty() ? "" : " and ") << last);
}

void CheckLooks(const SFigureRequest& figure) {
  if (figure.Reference) {
    RequireLook(figure, "--reference belongs", "reference");
  }
  if (figure.IsXLogarithmic) {
    RequireLook(figure, "--xlog belongs", "xscale");
  }
  if (figure.IsLogarithmic && figure.Kind == "difference") {
    THROW_ARGOSEXCEPTION(
        "--log: a difference may be negative, and a logarithmic axis shows no "
        "such value");
  }
  if (figure.ShowsInterval || figure.EndedRuns != EEndedRuns::Survivors) {
    RequireLook(figure, "--band and --ended belong", "band");
  }
}

int MakeReport(const SReportOptions& options) {
  const SCampaign campaign = ReadCampaign(options.File);
  ThrowUnlessHasResults(campaign);
  const CResultStore store(campaign.ResultsFile, CResultStore::EMode::ReadOnly);
  if (!options.Figure.Kind.empty()) {
    if (options.Output.empty()) {
      THROW_ARGOSEXCEPTION("--plot needs -o FILE.svg, FILE.png or FILE.pdf");
    }
    const SFigureRequest& figure = options.Figure;
    CheckLooks(figure);
    DrawFigure(CReportData(campaign, store), figure, options.Output);
    return CAMPAIGN_DONE;
  }
  RefuseFigureOptions(options.Figure);
  const std::string folder =
      options.Output.empty()
          ? std::filesystem::path(campaign.File).replace_extension("report").string()
          : options.Output;
  const SReportFiles files = WriteReport(campaign, store, folder);
  for (const std::string& problem : files.Problems) {
    PrintWarnings(problem);
  }
  fmt::print("{} ({} figure{})\n", files.Page, files.NumFigures, files.NumFigures == 1 ? "" : "s");
  return CAMPAIGN_DONE;
}

}  // namespace

void AddReportCommand(CLI::App& app, TCampaignCommand& chosen) {
  CLI::App& command = *app.add_subcommand(
      "report", "make statistics, comparisons and figures, and a page that shows them");
  const auto options = std::make_shared<SReportOptions>();
  SFigureRequest& figure = options->Figure;
  AddFile(command, options->File);
  command
      .add_option(
          "-o,--output", options->Output,
          "folder of the report, default: NAME.report beside the campaign file; with --plot "
          "the file of the figure, whose ending .svg, .png or .pdf is the format")
      ->type_name("PATH");
  command
      .add_option("--plot", figure.Kind, "draw one figure only: " + JoinItems(ListKindsWith("")))
      ->type_name("KIND");
  command.add_option("--x", figure.X, "factor; of means and scaling also a metric")
      ->type_name("NAME");
  command.add_option("--y", figure.Y, "metric; of series a time series; of heatmap a factor")
      ->type_name("NAME");
  command.add_option("--z", figure.Z, "metric of a heatmap")->type_name("NAME");
  command.add_option("--group", figure.Group, "factor whose levels differ in colour")
      ->type_name("FACTOR");
  command.add_option("--title", figure.Title, "title of the figure")->type_name("TEXT");
  command
      .add_option("--where", figure.Where,
                  "of those combinations only for which this Lua expression of the factors is true")
      ->type_name("EXPRESSION");
  command
      .add_option_function<std::string>(
          "--band",
          [&figure](const std::string& band) { figure.ShowsInterval = band == "interval"; },
          "of series: quartiles around medians (default), or interval: 95 % intervals of means")
      ->type_name("KIND")
      ->check(CLI::IsMember({"quartiles", "interval"}));
  command
      .add_option_function<std::string>(
          "--ended",
          [&figure](const std::string& rule) { figure.EndedRuns = ParseEndedRuns(rule); },
          "of series, runs that end before others: survivors (default) do not count them any more, "
          "hold keeps their last value, drop leaves out the times after the first end")
      ->type_name("RULE")
      ->check(CLI::IsMember({"survivors", "hold", "drop"}));
  command.add_flag("--xlog", figure.IsXLogarithmic,
                   "logarithmic axis of x, of means, or of time, of series and difference");
  command.add_option("--reference", figure.Reference, "height of a dashed line, of means")
      ->type_name("NUMBER");
  command.add_flag("--log", figure.IsLogarithmic, "logarithmic axis of the metric");
  RunIfChosen(command, chosen, [options] { return MakeReport(*options); });
}

}  // namespace argos
