#ifndef ARGOS3_CAMPAIGN_DESIGN_SETTING_CHECKS_H
#define ARGOS3_CAMPAIGN_DESIGN_SETTING_CHECKS_H

// private: the settings of a campaign against its experiment

#include <argos3/campaign/design/factor_reader.h>
#include <argos3/core/simulator/context/load_errors.h>

#include <set>
#include <string>
#include <vector>

namespace argos {

/**
 * Sets the constants of a campaign in its experiment.
 * @param text  the experiment as it is in the file; changed only if there are constants.
 */
void ApplyConstants(CLoadErrors& errors, const std::string& experimentFile,
                    const std::vector<SLocatedSetting>& constants, std::string& text);

/**
 * Checks that each path of factors and constants matches something other than the seed, which each
 * run has from <runs>, and the visualization, which it has not, and that no attribute is set twice
 * in one combination: by two factors, by a factor and a constant, or twice by one of them.
 * Attributes are compared, not the texts of paths.
 * @return the paths that lead to the number of threads.
 */
std::set<std::string> CheckSettings(CLoadErrors& errors, const std::string& experimentFile,
                                    const std::string& text,
                                    const std::vector<SLocatedSetting>& constants,
                                    const SDesignSource& design);

}  // namespace argos

#endif
