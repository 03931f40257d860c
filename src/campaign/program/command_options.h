#ifndef ARGOS3_CAMPAIGN_PROGRAM_COMMAND_OPTIONS_H
#define ARGOS3_CAMPAIGN_PROGRAM_COMMAND_OPTIONS_H

#include <argos3/campaign/design/campaign.h>
#include <argos3/campaign/program/commands.h>
#include <argos3/campaign/scheduling/campaign_manager.h>
#include <argos3/campaign/store/result_store.h>

#include <string>

namespace argos {

/** Exit statuses of argos3-campaign; a signal has 128 + its number. */
enum ECampaignStatus { CAMPAIGN_DONE = 0, CAMPAIGN_ERROR = 1, CAMPAIGN_RUNS_FAILED = 3 };

/** Options of commands that execute runs. */
struct SExecutionOptions {
  std::string File; /**< path of the campaign */
  UInt32 Jobs =
      0; /**< 0: those of the campaign, or as many as processors that this process may use */
  bool IsQuiet = false;
  bool HasLiveViews = false; /**< of the runs */
};

/** Sets @p chosen to @p run if the arguments select the command. */
void RunIfChosen(CLI::App& command, TCampaignCommand& chosen, const TCampaignCommand& run);

/** Adds the campaign's file, the first argument of all commands. */
void AddFile(CLI::App& command, std::string& file);
void AddExecutionOptions(CLI::App& command, SExecutionOptions& options);

/** Prints a warning for each line of a text. */
void PrintWarnings(const std::string& lines);

/** @return true if the campaign has a database. */
bool HasResults(const SCampaign& campaign);
/** @throws CARGoSException if it has none; the text says how to get one. */
void ThrowUnlessHasResults(const SCampaign& campaign);

/**
 * Executes a plan, and prints what has failed and, if it was stopped, how to resume.
 * @return the exit status.
 */
int ExecutePlan(const SCampaign& campaign, CResultStore& store, CRunPlan& plan, UInt64 known,
                const SExecutionOptions& options);

}  // namespace argos

#endif
