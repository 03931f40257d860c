#ifndef ARGOS3_TESTING_SCENARIO_FAULTS_FAULT_EXPERIMENT_H
#define ARGOS3_TESTING_SCENARIO_FAULTS_FAULT_EXPERIMENT_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>

namespace argos {

/**
 * An experiment of e-pucks "ep0", "ep1", ... on a grid, which drive in circles, and of a
 * controller, loop functions or a device that misbehaves: see plugins/argos3_test_misbehaving.cpp
 * for the attributes where, what, robot and tick.
 */
struct SFaultExperiment {
  std::string Params; /**< attributes of the controller's <params> */
  std::string ControllerAttributes; /**< such as on_error="stop_robot" */
  std::string ExperimentAttributes;
  std::string Sensors; /**< children of <sensors> */
  std::string Actuators; /**< children of <actuators>, besides the wheels */
  std::string Loop; /**< attributes of <loop_functions>; empty: no loop functions */
  std::string Media; /**< children of <media> */
  std::string Engine = "<dynamics2d id='engine'/>";
  std::string Entities; /**< further children of <arena> */
  UInt32 Robots = 5;
  UInt32 Threads = 0;
  std::string Length = "1"; /**< s; a tick takes 0.1 s */

  std::string ToXml() const;
};

/** The library of the misbehaving parts; absolute path. */
std::string MisbehavingLibrary();

}  // namespace argos

#endif
