#include "fault_experiment.h"

#include <argos3/testing/support/paths.h>

#include <string>

namespace argos {

std::string MisbehavingLibrary() {
  return InBuildTree("testing/plugins/libargos3_test_misbehaving.so");
}

std::string SFaultExperiment::ToXml() const {
  const std::string library = " library='" + MisbehavingLibrary() + "' ";
  // robots in rows of 20, far enough from each other to drive in circles
  const std::string rows = std::to_string((Robots + 19) / 20);
  return "<argos-configuration>\n<framework><system threads='" + std::to_string(Threads) +
         "'/><experiment ticks_per_second='10' length='" + Length + "' random_seed='1' " +
         ExperimentAttributes + "/></framework>\n<controllers>\n<test_misbehaves id='c'" + library +
         ControllerAttributes + "><actuators><differential_steering implementation='default'/>" +
         Actuators + "</actuators><sensors>" + Sensors + "</sensors><params " + Params +
         "/></test_misbehaves>\n<test_stays_idle id='idle'/></controllers>\n" +
         (Loop.empty() ? "" : "<loop_functions label='test_misbehaving_loop' " + Loop + "/>\n") +
         "<physics_engines>" + Engine + "</physics_engines>\n<media>" + Media +
         "</media>\n<arena size='20,20,2'><distribute><position method='grid' center='0,0,0' "
         "distances='0.3,0.3,0' layout='20," +
         rows + ",1'/><orientation method='constant' values='0,0,0'/><entity quantity='" +
         std::to_string(Robots) +
         "' max_trials='1'><e-puck id='ep'><controller "
         "config='c'/></e-puck></entity></distribute>" +
         Entities + "</arena>\n</argos-configuration>\n";
}

}  // namespace argos
