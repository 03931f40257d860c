#ifndef ARGOS3_TESTING_BENCHMARK_FLOCKS_H
#define ARGOS3_TESTING_BENCHMARK_FLOCKS_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_omnidirectional_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>

#include <string>

namespace argos::testing {

/**
 * "talker": drives on, away from what its proximity sensors feel, and tells the others a number in
 * each tick, which follows from those that it hears or sees: by range and bearing if it has that,
 * and otherwise by the colour of its beacon, which others see with their cameras.
 */
class CTalker : public CCI_Controller {
 public:
  void Init(TConfigurationNode& params) override;
  void ControlStep() override;

 private:
  void Drive();
  UInt8 Listen() const;

  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  CCI_FootBotProximitySensor* m_proximity = nullptr;
  CCI_RangeAndBearingActuator* m_mouth = nullptr;
  CCI_RangeAndBearingSensor* m_ears = nullptr;
  CCI_LEDsActuator* m_leds = nullptr;
  CCI_ColoredBlobOmnidirectionalCameraSensor* m_eyes = nullptr;
};

// experiments

/** Foot-bots, 2.2 on a square metre, that send messages of four bytes over 3 m. */
std::string MakeMessages(UInt32 robots, UInt32 threads, const std::string& engine,
                         const std::string& attributes = "");
/** The same robots with a lit beacon and an omnidirectional camera instead. */
std::string MakeColors(UInt32 robots, UInt32 threads, const std::string& engine,
                       const std::string& attributes = "");
/** The same robots without either, that run experiments/controllers/lua/diffusion.lua. */
std::string MakeScripts(UInt32 robots, UInt32 threads, const std::string& engine,
                        const std::string& attributes = "");
/** experiments/flocking.argos with another number of robots at the same density. */
std::string MakeFlocking(UInt32 robots, UInt32 threads, const std::string& engine,
                         const std::string& attributes = "");
/** Of experiments/flocking_lua.argos. */
std::string MakeFlockingLua(UInt32 robots, UInt32 threads, const std::string& engine,
                            const std::string& attributes = "");

}  // namespace argos::testing

#endif
