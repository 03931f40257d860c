#ifndef RAB_CHAT_H
#define RAB_CHAT_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>

/**
 * Robots that elect a leader by messages to their neighbours, and compute their distance to it in
 * hops.
 *
 * Each robot draws a number and sends two bytes: the greatest number so far, and its
 * distance in hops to the robot that drew it. In the end all robots send the same number, and the
 * hops form a gradient towards the leader. LEDs show it: white for the leader itself, then from red
 * over green to blue.
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
  argos::UInt8 m_greatest = 0;  // known so far
  argos::UInt8 m_hops = 0;  // to the robot that drew m_greatest
};

#endif
