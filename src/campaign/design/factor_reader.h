#ifndef ARGOS3_CAMPAIGN_DESIGN_FACTOR_READER_H
#define ARGOS3_CAMPAIGN_DESIGN_FACTOR_READER_H

// private: the section <factors>

#include <argos3/campaign/design/campaign.h>
#include <argos3/campaign/design/factor_values.h>
#include <argos3/core/simulator/context/load_errors.h>
#include <argos3/core/utility/configuration/argos_configuration.h>

#include <string>
#include <vector>

namespace argos {

enum class EDesign { Full, Paired, LatinHypercube };

/** A factor as the file describes it. */
struct SFactorSource {
  SFactor Factor; /**< no levels if it is continuous */
  bool IsContinuous = false; /**< a Latin hypercube takes its values from Range */
  SFactorRange Range;
  std::string Path; /**< path of the attribute that gets the value itself; may be empty */
  std::vector<SSetting> Sets; /**< settings of all levels; <level> elements add their own */
  std::string Location; /**< "file:line: <factor>" */
  /** (levels, settings) "file:line: <tag>"; one row for all levels unless there are <level>s */
  std::vector<std::vector<std::string>> SettingLocations;

  const std::string& LocationOf(size_t level, size_t setting) const {
    return SettingLocations[level < SettingLocations.size() ? level : 0][setting];
  }
  /** A level without settings of its own. */
  SLevel MakeLevel(const std::string& value) const;
};

/** A condition of combinations to be left out. */
struct SExclusion {
  std::string Where; /**< a Lua expression */
  std::string Location;
};

/** The section <factors>. */
struct SDesignSource {
  EDesign Design = EDesign::Full;
  UInt32 Samples = 0; /**< samples of a Latin hypercube */
  UInt32 Seed = 1; /**< the same */
  std::string Location;
  std::vector<SFactorSource> Factors;
  std::vector<SExclusion> Exclusions;
  bool IsComplete = true; /**< false if a factor, or the design, could not be read */
};

/** A setting of the campaign and its place in the file: "file:line: <set>". */
struct SLocatedSetting {
  SSetting Setting;
  std::string Location;
};

/** Reads path and value of an element <set>. */
SLocatedSetting ReadSetting(TConfigurationNode& node);

/** Reads the section; errors are recorded. */
SDesignSource ReadFactors(CLoadErrors& errors, TConfigurationNode& node);

}  // namespace argos

#endif
