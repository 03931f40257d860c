#ifndef FLOCKING_ROBOT_H
#define FLOCKING_ROBOT_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_light_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>

#include <optional>

/**
 * A foot-bot of a flock, some of whose members know a target (section 6.1 of the thesis).
 *
 * In each tick the robot adds three vectors, f = alpha p + beta g + gamma h: p attracts and repels
 * neighbours, g points to the target if the robot knows one, and h is the mean of the directions
 * that neighbours have sent. Directions are sent as angles from the direction to a distant light,
 * which each robot measures with noise. The algorithm determines what is sent:
 *   HCS: the own heading;
 *   ICS: the target's direction, or else the mean of the directions received a step before;
 *   SCS: a combination of both, weighted by a confidence in [0,1] that adapts to the agreement
 *        of the messages received.
 *
 * Sources: thesis, section 6.1; A. E. Turgut et al., Swarm Intelligence 2 (2008), for HCS;
 * E. Ferrante et al., ANTS 2010, for ICS; E. Ferrante et al., Swarm Intelligence 8 (2014), for SCS.
 */
class CFlockingRobot : public argos::CCI_Controller {
 public:
  /** A target, as a direction. */
  struct SGoal {
    argos::CRadians Angle;  // from the direction to the light, counter-clockwise
    bool HasPriority = false;  // its robots keep their confidence
  };

  /**
   * Reads algorithm ("hcs", "ics" or "scs"), and the optional attributes of the members below, all
   * real numbers.
   * @throws CARGoSException if the algorithm is another one.
   */
  void Init(argos::TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

  /** Makes the robot know a target, or none. */
  void SetGoal(const std::optional<SGoal>& goal) { m_goal = goal; }

 private:
  enum class EAlgorithm { Hcs, Ics, Scs };

  // All vectors are in the robot's frame.
  argos::CRadians MeasureLight() const;
  argos::CVector2 Proximal() const;
  /** Sum of unit vectors in the directions received, from the light on. */
  argos::CVector2 SumOfMessages() const;
  void AdaptConfidence(argos::Real agreement);
  argos::CVector2 ChooseMessage(argos::CRadians light) const;
  void Send(argos::CRadians angle);
  void Drive(const argos::CVector2& force);
  void ShowState();

  argos::CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  argos::CCI_LEDsActuator* m_leds = nullptr;
  argos::CCI_RangeAndBearingActuator* m_sender = nullptr;
  argos::CCI_RangeAndBearingSensor* m_receiver = nullptr;
  argos::CCI_FootBotLightSensor* m_lights = nullptr;

  EAlgorithm m_algorithm = EAlgorithm::Hcs;
  argos::Real m_alpha = 1.0;  // weight of p
  argos::Real m_beta = 1.0;  // weight of g
  argos::Real m_gamma = 4.0;  // weight of h
  argos::Real m_epsilon = 1.5;  // strength of p
  argos::Real m_distance = 0.56;  // between neighbours at rest, m
  argos::Real m_reach = 1.0;  // of p, m
  argos::Real m_forwardGain = 2.0;  // cm/s for a force of 1
  argos::Real m_turnGain = 0.15;  // rad/s for a force of 1
  argos::Real m_maxSpeed = 10.0;  // cm/s
  argos::Real m_maxTurnRate = 1.5;  // rad/s
  argos::Real m_agreement = 0.8;  // threshold of the messages' agreement, in [0,1]
  argos::Real m_confidenceStep = 0.1;  // per tick

  std::optional<SGoal> m_goal;
  argos::CVector2 m_average;  // of the messages of the last step, in the robot's frame; 0 for none
  argos::CVector2 m_sent;  // last direction sent, in the frame of the light; 0 for none
  argos::Real m_confidence = 0.0;  // in [0,1]
};

#endif
