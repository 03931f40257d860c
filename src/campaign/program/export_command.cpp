#include <argos3/campaign/program/command_options.h>
#include <argos3/campaign/program/commands.h>
#include <argos3/campaign/store/result_export.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <CLI/CLI.hpp>

#include <memory>

namespace argos {

namespace {

struct SExportOptions {
  std::string File;
  std::string CSVFolder;
  std::string JSONFile;
};

int Export(const SExportOptions& options) {
  const SCampaign campaign = ReadCampaign(options.File);
  ThrowUnlessHasResults(campaign);
  if (options.CSVFolder.empty() && options.JSONFile.empty()) {
    THROW_ARGOSEXCEPTION("nothing to export: give --csv FOLDER, --json FILE, or both");
  }
  const CResultStore store(campaign.ResultsFile, CResultStore::EMode::ReadOnly);
  if (!options.CSVFolder.empty()) {
    ExportCSV(store, options.CSVFolder);
  }
  if (!options.JSONFile.empty()) {
    ExportJSON(store, options.JSONFile);
  }
  return CAMPAIGN_DONE;
}

}  // namespace

void AddExportCommand(CLI::App& app, TCampaignCommand& chosen) {
  CLI::App& command = *app.add_subcommand("export", "write the results for other programs");
  const auto options = std::make_shared<SExportOptions>();
  AddFile(command, options->File);
  command.add_option("--csv", options->CSVFolder, "tables: runs.csv, and a file for each series")
      ->type_name("FOLDER");
  command.add_option("--json", options->JSONFile, "one JSON object")->type_name("FILE");
  RunIfChosen(command, chosen, [options] { return Export(*options); });
}

}  // namespace argos
