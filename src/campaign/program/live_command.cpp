#include <argos3/campaign/program/command_options.h>
#include <argos3/campaign/program/commands.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/support/live_runs.h>

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace argos {

namespace {

void PrintRuns(const std::vector<SLiveRunEntry>& runs) {
  if (runs.empty()) {
    fmt::print(
        "no run on this computer can be watched; `argos3 --live-socket` and "
        "`argos3-campaign run --live-socket` start such runs\n");
  }
  for (size_t i = 0; i < runs.size(); ++i) {
    const SLiveRunEntry& run = runs[i];
    fmt::print("{}: {} seed={} process={} {}\n", i + 1,
               std::filesystem::path(run.Experiment).filename().string(), run.Seed, run.Process,
               run.URL);
  }
}

// @param number  from 1 on
int Open(const std::vector<SLiveRunEntry>& runs, size_t number) {
  if (number == 0 || number > runs.size()) {
    THROW_ARGOSEXCEPTION("there is no run " << number << ": `argos3-campaign live` lists "
                                            << runs.size());
  }
  const std::string& url = runs[number - 1].URL;
  fmt::print("{}\n", url);
  if (!OpenInBrowser(url)) {
    fmt::print(stderr, "[WARNING] there is no display here: open the URL in a browser\n");
  }
  return CAMPAIGN_DONE;
}

// @param number  of the run to open; none: the runs are listed.
int ListOrOpen(const std::optional<size_t>& number) {
  const std::vector<SLiveRunEntry> runs = ListLiveRuns();
  if (number) {
    return Open(runs, *number);
  }
  PrintRuns(runs);
  return CAMPAIGN_DONE;
}

}  // namespace

void AddLiveCommand(CLI::App& app, TCampaignCommand& chosen) {
  CLI::App& command = *app.add_subcommand(
      "live", "list your runs on this computer that can be watched in a browser, with their URLs");
  const auto number = std::make_shared<std::optional<size_t>>();
  command.add_option("--open", *number, "open the run with this number of the list")
      ->type_name("N");
  RunIfChosen(command, chosen, [number] { return ListOrOpen(*number); });
}

}  // namespace argos
