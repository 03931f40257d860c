#ifndef ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_ROVER_H
#define ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_ROVER_H

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/entities/planar_drive_entity.h>

#include <string>

namespace argos {

/**
 * "rover": a robot with a planar drive, as third parties write one.
 *
 * XML: `shape` "disc" (default) or "box"; `max_force` (N) and `max_torque` (N m), default 10;
 * `flaw` "two_drives" or "no_component"; `<body>`; optionally `<controller>`.
 */
class CRoverEntity : public CComposableEntity {
 public:
  ENABLE_VTABLE();

  static constexpr Real kRadius = 0.08;  // m
  static constexpr Real kHeight = 0.1;  // m
  static constexpr Real kMass = 0.8;  // kg

  CRoverEntity() : CComposableEntity(nullptr) {}
  void Init(TConfigurationNode& tree) override;
  std::string GetTypeDescription() const override { return "rover"; }
  /** Sets the command of the drive: m/s, m/s, rad/s. */
  void Drive(Real ahead, Real left, Real yawRate);

 private:
  CEmbodiedEntity* m_body = nullptr;
  CControllableEntity* m_controller = nullptr;
  CPlanarDriveEntity* m_drive = nullptr;
};

/** XML of a rover. @param yaw degrees. @param attributes of its element. */
std::string RoverXml(const std::string& id, Real x, Real y, Real yaw = 0.0,
                     const std::string& attributes = "", const std::string& children = "");

}  // namespace argos

#endif
