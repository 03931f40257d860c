#ifndef FOOTBOT_FORAGING_H
#define FOOTBOT_FORAGING_H

#include "../common/steering.h"

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_light_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_motor_ground_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>

#include <memory>

/**
 * A foot-bot that fetches food into a nest.
 *
 * It explores until it finds food or a time limit is reached; then it goes to the nest, where
 * lights are, and rests. The probability to leave the nest increases with every success, its own
 * and those reported by others, and decreases with every failure: the number of active robots
 * adapts to the amount of food.
 *
 * The nest is grey on the ground, the rest white or, where there is food, black. The loop functions
 * set SFood when a robot has picked up food.
 *
 * Source: W. Liu et al., "Towards energy optimization: emergent task allocation in a swarm of
 * foraging robots", Adaptive Behavior 15 (2007).
 */
class CFootBotForaging : public argos::CCI_Controller {
 public:
  enum class EState { Resting, Exploring, Returning };

  /** The food that the robot carries; written by the loop functions. */
  struct SFood {
    bool Has = false;
    argos::UInt64 Delivered = 0;
  };

  /**
   * Reads the optional attributes max_speed (cm/s), exploring_ticks (time limit of exploration),
   * resting_ticks (minimum time of rest), leaving_probability (initial value, per tick),
   * success_step and failure_step (changes of that probability).
   */
  void Init(argos::TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

  EState GetState() const { return m_state; }
  SFood& GetFood() { return m_food; }

 private:
  enum class ENews : argos::UInt8 { None, Success, Failure };

  void Enter(EState state);
  void Rest();
  void Explore();
  void Return();
  void Learn(ENews news);
  bool IsInNest() const;
  argos::CVector2 VectorToLight() const;
  argos::CVector2 VectorOffObstacles() const;

  std::unique_ptr<CSteering> m_steering;
  argos::CCI_LEDsActuator* m_leds = nullptr;
  argos::CCI_RangeAndBearingActuator* m_mouth = nullptr;
  argos::CCI_RangeAndBearingSensor* m_ears = nullptr;
  argos::CCI_FootBotProximitySensor* m_proximity = nullptr;
  argos::CCI_FootBotLightSensor* m_light = nullptr;
  argos::CCI_FootBotMotorGroundSensor* m_ground = nullptr;
  argos::CRandom::CRNG* m_rng = nullptr;

  argos::UInt32 m_exploringTicks = 600;
  argos::UInt32 m_restingTicks = 50;
  argos::Real m_startProbability = 0.1;
  argos::Real m_successStep = 0.02;
  argos::Real m_failureStep = 0.01;

  EState m_state = EState::Resting;
  SFood m_food;
  bool m_foundFood = false;  // on the trip that ends
  argos::UInt32 m_ticksInState = 0;
  argos::Real m_leavingProbability = 0.1;  // per tick
};

#endif
