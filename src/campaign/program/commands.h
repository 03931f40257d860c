#ifndef ARGOS3_CAMPAIGN_PROGRAM_COMMANDS_H
#define ARGOS3_CAMPAIGN_PROGRAM_COMMANDS_H

#include <functional>

namespace CLI {
class App;
}

namespace argos {

/** @return the exit status. @throws CARGoSException if the command fails. */
using TCampaignCommand = std::function<int()>;

/**
 * Each adds commands to the program. If the arguments select one of them, @p chosen is set. To add
 * a command, write such a function in a file of its own, and call it in campaign_program.cpp.
 */
void AddRunCommands(CLI::App& app, TCampaignCommand& chosen); /**< run and resume */
void AddStatusCommand(CLI::App& app, TCampaignCommand& chosen);
void AddRetryCommand(CLI::App& app, TCampaignCommand& chosen);
void AddExportCommand(CLI::App& app, TCampaignCommand& chosen);
void AddLiveCommand(CLI::App& app, TCampaignCommand& chosen);
void AddReportCommand(CLI::App& app, TCampaignCommand& chosen);
void AddSubmitCommand(CLI::App& app, TCampaignCommand& chosen);
void AddMergeCommand(CLI::App& app, TCampaignCommand& chosen);
void AddShareCommand(CLI::App& app, TCampaignCommand& chosen);

}  // namespace argos

#endif
