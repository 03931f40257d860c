#ifndef ARGOS3_TESTING_SUPPORT_TOY_WORLD_H
#define ARGOS3_TESTING_SUPPORT_TOY_WORLD_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

/*
 * Minimal plug-ins with which the core can be tested alone: a robot that moves at the velocity of
 * its controller, a block, a lamp, an engine without forces, a medium without effect.
 *
 *   <toy_engine id="toy" />   <toy_medium id="air" />
 *   <toy_controller id="c"> <actuators> <toy_drive implementation="default" /> </actuators>
 *     <sensors> <toy_range implementation="default" /> </sensors>
 *     <params velocity="0.1,0,0" /> </toy_controller>
 *   <toy-robot id="r"> <body position="0,0,0" /> <controller config="c" /> </toy-robot>
 *   <toy-block id="b" size="1,1,1" movable="false"> <body position="2,0,0" /> </toy-block>
 *   <toy-lamp id="l" position="0,0,1" />
 *   <loop_functions label="toy_loop_functions" />
 */

namespace argos {

/** Stores the velocity order of a toy robot. "toy_motor" */
class CToyMotorEntity : public CEntity {
 public:
  ENABLE_VTABLE()
  explicit CToyMotorEntity(CComposableEntity* parent) : CEntity(parent, "toy_motor_0") {}
  std::string GetTypeDescription() const override { return "toy_motor"; }
  void Reset() override { Velocity = CVector3(); }
  void UpdateDigest(CDigest& digest) const override;

  CVector3 Velocity;  // m/s, world frame
};

/** A disc with a motor and a controller: radius 0.05 m, height 0.1 m, 1 kg. */
class CToyRobotEntity : public CComposableEntity {
 public:
  ENABLE_VTABLE()
  static constexpr Real kRadius = 0.05;
  static constexpr Real kHeight = 0.1;

  CToyRobotEntity();
  CToyRobotEntity(const std::string& id, const std::string& controllerId,
                  const CVector3& position = CVector3(),
                  const CQuaternion& orientation = CQuaternion());
  void Init(TConfigurationNode& tree) override;
  std::string GetTypeDescription() const override { return "toy-robot"; }

  CEmbodiedEntity& GetEmbodiedEntity() { return *m_body; }
  CControllableEntity& GetControllableEntity() { return *m_controller; }
  CToyMotorEntity& GetMotor() { return *m_motor; }

 private:
  void Describe();
  CEmbodiedEntity* m_body = nullptr;
  CToyMotorEntity* m_motor = nullptr;
  CControllableEntity* m_controller = nullptr;
};

/** A box. */
class CToyBlockEntity : public CComposableEntity {
 public:
  ENABLE_VTABLE()
  CToyBlockEntity();
  CToyBlockEntity(const std::string& id, const CVector3& position, const CVector3& size,
                  bool movable = false);
  void Init(TConfigurationNode& tree) override;
  std::string GetTypeDescription() const override { return "toy-block"; }
  CEmbodiedEntity& GetEmbodiedEntity() { return *m_body; }

 private:
  void Describe(const CVector3& size);
  CEmbodiedEntity* m_body = nullptr;
};

/** A positional entity without a body. */
class CToyLampEntity : public CPositionalEntity {
 public:
  ENABLE_VTABLE()
  CToyLampEntity() : CPositionalEntity(nullptr) {}
  explicit CToyLampEntity(const std::string& id) : CPositionalEntity(nullptr, id) {}
  std::string GetTypeDescription() const override { return "toy-lamp"; }
};

/** The interface of a toy robot's motor for controllers. */
class CCI_ToyDriveActuator : public CCI_Actuator {
 public:
  virtual void SetVelocity(const CVector3& velocity) = 0;  // m/s, world frame
};

class CCI_ToyRangeSensor : public CCI_Sensor {
 public:
  /** Distance ahead from the robot's rim to the first body, m; 1 if there is none within 1 m. */
  Real GetRange() const { return m_range; }

 protected:
  Real m_range = 1.0;
};

/** Offers hooks and records calls in order. Recording needs runs without threads. */
class CToyLoopFunctions : public CLoopFunctions {
 public:
  void Init(TConfigurationNode& node) override;
  void Reset() override { Record("reset"); }
  void Destroy() override { Record("destroy"); }
  void PreStep() override;
  void PostStep() override;
  bool IsExperimentFinished() override { return IsFinished && IsFinished(); }
  void PostExperiment() override { Record("post experiment"); }
  void Record(const std::string& event);

  std::vector<std::string> Events;
  bool IsRecording = false;
  std::function<void()> OnPreStep;
  std::function<void()> OnPostStep;
  std::function<bool()> IsFinished;
};

/** Drives at <params velocity="x,y,z">, or as OnStep orders. */
class CToyController : public CCI_Controller {
 public:
  CToyController();
  ~CToyController() override;
  void Init(TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;
  void Destroy() override;

  CVector3 Velocity;  // m/s
  UInt32 Steps = 0;  // since the start or the last Reset()
  Real LastRange = -1.0;
  std::function<void(CToyController&)> OnStep;
  bool ThrowsInDestroy = false;

  // counted in the whole process
  static std::atomic<int> NumInits;
  static std::atomic<int> NumAlive;

 private:
  void Record(const std::string& event);
  CCI_ToyDriveActuator* m_drive = nullptr;
  CCI_ToyRangeSensor* m_range = nullptr;
};

/** Moves bodies at the velocity of their motor; bodies pass through each other. */
class CToyEngine : public CPhysicsEngine {
 public:
  CToyEngine();
  ~CToyEngine() override;
  void Init(TConfigurationNode& tree) override;
  void Reset() override;
  void Update() override;
  size_t GetNumPhysicsModels() override;
  bool AddEntity(CEntity& entity) override;
  bool RemoveEntity(CEntity& entity) override;
  void CheckIntersectionWithRay(TEmbodiedEntityIntersectionData&, const CRay3&) const override {}
  bool HasBodiesOutsideIndex() const override { return false; }

 private:
  class CModel;
  std::string m_refuses;  // type of entity that it does not accept
  std::vector<std::unique_ptr<CModel>> m_models;
};

class CToyMedium : public CMedium {
 public:
  void Update() override;
  void PostSpaceInit() override { WasPostSpaceInit = true; }
  bool WasPostSpaceInit = false;
};

}  // namespace argos

#endif
