#ifndef ARGOS3_CAMPAIGN_DESIGN_SECTION_READERS_H
#define ARGOS3_CAMPAIGN_DESIGN_SECTION_READERS_H

// private: the sections of a campaign file but for <factors>

#include <argos3/campaign/design/campaign.h>
#include <argos3/core/simulator/context/load_errors.h>
#include <argos3/core/utility/configuration/argos_configuration.h>

namespace argos {

/** <runs>: Stopping. */
void ReadRuns(TConfigurationNode& node, SCampaign& campaign);
/** <limits>: Limits. */
void ReadLimits(TConfigurationNode& node, SCampaign& campaign);
/** <execution>: Jobs, Isolation, Threads, Kept. */
void ReadExecution(TConfigurationNode& node, SCampaign& campaign);
/** <collect>: Metrics. @return false if a metric could not be read. */
bool ReadCollected(CLoadErrors& errors, TConfigurationNode& node, SCampaign& campaign);
/** Checks Stopping against Metrics. @param location  of <runs>. */
void CheckStopping(const SCampaign& campaign, const std::string& location);

/** <figures>; factors and metrics must be known. */
void ReadFigures(CLoadErrors& errors, TConfigurationNode& node, SCampaign& campaign);
/** <tests>; factors and metrics must be known. */
void ReadTests(CLoadErrors& errors, TConfigurationNode& node, SCampaign& campaign);
/** <slurm>. */
void ReadSlurm(CLoadErrors& errors, TConfigurationNode& node, SCampaign& campaign);

/**
 * @return empty if the name is that of a metric that is collected, or if all are; else why not.
 * @param isSeries  whether it must be a series.
 */
std::string FindMetricProblem(const SCampaign& campaign, const std::string& name, bool isSeries);

}  // namespace argos

#endif
