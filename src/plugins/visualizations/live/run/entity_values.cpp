#include <argos3/plugins/simulator/visualizations/live/run/entity_values.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/outputs/field.h>
#include <argos3/core/simulator/outputs/root_components.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace argos {

namespace {

constexpr size_t kMaxRows = 50;  // of a list, such as messages

std::string NameColumn(const SColumn& column) {
  return column.Unit.empty() ? column.Name : column.Name + " (" + column.Unit + ')';
}

TJson ReadRow(const SFieldName& name, SBoundField& bound, size_t row) {
  CRowTexts texts;
  std::vector<double> numbers(std::max(bound.Columns.size(), name.Field->GetNumRaw()),
                              std::numeric_limits<double>::quiet_NaN());
  bound.Reader->Read(row, {numbers.data(), texts, bound.Columns.data()});
  if (name.Field->GetNumRaw() > 0) {
    name.Field->Derive(numbers.data());
  }
  TJson values = TJson::object();
  for (size_t i = 0; i < bound.Columns.size(); ++i) {
    const SColumn& column = bound.Columns[i];
    TJson& value = values[NameColumn(column)];
    if (column.Kind == EColumnKind::Text) {
      value = std::isnan(numbers[i]) ? std::string() : std::string(texts.Get(numbers[i]));
    } else {
      value = numbers[i];
    }
  }
  return values;
}

TJson ListComponents(CEntity& root) {
  TJson components = TJson::array();
  if (const auto* const composable = dynamic_cast<const CComposableEntity*>(&root)) {
    for (const CEntity* component : composable->GetExistingComponents()) {
      components.push_back(component->GetId());
    }
  }
  return components;
}

}  // namespace

TJson ReadField(CEntity& root, const std::string& field) {
  const SFieldName name(field);
  SBoundField bound = name.Bind(root);
  if (bound.Reader == nullptr) {
    return nullptr;
  }
  if (!name.Field->IsList()) {
    return ReadRow(name, bound, 0);
  }
  TJson rows = TJson::array();
  const size_t count = std::min(bound.Reader->CountRows(), kMaxRows);
  for (size_t row = 0; row < count; ++row) {
    rows.push_back(ReadRow(name, bound, row));
  }
  return rows;
}

TJson ReadValues(CEntity& root, size_t maxBytes) {
  TJson tree = {{"type", root.GetTypeDescription()}, {"components", ListComponents(root)}};
  size_t size = ToText(tree).size();
  for (const std::string& field : ListFieldNames({&root})) {
    TJson values = ReadField(root, field);
    size += field.size() + ToText(values).size();
    if (size > maxBytes) {
      tree["left_out"] = "more fields than can be shown";
      break;
    }
    if (!values.is_null()) {
      tree[field] = std::move(values);
    }
  }
  return tree;
}

}  // namespace argos
