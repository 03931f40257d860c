#include <argos3/campaign/design/factor_reader.h>

#include <argos3/campaign/design/element_reading.h>
#include <argos3/campaign/design/expression.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace argos {

namespace {

constexpr UInt32 kMaxLevels = 100000;

const std::vector<std::string> kReservedNames = {
    "and",      "break",  "do",     "else", "elseif", "end",   "false", "for",
    "function", "goto",   "if",     "in",   "local",  "math",  "nil",   "not",
    "or",       "repeat", "return", "then", "true",   "until", "while"};

std::string Locate(const TConfigurationNode& node) {
  return node.GetLocation() + ": <" + node.Value() + ">";
}

void ReadRange(TConfigurationNode& node, SFactorRange& range) {
  GetNodeAttribute(node, "min", range.Min);
  GetNodeAttribute(node, "max", range.Max);
  range.IsLogarithmic = ReadChoice(node, "scale", {"linear", "log"}) == 1;
  GetNodeAttributeOrDefault(node, "integer", range.IsInteger, false);
  if (!(range.Min < range.Max)) {
    ThrowAt(node, "expected min < max, found min=\"" + ToString(range.Min) + "\" and max=\"" +
                      ToString(range.Max) + '"');
  }
  if (range.IsLogarithmic && range.Min <= 0.0) {
    ThrowAt(node, "scale=\"log\" needs min > 0, found min=\"" + ToString(range.Min) + '"');
  }
  if (range.IsInteger && std::ceil(range.Min) > std::floor(range.Max)) {
    ThrowAt(node, "integer=\"true\" needs a whole number from min to max, found min=\"" +
                      ToString(range.Min) + "\" and max=\"" + ToString(range.Max) + '"');
  }
}

UInt32 ReadLevelCount(TConfigurationNode& node, const std::string& attribute, UInt32 min) {
  UInt32 count = 0;
  GetNodeAttribute(node, attribute, count);
  if (count < min || count > kMaxLevels) {
    ThrowAt(node, "attribute \"" + attribute + "\": expected a whole number from " +
                      std::to_string(min) + " to " + std::to_string(kMaxLevels) + ", found " +
                      std::to_string(count));
  }
  return count;
}

std::vector<std::string> WithoutRepetitions(const std::vector<std::string>& values) {
  std::set<std::string> known;
  std::vector<std::string> unique;
  std::copy_if(values.begin(), values.end(), std::back_inserter(unique),
               [&known](const std::string& value) { return known.insert(value).second; });
  return unique;
}

// values of min and max
std::vector<std::string> ReadRangeValues(TConfigurationNode& node, EDesign design,
                                         SFactorSource& source) {
  ReadRange(node, source.Range);
  const bool hasSteps = NodeAttributeExists(node, "steps");
  const bool isRandom = NodeAttributeExists(node, "random");
  if (hasSteps && isRandom) {
    ThrowAt(node, "expected either steps or random, found both");
  }
  if (hasSteps) {
    return ComputeSteps(source.Range, ReadLevelCount(node, "steps", 2));
  }
  if (isRandom) {
    const UInt32 count = ReadLevelCount(node, "random", 1);
    CRandomStream random(ReadCount(node, "seed", 0, 1), "argos3-campaign", source.Factor.Name,
                         "random values");
    const std::vector<std::string> values = DrawValues(source.Range, count, random);
    return design == EDesign::Paired ? values : WithoutRepetitions(values);
  }
  if (design != EDesign::LatinHypercube) {
    ThrowAt(node,
            "min and max need steps=\"...\" for equal steps, or random=\"...\" for random values");
  }
  source.IsContinuous = true;
  return {};
}

std::vector<std::string> ReadListedValues(TConfigurationNode& node) {
  const std::string text = ReadText(node, "values");
  try {
    return SplitValues(text);
  } catch (const CARGoSException& error) {
    ThrowAt(node, "attribute \"values\": " + WithoutMark(error));
  }
}

void RefuseRepetitions(const TConfigurationNode& node, const std::vector<std::string>& values) {
  std::set<std::string> known;
  for (const std::string& value : values) {
    if (!known.insert(value).second) {
      ThrowAt(node, "the value \"" + value + "\" is given twice");
    }
  }
}

void ReadLevels(TConfigurationNode& node, SFactorSource& source) {
  const std::vector<std::string> common = source.SettingLocations.front();
  source.SettingLocations.clear();
  TConfigurationNodeIterator child("level");
  for (child = child.begin(&node); child != child.end(); ++child) {
    SLevel level = source.MakeLevel(ReadText(*child, "value"));
    std::vector<std::string> locations = common;
    TConfigurationNodeIterator set;
    for (set = set.begin(&*child); set != set.end(); ++set) {
      if (set->Value() != "set") {
        ThrowAt(*set, "there is no such element in <level>" + DidYouMean(set->Value(), {"set"}));
      }
      const SLocatedSetting setting = ReadSetting(*set);
      level.Settings.push_back(setting.Setting);
      locations.push_back(setting.Location);
    }
    source.Factor.Levels.push_back(level);
    source.SettingLocations.push_back(locations);
  }
}

// the settings that all levels have
void ReadCommonSettings(TConfigurationNode& node, SFactorSource& source) {
  source.Path = ReadOptionalText(node, "path");
  std::vector<std::string>& locations = source.SettingLocations.emplace_back();
  if (!source.Path.empty()) {
    locations.push_back(source.Location);
  }
  TConfigurationNodeIterator child;
  for (child = child.begin(&node); child != child.end(); ++child) {
    if (child->Value() == "set") {
      const SLocatedSetting setting = ReadSetting(*child);
      source.Sets.push_back(setting.Setting);
      locations.push_back(setting.Location);
    } else if (child->Value() != "level") {
      ThrowAt(*child, "there is no such element in <factor>" +
                          DidYouMean(child->Value(), {"level", "set"}));
    }
  }
}

SFactorSource ReadFactor(TConfigurationNode& node, EDesign design) {
  SFactorSource source;
  source.Location = Locate(node);
  source.Factor.Name = ReadName(node, "name");
  if (std::find(kReservedNames.begin(), kReservedNames.end(), source.Factor.Name) !=
      kReservedNames.end()) {
    ThrowAt(node, "attribute \"name\": \"" + source.Factor.Name +
                      "\" is a word of Lua, which expressions could not use: take another name");
  }
  ReadCommonSettings(node, source);
  const bool hasValues = NodeAttributeExists(node, "values");
  const bool hasRange = NodeAttributeExists(node, "min") || NodeAttributeExists(node, "max");
  const bool hasLevels = NodeExists(node, "level");
  if (int{hasValues} + int{hasRange} + int{hasLevels} != 1) {
    ThrowAt(node,
            "expected one of: values=\"...\", min=\"...\" with max=\"...\", or elements "
            "<level>");
  }
  std::vector<std::string> values;
  if (hasLevels) {
    ReadLevels(node, source);
    for (const SLevel& level : source.Factor.Levels) {
      values.push_back(level.Value);
    }
  } else {
    values = hasValues ? ReadListedValues(node) : ReadRangeValues(node, design, source);
    for (const std::string& value : values) {
      source.Factor.Levels.push_back(source.MakeLevel(value));
    }
  }
  if (design != EDesign::Paired) {
    RefuseRepetitions(node, values);
  }
  return source;
}

bool IsNamedIn(const std::string& text, const std::string& name) {
  return HasExpression(text) && text.find(name) != std::string::npos;
}

bool IsNamedInExpressions(const std::string& name, const SDesignSource& design) {
  const auto isNamedIn = [&name](const std::string& text) { return IsNamedIn(text, name); };
  for (const SFactorSource& source : design.Factors) {
    if (std::ranges::any_of(source.Sets, isNamedIn, &SSetting::Value)) {
      return true;
    }
    for (const SLevel& level : source.Factor.Levels) {
      if (isNamedIn(level.Value) ||
          std::ranges::any_of(level.Settings, isNamedIn, &SSetting::Value)) {
        return true;
      }
    }
  }
  return false;
}

void AddFactor(TConfigurationNode& node, SDesignSource& design) {
  const SFactorSource source = ReadFactor(node, design.Design);
  for (const SFactorSource& other : design.Factors) {
    // names become columns of tables, which do not distinguish cases
    if (StringToLowerCase(other.Factor.Name) == StringToLowerCase(source.Factor.Name)) {
      ThrowAt(node,
              "the name \"" + source.Factor.Name + "\" is given twice, first at " + other.Location);
    }
  }
  design.Factors.push_back(source);
}

void CheckThatFactorsSetSomething(CLoadErrors& errors, const SDesignSource& design) {
  for (const SFactorSource& source : design.Factors) {
    const bool setsNothing = std::ranges::all_of(source.SettingLocations, std::ranges::empty);
    if (setsNothing && !IsNamedInExpressions(source.Factor.Name, design)) {
      errors.Add("", CARGoSException(source.Location + ": the factor \"" + source.Factor.Name +
                                     "\" changes nothing: give it path=\"...\", or elements <set "
                                     "path=\"...\" value=\"...\"/>"));
    }
  }
}

}  // namespace

SLevel SFactorSource::MakeLevel(const std::string& value) const {
  SLevel level;
  level.Value = value;
  if (!Path.empty()) {
    level.Settings.push_back({Path, value});
  }
  level.Settings.insert(level.Settings.end(), Sets.begin(), Sets.end());
  return level;
}

SLocatedSetting ReadSetting(TConfigurationNode& node) {
  SLocatedSetting setting;
  setting.Location = Locate(node);
  setting.Setting.Path = ReadText(node, "path");
  GetNodeAttribute(node, "value", setting.Setting.Value);
  return setting;
}

SDesignSource ReadFactors(CLoadErrors& errors, TConfigurationNode& node) {
  SDesignSource design;
  design.Location = Locate(node);
  design.IsComplete = errors.Try("", [&] {
    design.Design = ReadChoice<EDesign>(node, "design",
                                        {{"full", EDesign::Full},
                                         {"paired", EDesign::Paired},
                                         {"latin_hypercube", EDesign::LatinHypercube}},
                                        design.Design);
    if (design.Design == EDesign::LatinHypercube) {
      design.Samples = ReadLevelCount(node, "samples", 2);
      design.Seed = ReadCount(node, "seed", 0, 1);
    }
  });
  size_t numFactors = 0;
  const auto readFactor = [&](TConfigurationNode& element) {
    ++numFactors;
    AddFactor(element, design);
  };
  const auto readExclusion = [&](TConfigurationNode& element) {
    design.Exclusions.push_back({ReadText(element, "where"), Locate(element)});
  };
  ReadChildren(errors, node, {{"factor", readFactor}, {"exclude", readExclusion}});
  design.IsComplete = design.IsComplete && design.Factors.size() == numFactors;
  CheckThatFactorsSetSomething(errors, design);
  return design;
}

}  // namespace argos
