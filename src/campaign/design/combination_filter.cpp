#include <argos3/campaign/design/combination_filter.h>

#include <argos3/campaign/design/expression.h>
#include <argos3/core/utility/errors/argos_exception.h>

namespace argos {

SCampaign SelectCombinations(const SCampaign& campaign, const std::string& where) {
  CExpressions expressions;
  SCampaign selected = campaign;
  selected.Combinations.clear();
  for (const SCombination& combination : campaign.Combinations) {
    expressions.SetNames({});
    for (size_t f = 0; f < campaign.Factors.size(); ++f) {
      expressions.AddName(campaign.Factors[f].Name, combination.Values.at(f));
    }
    if (expressions.IsTrue(where)) {
      selected.Combinations.push_back(combination);
    }
  }
  if (selected.Combinations.empty()) {
    THROW_ARGOSEXCEPTION('"' << where << "\" is true for no combination");
  }
  return selected;
}

}  // namespace argos
