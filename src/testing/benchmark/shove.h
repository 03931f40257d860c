#ifndef ARGOS3_TESTING_BENCHMARK_SHOVE_H
#define ARGOS3_TESTING_BENCHMARK_SHOVE_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_gripper_actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>

#include <string>

namespace argos::testing {

/**
 * "shover": drives straight on at 12 cm/s, and now and then turns for about a second; ten times as
 * often where it touches something. With <params grips="true"/> its gripper is locked all the time:
 * it drags about what it touches first.
 */
class CShover : public CCI_Controller {
 public:
  void Init(TConfigurationNode& params) override;
  void ControlStep() override;

 private:
  bool IsTouching() const;

  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  CCI_FootBotProximitySensor* m_proximity = nullptr;
  CRandom::CRNG* m_random = nullptr;
  UInt32 m_turnsLeft = 0;  // ticks
};

/**
 * Foot-bots on a fifth of the floor of a pen, with a movable cylinder or box for every four of
 * them, which they push about: an experiment. The last @p gripping robots have locked grippers.
 */
std::string MakeShove(UInt32 robots, UInt32 gripping, UInt32 threads, const std::string& engine,
                      const std::string& attributes = "");

}  // namespace argos::testing

#endif
