#ifndef ARGOS3_CORE_CONTROL_INTERFACE_ON_ERROR_H
#define ARGOS3_CORE_CONTROL_INTERFACE_ON_ERROR_H

#include <argos3/core/utility/configuration/argos_configuration.h>

#include <optional>

namespace argos {

/** What follows when a robot's code throws in a run: in ControlStep(), a device, or Reset(). */
enum class EOnError {
  EndRun, /**< `end_run`: the run ends with the error */
  StopRobot, /**< `stop_robot`: the controller is not called any more; the robot stays as it is */
  Quarantine /**< `quarantine`: as StopRobot, and the robot leaves physics and media */
};

/**
 * Reads the attribute `on_error` of an element.
 * @return nothing if there is no such attribute.
 * @throws CARGoSException if the value is none of the three.
 */
std::optional<EOnError> ReadOnError(TConfigurationNode& node);

}  // namespace argos

#endif
