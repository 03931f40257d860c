#ifndef RAB_CHAT_H
#define RAB_CHAT_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>

/**
 * Robots that elect a leader by talking to their neighbours, and find out how far off it is.
 *
 * Each robot draws a number and says two bytes: the greatest number that it has heard of, and how
 * many hops away the robot is that drew it. In the end all say the same number, and the hops are a
 * gradient that leads to the leader. LEDs show it: white for the leader itself, then from red over
 * green to blue.
 */
class CRABChat : public argos::CCI_Controller {
 public:
  void Init(argos::TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

 private:
  void Say();

  argos::CCI_RangeAndBearingActuator* m_mouth = nullptr;
  argos::CCI_RangeAndBearingSensor* m_ears = nullptr;
  argos::CCI_LEDsActuator* m_leds = nullptr;  // optional
  argos::CRandom::CRNG* m_rng = nullptr;

  argos::UInt8 m_own = 0;  // the number drawn
  argos::UInt8 m_greatest = 0;  // heard of
  argos::UInt8 m_hops = 0;  // to who drew it
};

#endif
