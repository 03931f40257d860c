#include <argos3/core/control_interface/on_error.h>

#include <argos3/core/utility/errors/argos_exception.h>

namespace argos {

std::optional<EOnError> ReadOnError(TConfigurationNode& node) {
  if (!NodeAttributeExists(node, "on_error")) {
    return std::nullopt;
  }
  std::string value;
  GetNodeAttribute(node, "on_error", value);
  if (value == "end_run") {
    return EOnError::EndRun;
  }
  if (value == "stop_robot") {
    return EOnError::StopRobot;
  }
  if (value == "quarantine") {
    return EOnError::Quarantine;
  }
  THROW_ARGOSEXCEPTION(node.GetLocation()
                       << ": <" << node.Value()
                       << ">: \"on_error\" must be \"end_run\", \"stop_robot\" or \"quarantine\", "
                          "got \""
                       << value << '"');
}

}  // namespace argos
