#ifndef ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_GRIP_WORLD_H
#define ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_GRIP_WORLD_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_gripper_actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_turret_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>
#include <argos3/testing/support/experiment.h>

#include <map>
#include <optional>
#include <string>

namespace argos {

/** "contract_gripper": executes the orders of a test or, on request in its XML, random orders. */
class CContractGripper : public CCI_Controller {
 public:
  /**
   * Reads left and right, cm/s, default 0; lock and random, default false; turret and grip, default
   * true: whether random orders include those to the turret's motor and to the gripper.
   */
  void Init(TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

  Real Left = 0.0, Right = 0.0;  // cm/s
  bool Lock = false;
  CCI_FootBotTurretActuator::ETurretModes Mode = CCI_FootBotTurretActuator::MODE_OFF;
  SInt32 TurretSpeed = 0;  // turns a minute
  CRadians TurretRotation;

 private:
  void DrawCommands();

  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  CCI_FootBotGripperActuator* m_gripper = nullptr;
  CCI_FootBotTurretActuator* m_turret = nullptr;
  Real m_left = 0.0, m_right = 0.0;  // cm/s, of the XML
  bool m_lock = false;  // of the XML
  bool m_turretIsOn = true, m_grips = true;
  UInt32 m_tick = 0;
  std::optional<CRandomStream> m_random;
};

/**
 * XML of a foot-bot with that controller. @param yaw degrees. @param params attributes of <params>.
 * @param force, torque  of its drive, N, N m.
 */
std::string GripperXml(const std::string& id, Real x, Real y, Real yaw, const std::string& params,
                       Real force = 15.0, Real torque = 150.0);
/** XML of a movable box of 0.2 m x 0.2 m. @param yaw degrees. */
std::string LoadXml(const std::string& id, Real x, Real y, Real mass, Real yaw = 0.0);
/** XML of a movable cylinder of radius 0.1 m. */
std::string RollXml(const std::string& id, Real x, Real y, Real mass);

/** A world of such robots and of objects, with accessors to their state. */
class CGripWorld : public CTestWorld {
 public:
  struct SOptions {
    std::string Engine = "<dynamics2d id='e'/>";
    UInt32 TicksPerSecond = 10;
    UInt32 Threads = 0;
  };

  explicit CGripWorld(const std::string& arena) : CGripWorld(arena, SOptions()) {}
  CGripWorld(const std::string& arena, const SOptions& options);

  CEmbodiedEntity& Body(const std::string& id);
  CVector3 Position(const std::string& id) { return Body(id).GetOriginAnchor().Position; }
  /** Heading, rad. */
  Real Yaw(const std::string& id);
  CContractGripper& Driver(const std::string& id);
  CGripperEquippedEntity& Gripper(const std::string& id);
  CTurretEntity& Turret(const std::string& id);
  /** Root id of the held entity; empty: none. */
  std::string HeldBy(const std::string& id);
  void Drive(const std::string& id, Real left, Real right);

  /** Poses of all bodies and turrets. */
  struct SPose {
    CVector3 Position;
    CQuaternion Orientation;
    CQuaternion Turret;  // on the body
  };
  using TPoses = std::map<std::string, SPose>;
  TPoses GetPoses();

 private:
  CSimulator::CScope m_scope;
};

/**
 * Compliance of a grip: displacement, in the frame of the turret, of the point that was gripped.
 */
class CGripGauge {
 public:
  /** @param before  poses at the start of the tick in which the robot has gripped the body. */
  CGripGauge(CGripWorld& world, const std::string& robot, const CGripWorld::TPoses& before);
  /** Runs the ticks in which a robot locks onto a body ahead, the first ones of a world. */
  static CGripGauge Grip(CGripWorld& world, const std::string& robot, const std::string& body);

  CEmbodiedEntity& GetHeld() const { return m_held; }
  /** Displacement of the gripped point along the arm, positive away from the robot, m. */
  Real Stretch() const;
  /** Displacement across the arm, positive to the left, m. */
  Real Sideways() const;
  /** Distance of the gripped point from the robot's centre when it was gripped, m. */
  Real GetArmLength() const { return m_arm.Length(); }

 private:
  CVector3 ComputePoint(const CGripWorld::TPoses& poses) const;
  CVector3 ComputeError() const;

  CGripWorld& m_world;
  std::string m_robot;
  CEmbodiedEntity& m_held;
  CVector3 m_arm;  // frame of the turret, m
  CVector3 m_point;  // frame of the held body, m
};

}  // namespace argos

#endif
