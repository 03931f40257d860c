#include <argos3/campaign/design/setting_checks.h>

#include <argos3/campaign/design/element_reading.h>
#include <argos3/core/utility/configuration/configuration_document.h>

#include <map>
#include <set>

namespace argos {

namespace {

// an owner of settings: a factor, or the constants
constexpr int kConstants = -1;

/** A path and where it is used. */
struct SUse {
  int Owner = kConstants;
  size_t Level = 0;  // level of a factor
  std::string Location;
};

/** Paths with their uses, in the order of the file. */
struct SPaths {
  std::vector<std::string> Paths;
  std::map<std::string, std::vector<SUse>> Uses;

  void Add(const std::string& path, const SUse& use) {
    std::vector<SUse>& uses = Uses[path];
    if (uses.empty()) {
      Paths.push_back(path);
    }
    uses.push_back(use);
  }
};

SPaths CollectPaths(const std::vector<SLocatedSetting>& constants, const SDesignSource& design) {
  SPaths paths;
  for (const SLocatedSetting& constant : constants) {
    paths.Add(constant.Setting.Path, {kConstants, 0, constant.Location});
  }
  for (size_t f = 0; f < design.Factors.size(); ++f) {
    const SFactorSource& source = design.Factors[f];
    std::vector<SLevel> levels = source.Factor.Levels;
    if (source.SettingLocations.size() == 1) {
      // all levels set the same attributes
      levels = {source.MakeLevel("")};
      if (!source.Factor.Levels.empty()) {
        levels = {source.Factor.Levels.front()};
      }
    }
    for (size_t l = 0; l < levels.size(); ++l) {
      for (size_t s = 0; s < levels[l].Settings.size(); ++s) {
        paths.Add(levels[l].Settings[s].Path, {static_cast<int>(f), l, source.LocationOf(l, s)});
      }
    }
  }
  return paths;
}

// a value that no experiment has
std::string MakeMarker(size_t path) {
  return "argos3-campaign-setting-" + std::to_string(path);
}

// false if it does not match; then report is the reason
bool TrySet(CConfigurationDocument& document, const std::string& path, const std::string& value,
            std::string& report) {
  try {
    report = document.SetByPath(path, value);
    return true;
  } catch (const CARGoSException& error) {
    report = WithoutMark(error);
    return false;
  }
}

/** @return for each path those after it that match an attribute that it matches, too. */
std::vector<std::set<size_t>> FindOverlaps(const std::string& file, const std::string& text,
                                           const std::vector<std::string>& paths) {
  std::vector<std::set<size_t>> overlaps(paths.size());
  for (size_t i = 0; i < paths.size(); ++i) {
    bool isFresh = false;
    CConfigurationDocument document;
    const std::string marker = "(was \"" + MakeMarker(i) + "\")";
    for (size_t j = i + 1; j < paths.size(); ++j) {
      std::string report;
      if (!isFresh) {
        document.Parse(text, file);
        TrySet(document, paths[i], MakeMarker(i), report);
        isFresh = true;
      }
      if (TrySet(document, paths[j], MakeMarker(j), report) &&
          report.find(marker) != std::string::npos) {
        overlaps[i].insert(j);
        isFresh = false;
      }
    }
  }
  return overlaps;
}

std::string DescribeOwner(int owner, const SDesignSource& design) {
  return owner == kConstants ? "a <set> of the campaign"
                             : "the factor \"" + design.Factors[owner].Factor.Name + '"';
}

// the first two uses that take part in one combination
void ReportConflict(CLoadErrors& errors, const SPaths& paths, size_t first, size_t second,
                    const SDesignSource& design) {
  const std::vector<SUse>& firstUses = paths.Uses.at(paths.Paths[first]);
  const std::vector<SUse>& secondUses = paths.Uses.at(paths.Paths[second]);
  for (size_t i = 0; i < firstUses.size(); ++i) {
    for (size_t j = first == second ? i + 1 : 0; j < secondUses.size(); ++j) {
      const SUse& one = firstUses[i];
      const SUse& other = secondUses[j];
      if (one.Owner == other.Owner && one.Level != other.Level) {
        continue;
      }
      const bool hasSameOwner = one.Owner == other.Owner;
      errors.Add("",
                 CARGoSException(
                     other.Location + ": \"" + paths.Paths[second] + "\" is set twice, also " +
                     (first == second ? std::string() : "through \"" + paths.Paths[first] + "\" ") +
                     (hasSameOwner ? "" : "by " + DescribeOwner(one.Owner, design) + ", ") + "at " +
                     one.Location));
      return;
    }
  }
}

// @return the attribute of an element of <framework>; empty if there is none
std::string FindFrameworkAttribute(CConfigurationDocument& document, const char* tag,
                                   const char* attribute) {
  const CConfigurationNode* const framework =
      document.GetRoot().FirstChildElement("framework", false);
  const CConfigurationNode* const element =
      framework == nullptr ? nullptr : framework->FirstChildElement(tag, false);
  return element == nullptr ? "" : element->GetAttribute(attribute);
}

size_t CountMarked(const CConfigurationNode& node, const std::string& marker) {
  size_t count = 0;
  for (const std::string& name : node.GetAttributeNames()) {
    count += node.GetAttribute(name) == marker ? 1 : 0;
  }
  for (const CConfigurationNode* child = node.FirstChildElement(false); child != nullptr;
       child = child->NextSiblingElement(false)) {
    count += CountMarked(*child, marker);
  }
  return count;
}

// true if nothing but the visualization has the marker
bool SetsOnlyViews(CConfigurationDocument& document, const std::string& marker) {
  const CConfigurationNode* const views =
      document.GetRoot().FirstChildElement("visualization", false);
  return views != nullptr && CountMarked(*views, marker) == CountMarked(document.GetRoot(), marker);
}

void RefuseViews(CLoadErrors& errors, const std::string& path, const std::vector<SUse>& uses) {
  errors.Add("", CARGoSException(uses.front().Location + ": \"" + path +
                                 "\" is of the visualization, and runs of a campaign have none"));
}

void RefuseSeed(CLoadErrors& errors, const std::string& path, const std::vector<SUse>& uses) {
  for (const SUse& use : uses) {
    errors.Add("", CARGoSException(use.Location + ": \"" + path +
                                   "\" is the seed of a run, which <runs> sets: list the seeds "
                                   "there, <runs seeds=\"11, 12\" />"));
  }
}

}  // namespace

void ApplyConstants(CLoadErrors& errors, const std::string& experimentFile,
                    const std::vector<SLocatedSetting>& constants, std::string& text) {
  if (constants.empty()) {
    return;
  }
  CConfigurationDocument document;
  document.Parse(text, experimentFile);
  for (const SLocatedSetting& constant : constants) {
    std::string report;
    if (!TrySet(document, constant.Setting.Path, constant.Setting.Value, report)) {
      errors.Add("", CARGoSException(constant.Location + ": " + report));
    }
  }
  text = document.ToText();
}

std::set<std::string> CheckSettings(CLoadErrors& errors, const std::string& experimentFile,
                                    const std::string& text,
                                    const std::vector<SLocatedSetting>& constants,
                                    const SDesignSource& design) {
  SPaths paths = CollectPaths(constants, design);
  std::vector<std::string> matching;
  std::set<std::string> ofThreads;
  for (const std::string& path : paths.Paths) {
    CConfigurationDocument document;
    document.Parse(text, experimentFile);
    std::string report;
    const std::vector<SUse>& uses = paths.Uses[path];
    const std::string marker = MakeMarker(0);
    if (!TrySet(document, path, marker, report)) {
      // those of constants were reported when they were applied
      if (uses.front().Owner != kConstants) {
        errors.Add("",
                   CARGoSException(uses.front().Location + ": " + experimentFile + ": " + report));
      }
      continue;
    }
    if (FindFrameworkAttribute(document, "experiment", "random_seed") == marker) {
      RefuseSeed(errors, path, uses);
      continue;
    }
    if (SetsOnlyViews(document, marker)) {
      RefuseViews(errors, path, uses);
      continue;
    }
    if (FindFrameworkAttribute(document, "system", "threads") == marker) {
      ofThreads.insert(path);
    }
    matching.push_back(path);
  }
  paths.Paths = matching;
  const std::vector<std::set<size_t>> overlaps = FindOverlaps(experimentFile, text, paths.Paths);
  for (size_t i = 0; i < paths.Paths.size(); ++i) {
    ReportConflict(errors, paths, i, i, design);
    for (const size_t j : overlaps[i]) {
      ReportConflict(errors, paths, i, j, design);
    }
  }
  return ofThreads;
}

}  // namespace argos
