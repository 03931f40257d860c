#include <argos3/plugins/simulator/visualizations/live/run/parameter_editor.h>

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/outputs/root_components.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/tick/loop_functions.h>
#include <argos3/plugins/simulator/visualizations/live/run/command_arguments.h>

#include <limits>
#include <typeinfo>

namespace argos {

namespace {

CCI_Controller* FindController(CEntity& root) {
  auto* const robot = FindExisting<CControllableEntity>(root);
  return robot != nullptr && robot->HasController() ? &robot->GetController() : nullptr;
}

}  // namespace

CChangeableParameters* CParameterEditor::Find(CEntity* root) const {
  if (root == nullptr) {
    return dynamic_cast<CChangeableParameters*>(&m_simulator.GetLoopFunctions());
  }
  return dynamic_cast<CChangeableParameters*>(FindController(*root));
}

TJson CParameterEditor::List(CEntity* root) const {
  TJson list = TJson::array();
  if (CChangeableParameters* const owner = Find(root)) {
    for (const CChangeableParameters::SParameter& parameter : owner->ListParameters()) {
      list.push_back({{"name", parameter.Name},
                      {"value", parameter.Value},
                      {"min", parameter.Min},
                      {"max", parameter.Max},
                      {"unit", parameter.Unit}});
    }
  }
  return list;
}

// @return false if there is no such parameter and it is not required
bool CParameterEditor::SetValue(CEntity* root, const std::string& name, Real value,
                                bool isRequired) {
  CChangeableParameters* const owner = Find(root);
  const std::string who = root != nullptr ? root->GetId() : std::string();
  if (owner != nullptr) {
    for (const CChangeableParameters::SParameter& parameter : owner->ListParameters()) {
      if (parameter.Name != name) {
        continue;
      }
      if (!(value >= parameter.Min) || !(value <= parameter.Max)) {
        THROW_ARGOSEXCEPTION('"' << name << "\" is a number from " << parameter.Min << " to "
                                 << parameter.Max);
      }
      m_originals.try_emplace({who, name}, parameter.Value);
      parameter.Value = value;
      owner->HandleChangedParameter(name);
      return true;
    }
  }
  if (isRequired) {
    THROW_ARGOSEXCEPTION(
        (root != nullptr ? "the controller of \"" + who + '"' : "the loop functions")
        << " declare no changeable parameter \"" << name << '"');
  }
  return false;
}

TJson CParameterEditor::Set(CEntity* root, const TJson& arguments) {
  constexpr Real kMax = std::numeric_limits<Real>::max();
  const std::string name = ReadTextArgument(arguments, "name");
  const auto value = ReadNumberArgument(arguments, "value", -kMax, kMax);
  const bool isForAll = ReadFlagArgument(arguments, "all").value_or(false);
  if (!value) {
    THROW_ARGOSEXCEPTION("\"value\" is missing");
  }
  SetValue(root, name, *value, true);
  size_t numRobots = root != nullptr ? 1 : 0;
  if (root != nullptr && isForAll) {
    const CCI_Controller& changed = *FindController(*root);
    const std::type_info& type = typeid(changed);
    for (CEntity* const other : m_simulator.GetSpace().GetRootEntityVector()) {
      CCI_Controller* const controller = FindController(*other);
      if (other != root && controller != nullptr && typeid(*controller) == type) {
        numRobots += SetValue(other, name, *value, false) ? 1 : 0;
      }
    }
  }
  return {{"robots", numRobots}};
}

void CParameterEditor::Restore() {
  for (const auto& [place, value] : m_originals) {
    CEntity* const root =
        place.first.empty() ? nullptr : m_simulator.GetSpace().TryGetEntity(place.first);
    if (root == nullptr && !place.first.empty()) {
      continue;
    }
    if (CChangeableParameters* const owner = Find(root)) {
      for (const CChangeableParameters::SParameter& parameter : owner->ListParameters()) {
        if (parameter.Name == place.second) {
          parameter.Value = value;
          owner->HandleChangedParameter(place.second);
        }
      }
    }
  }
  m_originals.clear();
}

}  // namespace argos
