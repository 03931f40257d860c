#include <argos3/campaign/design/combination_filter.h>

#include <argos3/campaign/design/expression.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>

namespace argos {

SCampaign SelectCombinations(const SCampaign& campaign, const std::string& where) {
  CExpressions expressions;
  const auto isSelected = [&](const SCombination& combination) {
    expressions.SetNames({});
    for (size_t f = 0; f < campaign.Factors.size(); ++f) {
      expressions.AddName(campaign.Factors[f].Name, combination.Values.at(f));
    }
    return expressions.IsTrue(where);
  };
  SCampaign selected = campaign;
  std::erase_if(selected.Combinations, [&isSelected](const SCombination& combination) {
    return !isSelected(combination);
  });
  if (selected.Combinations.empty()) {
    THROW_ARGOSEXCEPTION('"' << where << "\" is true for no combination");
  }
  return selected;
}

}  // namespace argos
