#ifndef ARGOS3_TESTING_SUPPORT_SMALL_WORLD_H
#define ARGOS3_TESTING_SUPPORT_SMALL_WORLD_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>

#include <functional>
#include <string>

namespace argos::testing {

/** The parts of an experiment file, with an engine in which nothing moves and a medium for LEDs. */
struct SSmallWorldText {
  std::string Actuators; /**< XML elements */
  std::string Sensors; /**< XML elements */
  std::string Arena; /**< XML elements */
  std::string Media = "<led id=\"leds\"/>";
  std::string Engine = "<still id=\"engine\"/>";
  std::string ArenaAttributes = "size=\"10,10,2\"";
  UInt32 Seed = 1;

  /** The experiment file, with one controller "c" of type "small_world_controller". */
  std::string ToXML() const;
};

/** An experiment of its own, made current for the calling thread while it lives. */
class CSmallWorld {
 public:
  /** Loads it. @throws CARGoSException as CSimulator::Load(). */
  explicit CSmallWorld(const SSmallWorldText& text);
  ~CSmallWorld();

  CSimulator& GetSimulator() { return m_simulator; }
  CSpace& GetSpace() { return m_simulator.GetSpace(); }
  void Step(UInt32 ticks = 1);

  /** A root entity by its id and class. */
  template <typename ENTITY>
  ENTITY& Get(const std::string& id) {
    return dynamic_cast<ENTITY&>(GetSpace().GetEntity(id));
  }
  CControllableEntity& GetRobot(const std::string& id) {
    return Get<CComposableEntity>(id).GetComponent<CControllableEntity>("controller");
  }
  template <typename SENSOR>
  SENSOR& GetSensor(const std::string& robot, const std::string& type) {
    return *GetRobot(robot).GetController().GetSensor<SENSOR>(type);
  }
  template <typename ACTUATOR>
  ACTUATOR& GetActuator(const std::string& robot, const std::string& type) {
    return *GetRobot(robot).GetController().GetActuator<ACTUATOR>(type);
  }

 private:
  CSimulator m_simulator;
  CSimulator::CScope m_scope;
  CConfigurationDocument m_document;
};

/** Does what a test tells it to. */
class CSmallWorldController : public CCI_Controller {
 public:
  void ControlStep() override {
    if (OnStep) {
      OnStep(*this);
    }
  }

  std::function<void(CCI_Controller&)> OnStep;
};

/** XML of a robot of type @p tag with the controller "c". @param pose attributes of `<body>`. */
std::string Robot(const std::string& tag, const std::string& id, const std::string& pose);
/** The text of what loading @p text throws; empty if it throws nothing. */
std::string LoadError(const SSmallWorldText& text);
/** "x,y,z" with all digits. */
std::string ToText(const CVector3& vector);

}  // namespace argos::testing

#endif
