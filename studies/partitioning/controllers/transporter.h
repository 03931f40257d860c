#ifndef TRANSPORTER_H
#define TRANSPORTER_H

#include "odometry.h"

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_gripper_actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_light_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_motor_ground_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_turret_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_omnidirectional_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>

#include <optional>
#include <vector>

/**
 * A foot-bot that transports objects from a source to the nest.
 *
 * It explores until it sees an object (green), grips it, and drags it towards the lights of the
 * nest, on grey ground. There it leaves the object, and drives back to where it gripped it, by dead
 * reckoning. If it sees no object there within a time, it forgets the place, and explores again.
 *
 * With partitioning it stops after a way and waits (blue) until another robot has gripped the
 * object, too (yellow, then red); then it releases it and drives back. If none comes, it goes on to
 * the nest.
 */
class CTransporter : public argos::CCI_Controller {
 public:
  enum class EState {
    Exploring,
    Approaching,
    Gripping,
    Carrying,
    Waiting,
    Leaving,
    Returning,
    Searching
  };

  /**
   * Reads the optional attributes speed (cm/s), way (m, after which a robot with an object waits;
   * 0: it never does), patience (s, how long it waits), search (s, how long it searches an object
   * at the place that it remembers), near (m, from that place; there objects are taken), and sight
   * (m, from which on it recognizes an object that it does not approach yet).
   */
  void Init(argos::TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

  EState GetState() const { return m_state; }
  /** Where it believes it is, from where and how it last gripped an object, cm. */
  const argos::CVector2& GetBelief() const { return m_odometry.GetPosition(); }
  argos::UInt32 GetNumGrips() const { return m_numGrips; }
  /** How often it came back to the place of its last grip; once after each grip. */
  argos::UInt32 GetNumArrivals() const { return m_numArrivals; }
  /** How often it found no object there. */
  argos::UInt32 GetNumLost() const { return m_numLost; }

 private:
  /** What the camera shows, in the robot's frame, cm. */
  struct SView {
    std::vector<argos::CVector2> Objects;
    std::vector<argos::CVector2> Carriers;  // red
    std::vector<argos::CVector2> Busy;  // carriers, and robots that grip (yellow)
    std::vector<argos::CVector2> Waiters;  // blue
  };

  void Look();
  void Enter(EState state);
  void Explore();
  void Approach();
  void Grip();
  void Carry();
  void Wait();
  void Leave();
  void Return();
  void Search();

  /** The nearest object that no robot holds, or that its robot offers. */
  std::optional<argos::CVector2> FindObject() const;
  /** The nearest object, if it is where a gripped one is. */
  std::optional<argos::CVector2> FindLoad() const;
  bool SeesWithin(const std::vector<argos::CVector2>& places, const argos::CVector2& center,
                  argos::Real distance) const;
  bool IsInNest() const;
  argos::CVector2 VectorToLight() const;
  /** Of the obstacles but the load; zero if none is near. */
  argos::CVector2 VectorOffObstacles() const;
  void Walk();
  void Follow(const argos::CVector2& direction, argos::Real speed);

  argos::CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  argos::CCI_FootBotGripperActuator* m_gripper = nullptr;
  argos::CCI_FootBotTurretActuator* m_turret = nullptr;
  argos::CCI_LEDsActuator* m_leds = nullptr;
  argos::CCI_FootBotEncoderSensor* m_encoder = nullptr;
  argos::CCI_FootBotLightSensor* m_light = nullptr;
  argos::CCI_FootBotMotorGroundSensor* m_ground = nullptr;
  argos::CCI_FootBotProximitySensor* m_proximity = nullptr;
  argos::CCI_ColoredBlobOmnidirectionalCameraSensor* m_camera = nullptr;
  argos::CRandom::CRNG* m_rng = nullptr;

  argos::Real m_speed = 10.0;
  argos::Real m_way = 0.0;
  argos::Real m_patience = 90.0;
  argos::Real m_search = 30.0;
  argos::Real m_near = 0.5;
  argos::Real m_sight = 0.3;

  EState m_state = EState::Exploring;
  argos::UInt32 m_ticks = 0;  // in this state
  COdometry m_odometry;  // from where it last gripped an object
  SView m_view;
  bool m_knowsSource = false;
  bool m_hasWaited = false;  // on this trip
  bool m_hasArrived = false;  // where it last gripped an object
  argos::UInt32 m_turnTicks = 0;
  argos::Real m_turnSign = 1.0;  // 1 to the left
  argos::UInt32 m_numGrips = 0;
  argos::UInt32 m_numArrivals = 0;
  argos::UInt32 m_numLost = 0;
};

#endif
