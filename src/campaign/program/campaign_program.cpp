#include <argos3/campaign/program/campaign_program.h>

#include <argos3/campaign/program/command_options.h>
#include <argos3/campaign/program/commands.h>
#include <argos3/campaign/store/failed_runs.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/errors/line_marks.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/program/catalogue/version_text.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace argos {

namespace {

constexpr char kDescription[] =
    "Runs an experiment over factors and seeds, and keeps the results in one database.";

constexpr char kFooter[] = R"(
Examples:
  argos3-campaign run foraging.xml            run what the campaign file foraging.xml describes
  argos3-campaign run foraging.xml --dry-run  list its combinations and the number of runs
  argos3-campaign run foraging.xml --jobs 4 --seeds 1:20
                                              four runs at a time, other seeds than in the file
  argos3-campaign resume foraging.xml         go on after Ctrl-C, a crash or a power cut
  argos3-campaign status foraging.xml         how many runs are done, and which have failed
  argos3-campaign live                        which runs can be watched in a browser, and where
  argos3-campaign retry foraging.xml --status crashed,timeout
                                              repeat failed runs
  argos3-campaign export foraging.xml --csv tables
                                              write the results as tables
  argos3-campaign report foraging.xml -o report
                                              make statistics, figures and a page of them
  argos3-campaign report foraging.xml --plot boxplot --y delivered --x robots -o delivered.svg
                                              draw one figure
  argos3-campaign submit foraging.xml         run it on a cluster, by Slurm

argos3-campaign COMMAND --help describes the options of a command; campaign files are described in
doc/campaigns.md.

Exit status: 0 if all runs are done, 3 if some have failed, 1 after an error, 128 + number if stopped
by SIGINT, SIGTERM, SIGHUP, SIGUSR1 or SIGUSR2: runs that had begun are finished and stored then; a second signal kills them.
)";

bool IsOption(const std::string& argument) {
  return argument.size() > 1 && argument[0] == '-';
}

std::vector<std::string> ListCommands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands(nullptr)) {
    // those for scripts are in no group
    if (!command->get_group().empty()) {
      names.push_back(command->get_name());
    }
  }
  return names;
}

// @throws CARGoSException if the first argument is neither a command nor an option
void CheckCommand(const CLI::App& app, const std::string& name) {
  const auto isNamed = [&name](const CLI::App* command) { return command->get_name() == name; };
  if (IsOption(name) || !app.get_subcommands(isNamed).empty()) {
    return;
  }
  std::error_code ignored;
  if (std::filesystem::is_regular_file(name, ignored)) {
    const std::string file = QuoteForShell(name);
    THROW_ARGOSEXCEPTION("a command is missing before the file, such as `argos3-campaign run "
                         << file << "` or `argos3-campaign report " << file << '`');
  }
  THROW_ARGOSEXCEPTION("there is no command \"" << name << '"'
                                                << DidYouMean(name, ListCommands(app)));
}

// @throws CARGoSException with similar names if an argument is an unknown option
void CheckOptions(const CLI::App& app, const std::vector<std::string>& arguments) {
  for (const CLI::App* command : app.get_subcommands()) {
    std::vector<std::string> known;
    for (const CLI::Option* option : command->get_options()) {
      for (const std::string& name : option->get_lnames()) {
        known.push_back("--" + name);
      }
    }
    for (const std::string& argument : arguments) {
      const std::string name = argument.substr(0, argument.find('='));
      if (name.rfind("--", 0) == 0 && std::find(known.begin(), known.end(), name) == known.end()) {
        THROW_ARGOSEXCEPTION("the command " << command->get_name() << " has no option \"" << name
                                            << '"' << DidYouMean(name, known));
      }
    }
  }
}

int Act(int argc, const char* const* argv) {
  CLI::App app(kDescription, "argos3-campaign");
  app.require_subcommand(1);
  app.add_flag_callback(
      "--version",
      [] {
        std::fputs(DescribeVersion().c_str(), stdout);
        throw CLI::Success();
      },
      "print the version, the commit and the compiler");
  TCampaignCommand chosen;
  AddRunCommands(app, chosen);
  AddStatusCommand(app, chosen);
  AddRetryCommand(app, chosen);
  AddLiveCommand(app, chosen);
  AddExportCommand(app, chosen);
  AddReportCommand(app, chosen);
  AddSubmitCommand(app, chosen);
  AddMergeCommand(app, chosen);
  AddShareCommand(app, chosen);
  // the commands above would have it, too
  app.footer(kFooter);
  if (argc < 2) {
    std::fputs(app.help().c_str(), stderr);
    return CAMPAIGN_ERROR;
  }
  CheckCommand(app, argv[1]);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError& error) {
    CheckOptions(app, {argv + 1, argv + argc});
    app.exit(error);
    return CAMPAIGN_ERROR;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? CAMPAIGN_DONE : CAMPAIGN_ERROR;
  }
  return chosen();
}

}  // namespace

int RunCampaignProgram(int argc, const char* const* argv) noexcept {
  try {
    return Act(argc, argv);
  } catch (...) {
    std::fprintf(stderr, "%s\n", MarkLines(DescribeCurrentException()).c_str());
    return CAMPAIGN_ERROR;
  }
}

}  // namespace argos
