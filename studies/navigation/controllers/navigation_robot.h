#ifndef NAVIGATION_ROBOT_H
#define NAVIGATION_ROBOT_H

#include "target_table.h"

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_encoder_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>

/**
 * A foot-bot that guides others to targets, and may itself go back and forth between two of them
 * (section 6.2 of the thesis).
 *
 * It keeps a table with the distance and the freshness of what it knows about each target,
 * broadcasts it in each tick, and updates it with what it hears: the distance is that of the sender
 * plus its range, and grows by what the robot drives. If the robot navigates, it drives to the
 * place from which the best message about its target was sent; when it is there and has heard
 * nothing better, it walks at random. Guides always walk at random.
 *
 * Source: F. Ducatelle et al., "Cooperative navigation in robotic swarms", Swarm Intelligence 8
 * (2014), as far as the thesis describes it.
 */
class CNavigationRobot : public argos::CCI_Controller {
 public:
  /**
   * Reads the optional attributes speed (cm/s), arrival (range of the target robot at which it is
   * reached, cm), turn_time (mean time between the turns of the random walk, s).
   */
  void Init(argos::TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

  /** Lets it go back and forth between the targets, the first one first. */
  void Navigate(std::size_t firstTarget);
  bool Navigates() const { return m_navigates; }
  /** Number of times that it has reached a target. */
  argos::UInt32 GetNumArrivals() const { return m_numArrivals; }

 private:
  /** Side on which an obstacle ahead is passed. */
  enum class EAvoidance {
    Away, /**< the side that is free */
    Habit, /**< each robot has a preferred side, at random at the start, and changes it when
              obstacles persist */
    Right /**< always the right side */
  };

  // All vectors are in the robot's frame, in cm.
  void FollowMovement();
  void Listen();
  void Hear(const CTargetTable& heard, const argos::CCI_RangeAndBearingSensor::SPacket& packet);
  void Arrive();
  argos::CVector2 Obstacles() const;
  argos::CVector2 ChooseDirection();
  argos::CVector2 RandomWalk(bool isBlocked, argos::CRadians obstacle);
  argos::CRadians ComputeDetour() const;
  /** @param angle  of the obstacle, from the direction of the goal on, in (-PI/2,PI/2). */
  bool IsPassedOnTheRight(argos::CRadians angle);
  void Drive(const argos::CVector2& direction);

  argos::CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  argos::CCI_LEDsActuator* m_leds = nullptr;
  argos::CCI_RangeAndBearingActuator* m_sender = nullptr;
  argos::CCI_RangeAndBearingSensor* m_receiver = nullptr;
  argos::CCI_FootBotProximitySensor* m_proximity = nullptr;
  argos::CCI_FootBotEncoderSensor* m_encoder = nullptr;
  argos::CRandom::CRNG* m_rng = nullptr;

  argos::Real m_speed = 15.0;  // cm/s
  argos::Real m_arrival = 40.0;  // cm
  argos::Real m_turnTime = 5.0;  // s

  EAvoidance m_avoidance = EAvoidance::Right;
  argos::Real m_patience = 1.0;  // mean time with an obstacle ahead until the habit changes, s

  argos::Real m_clearance =
      0.0;  // at which other robots are passed, cm; 0: they are ignored until they are near

  CTargetTable m_table;
  bool m_prefersRight = true;
  bool m_navigates = false;
  std::size_t m_target = 0;
  argos::UInt32 m_numArrivals = 0;
  STargetEntry m_followed;  // best message about the target since the last arrival
  argos::CVector2 m_goal;  // where it was sent from
  bool m_hasGoal = false;
  argos::CRadians m_turn;  // of the random walk: what is left of the current turn
};

#endif
