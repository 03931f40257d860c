#include <argos3/core/utility/configuration/single_element.h>

#include <argos3/core/utility/configuration/configuration_error.h>
#include <argos3/core/utility/configuration/configuration_node.h>

namespace argos {

void CheckIsSingle(const CConfigurationNode& node) {
  const CConfigurationNode* const other = node.PreviousSiblingElement(node.Value(), false);
  if (other != nullptr) {
    THROW_CONFIGURATION_ERROR(node.GetLocation() << ": <" << node.Value()
                                                 << ">: " << DescribeRepeat(other->GetLocation()));
  }
}

std::string DescribeRepeat(const std::string& location) {
  return "there is already one at " + location + "; merge them, or remove one";
}

}  // namespace argos
