#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_ROBOT_MANUAL_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_ROBOT_MANUAL_H

#include <argos3/plugins/robots/generic/simulator/device_parameters.h>

#include <string>

namespace argos {

/** The differences between the manuals of robots. */
struct SRobotManual {
  std::string Summary; /**< the first paragraphs, with a line break at the end */
  std::string Tag; /**< the XML element of the robot */
  std::string Id; /**< used by the examples */
  std::string Arena; /**< size of the arena in the examples, "x,y,z", m */
  SRABParameters RAB; /**< defaults */
  std::string
      ExampleAttributes; /**< follow those of range and bearing; empty or with a leading blank */
  std::string Attributes; /**< lines for attributes that other robots do not have */
};

/** LONG_DESCRIPTION of a robot for REGISTER_ENTITY. Uses no static objects. */
std::string MakeRobotManual(const SRobotManual& robot);
/**
 * A paragraph for the summary of a robot with two driven wheels.
 * @param maxForce   N, > 0.
 * @param maxTorque  N m, > 0.
 */
std::string DriveManual(Real maxForce, Real maxTorque);

}  // namespace argos

#endif
