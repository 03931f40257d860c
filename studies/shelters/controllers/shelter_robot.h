#ifndef SHELTER_ROBOT_H
#define SHELTER_ROBOT_H

#include "shelter_message.h"

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_omnidirectional_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>

/**
 * A foot-bot that joins the group under a shelter, and leaves it, with probabilities that the
 * shelter broadcasts.
 *
 * A free robot (green) walks at random. When it comes into range of an active shelter it decides
 * once whether it joins. A robot of a group (red) is drawn to the shelter and keeps a distance to
 * the others; in each tick it may decide to leave. A robot that leaves (blue) drives away from the
 * shelter, and the others make way; out of range it is free. A robot that is pushed out of range,
 * or whose shelter is deactivated, is free, too.
 */
class CShelterRobot : public argos::CCI_Controller {
 public:
  /**
   * Reads the optional attributes range (m, radius of a shelter's disc on the floor), speed (cm/s,
   * of a free robot), walk (s, mean time between random turns), pace (cm/s, at most, under a
   * shelter), pull (cm/s, of the shelter), push (gain of the forces between robots), rest (cm/s,
   * below which a robot stands still), distance and way (m, between robots of a group, and to one
   * that leaves).
   */
  void Init(argos::TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

 private:
  enum class EState { Free, InGroup, Leaving };

  /** The nearest active shelter, if the robot is in its range. */
  struct SShelter {
    bool IsInRange = false;
    argos::CVector2 Center;  // in the robot's frame, cm
    SShelterMessage Message;
  };

  SShelter FindShelter() const;
  void Enter(EState state);
  void ChangeState(const SShelter& shelter);
  void Walk();
  void FollowForces(const SShelter& shelter);
  argos::CVector2 ForceOf(const argos::SOmnidirectionalBlob& neighbor) const;
  void Drive(const argos::CVector2& velocity);
  bool Happens(argos::Real probability);

  argos::CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  argos::CCI_LEDsActuator* m_leds = nullptr;
  argos::CCI_FootBotProximitySensor* m_proximity = nullptr;
  argos::CCI_ColoredBlobOmnidirectionalCameraSensor* m_camera = nullptr;
  argos::CCI_RangeAndBearingSensor* m_ears = nullptr;
  argos::CRandom::CRNG* m_rng = nullptr;

  argos::Real m_range = 0.8;
  argos::Real m_speed = 20.0;
  argos::Real m_pace = 10.0;
  argos::Real m_walk = 10.0;
  argos::Real m_pull = 10.0;
  argos::Real m_push = 2.0;
  argos::Real m_rest = 2.0;
  argos::Real m_distance = 0.22;
  argos::Real m_way = 0.33;

  EState m_state = EState::Free;
  bool m_wasInRange = false;  // in the tick before
  argos::UInt32 m_turnTicks = 0;  // of the turn of a free robot that is going on
  argos::Real m_turnSign = 1.0;  // 1 to the left, -1 to the right
};

#endif
