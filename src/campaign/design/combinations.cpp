#include <argos3/campaign/design/combinations.h>

#include <argos3/campaign/design/element_reading.h>
#include <argos3/campaign/design/expression.h>
#include <argos3/campaign/design/latin_hypercube.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/core/utility/text/lists.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace argos {

namespace {

constexpr size_t kMaxCombinations = 1000000;

// (combinations, factors) indices of levels
typedef std::vector<std::vector<UInt32>> TSelections;

TSelections SelectAll(const SDesignSource& design) {
  size_t count = 1;
  for (const SFactorSource& source : design.Factors) {
    count *= source.Factor.Levels.size();
    if (count > kMaxCombinations) {
      THROW_ARGOSEXCEPTION(design.Location
                           << ": the factors have more than " << kMaxCombinations
                           << " combinations: design=\"latin_hypercube\" takes a sample of them");
    }
  }
  TSelections selections(count, std::vector<UInt32>(design.Factors.size()));
  size_t repetitions = count;
  for (size_t f = 0; f < design.Factors.size(); ++f) {
    const size_t levels = design.Factors[f].Factor.Levels.size();
    repetitions /= levels;
    for (size_t i = 0; i < count; ++i) {
      selections[i][f] = static_cast<UInt32>(i / repetitions % levels);
    }
  }
  return selections;
}

TSelections SelectPairs(const SDesignSource& design) {
  std::string counts;
  bool isEqual = true;
  const size_t count = design.Factors.empty() ? 0 : design.Factors[0].Factor.Levels.size();
  for (const SFactorSource& source : design.Factors) {
    const size_t levels = source.Factor.Levels.size();
    isEqual = isEqual && levels == count;
    AppendItem(counts, fmt::format("\"{}\" {}", source.Factor.Name, levels));
  }
  if (!isEqual) {
    THROW_ARGOSEXCEPTION(design.Location << ": design=\"paired\" combines the n-th values of all "
                                            "factors, which must have equally many values: "
                                         << counts);
  }
  TSelections selections;
  for (size_t i = 0; i < count; ++i) {
    selections.emplace_back(design.Factors.size(), static_cast<UInt32>(i));
  }
  return selections;
}

CRandomStream MakeStream(const SDesignSource& design, const SFactorSource& source) {
  return {design.Seed, "argos3-campaign", source.Factor.Name, "latin hypercube"};
}

// the levels of a continuous factor, ascending, and the level of each stratum
std::vector<UInt32> MakeStrata(const std::vector<Real>& places, SFactorSource& source) {
  std::vector<UInt32> levelOfStratum;
  for (const Real place : places) {
    const std::string value = source.Range.ValueAt(place);
    // whole numbers may fill several strata
    if (source.Factor.Levels.empty() || source.Factor.Levels.back().Value != value) {
      source.Factor.Levels.push_back(source.MakeLevel(value));
    }
    levelOfStratum.push_back(static_cast<UInt32>(source.Factor.Levels.size() - 1));
  }
  return levelOfStratum;
}

bool AreDifferent(const TSelections& selections) {
  std::set<std::vector<UInt32>> known;
  return std::all_of(selections.begin(), selections.end(),
                     [&known](const auto& selection) { return known.insert(selection).second; });
}

TSelections SelectHypercube(SDesignSource& design) {
  std::vector<CRandomStream> streams;
  std::vector<std::vector<UInt32>> strata;
  Real most = 1.0;
  for (SFactorSource& source : design.Factors) {
    streams.push_back(MakeStream(design, source));
    strata.emplace_back();
    if (source.IsContinuous) {
      strata.back() = MakeStrata(DrawPlacesInStrata(design.Samples, streams.back()), source);
    }
    most *= static_cast<Real>(source.Factor.Levels.size());
  }
  if (design.Samples > most) {
    THROW_ARGOSEXCEPTION(design.Location << ": " << design.Samples << " samples, but the values of "
                                         << "the factors have only " << most
                                         << " combinations: design=\"full\" has them all");
  }
  // few levels may meet twice by chance
  constexpr int kMaxAttempts = 1000;
  for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
    TSelections selections(design.Samples, std::vector<UInt32>(design.Factors.size()));
    for (size_t f = 0; f < design.Factors.size(); ++f) {
      const UInt32 levels = static_cast<UInt32>(design.Factors[f].Factor.Levels.size());
      const std::vector<UInt32> drawn = strata[f].empty()
                                            ? DrawBalancedLevels(design.Samples, levels, streams[f])
                                            : DrawPermutation(design.Samples, streams[f]);
      for (UInt32 i = 0; i < design.Samples; ++i) {
        selections[i][f] = strata[f].empty() ? drawn[i] : strata[f][drawn[i]];
      }
    }
    if (AreDifferent(selections)) {
      return selections;
    }
  }
  THROW_ARGOSEXCEPTION(design.Location << ": " << design.Samples << " samples of " << most
                                       << " combinations are too many to be different ones: take "
                                          "fewer samples, or design=\"full\"");
}

TSelections Select(SDesignSource& design) {
  switch (design.Design) {
    case EDesign::Paired:
      return SelectPairs(design);
    case EDesign::LatinHypercube:
      return SelectHypercube(design);
    default:
      return SelectAll(design);
  }
}

/** Makes one combination after the other; reports the first failure of each place. */
class CCombiner {
 public:
  CCombiner(CLoadErrors& errors, const SDesignSource& design) : m_errors(errors), m_design(design) {
    m_exclusionCounts.resize(design.Exclusions.size());
  }

  /** @return false if an expression fails. */
  bool Combine(const std::vector<UInt32>& selection, SCombination& combination) {
    bool isComplete = true;
    m_expressions.SetNames({});
    for (size_t f = 0; f < selection.size(); ++f) {
      const SFactorSource& source = m_design.Factors[f];
      std::string value = source.Factor.Levels[selection[f]].Value;
      isComplete = Expand(source.Location, value) && isComplete;
      m_expressions.AddName(source.Factor.Name, value);
      combination.Values.push_back(value);
    }
    for (size_t f = 0; f < selection.size(); ++f) {
      const SFactorSource& source = m_design.Factors[f];
      const SLevel& level = source.Factor.Levels[selection[f]];
      for (size_t s = 0; s < level.Settings.size(); ++s) {
        SSetting setting = level.Settings[s];
        // the factor's own value may be an expression; it is known by now
        if (s == 0 && !source.Path.empty()) {
          setting.Value = combination.Values[f];
        } else {
          isComplete = Expand(source.LocationOf(selection[f], s), setting.Value) && isComplete;
        }
        combination.Settings.push_back(setting);
      }
    }
    return isComplete;
  }

  /** To be called after Combine() for the same combination. */
  bool IsExcluded() {
    bool isExcluded = false;
    for (size_t e = 0; e < m_design.Exclusions.size(); ++e) {
      const SExclusion& exclusion = m_design.Exclusions[e];
      Try(exclusion.Location, [&] {
        if (m_expressions.IsTrue(exclusion.Where)) {
          isExcluded = true;
          ++m_exclusionCounts[e];
        }
      });
    }
    return isExcluded;
  }

  void WarnOfUselessExclusions(std::vector<std::string>& warnings) const {
    for (size_t e = 0; e < m_design.Exclusions.size(); ++e) {
      if (m_exclusionCounts[e] == 0) {
        warnings.push_back(m_design.Exclusions[e].Location + ": \"" + m_design.Exclusions[e].Where +
                           "\" is true for no combination");
      }
    }
  }

 private:
  template <typename STEP>
  bool Try(const std::string& location, const STEP& step) {
    if (m_failed.count(location) > 0) {
      return false;
    }
    try {
      step();
      return true;
    } catch (const CARGoSException& error) {
      m_failed.insert(location);
      m_errors.Add("", CARGoSException(location + ": " + WithoutMark(error)));
      return false;
    }
  }

  bool Expand(const std::string& location, std::string& text) {
    return !HasExpression(text) || Try(location, [&] { text = m_expressions.Expand(text); });
  }

  CLoadErrors& m_errors;
  const SDesignSource& m_design;
  CExpressions m_expressions;
  std::set<std::string> m_failed;  // locations
  std::vector<UInt32> m_exclusionCounts;  // (exclusions) combinations
};

std::string DescribeValues(const SCampaign& campaign, const SCombination& combination) {
  std::string text;
  for (size_t f = 0; f < combination.Values.size(); ++f) {
    text +=
        fmt::format("{}{}={}", f == 0 ? "" : ", ", campaign.Factors[f].Name, combination.Values[f]);
  }
  return text;
}

void RefuseEqualCombinations(const SDesignSource& design, const SCampaign& campaign) {
  std::map<std::string, const SCombination*> known;
  for (const SCombination& combination : campaign.Combinations) {
    const auto [other, isNew] = known.emplace(combination.ComputeKey(), &combination);
    if (!isNew) {
      THROW_ARGOSEXCEPTION(design.Location
                           << ": two combinations give the experiment the same values: ("
                           << DescribeValues(campaign, *other->second) << ") and ("
                           << DescribeValues(campaign, combination) << ")");
    }
  }
}

// @throws CARGoSException unless there are combinations, and no two of them are equal.
void AddCombinations(CLoadErrors& errors, SDesignSource& design, SCampaign& campaign) {
  const TSelections selections = Select(design);
  for (const SFactorSource& source : design.Factors) {
    campaign.Factors.push_back(source.Factor);
  }
  CCombiner combiner(errors, design);
  bool isComplete = true;
  for (const std::vector<UInt32>& selection : selections) {
    SCombination combination;
    const bool isValid = combiner.Combine(selection, combination);
    isComplete = isComplete && isValid;
    if (!isValid) {
      continue;
    }
    if (combiner.IsExcluded()) {
      ++campaign.NumExcluded;
    } else {
      campaign.Combinations.push_back(std::move(combination));
    }
  }
  if (!isComplete) {
    return;
  }
  if (campaign.Combinations.empty()) {
    THROW_ARGOSEXCEPTION(design.Location << ": every combination is excluded");
  }
  combiner.WarnOfUselessExclusions(campaign.Warnings);
  RefuseEqualCombinations(design, campaign);
}

}  // namespace

void MakeCombinations(CLoadErrors& errors, SDesignSource& design, SCampaign& campaign) {
  errors.Try("", [&] { AddCombinations(errors, design, campaign); });
}

}  // namespace argos
