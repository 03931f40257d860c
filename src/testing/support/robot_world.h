#ifndef ARGOS3_TESTING_SUPPORT_ROBOT_WORLD_H
#define ARGOS3_TESTING_SUPPORT_ROBOT_WORLD_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/testing/support/arena_text.h>
#include <argos3/testing/support/experiment.h>

#include <functional>
#include <memory>
#include <string>

namespace argos {

/**
 * An experiment for tests of robots and objects. By default nothing moves in its engine, so that
 * readings follow from geometry alone, and it has a medium "leds".
 */
struct SRobotExperiment {
  std::string Actuators; /**< XML elements of the controller "c" */
  std::string Sensors; /**< XML elements of the controller "c" */
  std::string Arena; /**< XML elements */
  std::string Engine = "<toy_engine id=\"engine\"/>";
  std::string Media = "<led id=\"leds\"/>";
  std::string LoopFunctions = ""; /**< the whole element, or empty */
  UInt32 Seed = 1;

  SExperiment ToExperiment() const;
};

/** Runs such an experiment; its simulator is current for the calling thread during its lifetime. */
class CRobotWorld : public CTestWorld {
 public:
  /** @throws CARGoSException on any loading error. */
  explicit CRobotWorld(const SRobotExperiment& experiment);

  /** @throws CARGoSException if there is no such robot. */
  CControllableEntity& GetRobot(const std::string& id);
  template <typename SENSOR>
  SENSOR& GetSensor(const std::string& robot, const std::string& type) {
    return *GetRobot(robot).GetController().GetSensor<SENSOR>(type);
  }
  template <typename ACTUATOR>
  ACTUATOR& GetActuator(const std::string& robot, const std::string& type) {
    return *GetRobot(robot).GetController().GetActuator<ACTUATOR>(type);
  }
  /** Adds an entity to the space during the experiment. */
  template <typename ENTITY>
  ENTITY& Add(std::unique_ptr<ENTITY> entity) {
    ENTITY& added = *entity;
    GetSimulator().GetLoopFunctions().AddEntity(*entity.release());
    return added;
  }

 private:
  CSimulator::CScope m_scope;
};

/** "robot_world_controller": calls a function of the test in each step. */
class CRobotWorldController : public CCI_Controller {
 public:
  void ControlStep() override {
    if (OnStep) {
      OnStep();
    }
  }

  std::function<void()> OnStep;
};

/** XML of a robot of type @p tag with the controller "c". @param pose attributes of `<body>`. */
std::string Robot(const std::string& tag, const std::string& id, const std::string& pose);
/** XML attributes that are refused, and a part of the error. */
struct SInvalidAttributes {
  const char* Attributes;
  const char* Reason;
};

/** The error on loading an experiment; empty if it loads. */
std::string LoadError(const SRobotExperiment& experiment);

}  // namespace argos

#endif
