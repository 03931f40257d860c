#ifndef ARGOS3_PLUGINS_OUTPUTS_QUANTITIES_CONTROLLER_FIELD_H
#define ARGOS3_PLUGINS_OUTPUTS_QUANTITIES_CONTROLLER_FIELD_H

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/outputs/field.h>
#include <argos3/core/simulator/outputs/root_components.h>

#include <string>
#include <vector>

namespace argos {

/** Base of fields of what a robot's controller has, which their argument names. */
class CControllerField : public CField {
 public:
  bool NeedsArgument() const override { return true; }
  bool NeedsController() const override { return true; }

  SBoundField Bind(CEntity& root, const std::string& argument) const override {
    auto* const robot = FindExisting<CControllableEntity>(root);
    return robot != nullptr ? BindRobot(*robot, argument) : SBoundField();
  }

  void ListNames(CEntity& root, const std::string& label,
                 std::vector<std::string>& names) const override {
    if (auto* const robot = FindExisting<CControllableEntity>(root)) {
      ListNamesOf(*robot, label + ':', names);
    }
  }

 private:
  /** @param robot  may have no controller yet. */
  virtual SBoundField BindRobot(CControllableEntity& robot, const std::string& argument) const = 0;
  /** @param prefix  of each name: the label and ':'. */
  virtual void ListNamesOf(CControllableEntity& robot, const std::string& prefix,
                           std::vector<std::string>& names) const = 0;
};

}  // namespace argos

#endif
