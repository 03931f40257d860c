#ifndef ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_DRIVE_WORLD_H
#define ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_DRIVE_WORLD_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/testing/support/experiment.h>

#include <string>

namespace argos {

/** "contract_driver": sets constant wheel speeds, which a test may change. */
class CContractDriver : public CCI_Controller {
 public:
  /** Reads left and right, cm/s, default 0. */
  void Init(TConfigurationNode& params) override;
  void ControlStep() override { m_wheels->SetLinearVelocity(Left, Right); }

  Real Left = 0.0, Right = 0.0;  // cm/s

 private:
  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
};

/** XML of a robot. @param tag "foot-bot" or "e-puck". @param yaw degrees. @param left cm/s. */
std::string DriverXml(const std::string& tag, const std::string& id, Real x, Real y, Real yaw,
                      Real left, Real right);

/** XML of a box that cannot move. @param size "x,y,z", m. @param yaw degrees. */
std::string WallXml(const std::string& id, const std::string& size, Real x, Real y, Real yaw = 0.0);
/** XML of a box of 1 kg that can be pushed. @param yaw degrees. @param size "x,y,z", m. */
std::string BoxXml(const std::string& id, Real x, Real y, Real yaw = 0.0,
                   const std::string& size = "0.2,0.2,0.1");

/** A world of such robots and of objects, with accessors to their state. */
class CDriveWorld : public CTestWorld {
 public:
  /** @param engine XML of the engine. @param arena XML of the entities. */
  CDriveWorld(const std::string& engine, const std::string& arena, UInt32 threads = 0);
  explicit CDriveWorld(const SExperiment& experiment);
  /** Such an experiment in a large arena. */
  static SExperiment Describe(const std::string& engine, const std::string& arena,
                              UInt32 threads = 0);

  CEmbodiedEntity& Body(const std::string& id);
  CVector3 Position(const std::string& id) { return Body(id).GetOriginAnchor().Position; }
  /**
   * The point of a robot's axis 1.5 cm above its base, m, where the solids of foot-bots and e-pucks
   * in dynamics3d begin: of robots that lean, only what is above can overlap.
   */
  CVector3 Foot(const std::string& id);
  /** Heading, rad. */
  Real Yaw(const std::string& id);
  CContractDriver& Driver(const std::string& id);
  /** Id of the one engine that contains the body. */
  std::string EngineOf(const std::string& id);
  /** Angle between the body's z axis and the vertical, rad. */
  Real Tilt(const std::string& id);
  /** Motion of the body as reported by its engine. */
  SBodyMotion Motion(const std::string& id);
  /**
   * Sets the velocity of a body, m/s. Needs a tick before, because engines with momentum create
   * their bodies in the first.
   */
  void Launch(const std::string& id, const CVector3& velocity);
  /** Replaces a body's solids by one. The description of its drive is kept. */
  void Reshape(const std::string& id, const SShapeDescription& shape);

 private:
  CSimulator::CScope m_scope;
};

}  // namespace argos

#endif
