#ifndef ARGOS3_CAMPAIGN_EXECUTION_EXPERIMENT_PATHS_H
#define ARGOS3_CAMPAIGN_EXECUTION_EXPERIMENT_PATHS_H

#include <argos3/campaign/design/campaign.h>
#include <argos3/campaign/execution/run_request.h>

#include <argos3/core/utility/configuration/configuration_document.h>

#include <set>
#include <string>
#include <vector>

namespace argos {

/**
 * Makes the paths of input files absolute, since a run has a working directory of its own: the
 * attributes `library`, `path` and `script` whose value is a relative path of a file in
 * @p startFolder. Other values stay.
 */
void MakeInputPathsAbsolute(CConfigurationDocument& document, const std::string& startFolder);
/**
 * Reads the experiment of a campaign's runs: with its constants, with the number of threads of the
 * campaign where the experiment has one, and with absolute paths of input files.
 * @throws CARGoSException if it is no XML, or a constant matches nothing.
 */
void ParseExperiment(const SRunSetup& setup, CConfigurationDocument& document);

/** @return @p path, absolute under the same conditions. */
std::string MakeInputPathAbsolute(const std::string& path, const std::string& startFolder);
/** @return the value of a setting, absolute under the same conditions. */
std::string MakeInputPathAbsolute(const SSetting& setting, const std::string& startFolder);

/** @return the values of all attributes `library`, each once, in the order of the file. */
std::vector<std::string> ListLibraries(CConfigurationDocument& document);

/** @return the labels of plug-ins that the elements of an experiment name, and other words. */
std::set<std::string> ListPluginLabels(CConfigurationDocument& document);

/** Makes the relative folders of ARGOS_PLUGIN_PATH absolute. */
void MakePluginPathAbsolute();

}  // namespace argos

#endif
