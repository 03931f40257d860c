#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DIFFERENTIAL_DRIVE_ROBOT_ENTITY_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DIFFERENTIAL_DRIVE_ROBOT_ENTITY_H

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/body_description.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/appearance.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/proximity_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace argos {

/**
 * The bodies of robots of one type, which differ in the strength of their drive only.
 *
 * Robots with equal drives share one description, so that a thousand robots hold one. Safe on any
 * thread.
 */
class CSharedBodies {
 public:
  /** @param body the description with the type's usual drive. */
  explicit CSharedBodies(const SBodyDescription& body);

  const SBodyDescription& GetUsual() const { return *m_usual; }
  /** The description with that drive. */
  std::shared_ptr<const SBodyDescription> Get(const SDifferentialDriveDescription& drive) const;

 private:
  std::shared_ptr<const SBodyDescription> m_usual;
  mutable std::mutex m_mutex;
  mutable std::vector<std::weak_ptr<const SBodyDescription>> m_others;  // in use by some robot
};

/** What all robots of a type with two driven wheels have in common. */
struct SDifferentialDriveRobotType {
  CSharedBodies Bodies;
  /** A frame besides "origin" that carries the LEDs, at the origin; empty: the origin does. */
  std::string LEDAnchor;
  std::shared_ptr<const CLEDEquippedEntity::SLayout> LEDs;
  std::shared_ptr<const CProximitySensorEquippedEntity::SLayout> Proximity;
  SAppearance Appearance;
};

/**
 * A robot with two driven wheels, LEDs, and proximity sensors: what such robots have in common.
 */
class CDifferentialDriveRobotEntity : public CComposableEntity {
 public:
  /** Moves the LEDs, if they are in use, to where the body is. */
  void UpdateComponents() override;

  CControllableEntity& GetControllableEntity() { return *m_controllable; }
  const CControllableEntity& GetControllableEntity() const { return *m_controllable; }
  CEmbodiedEntity& GetEmbodiedEntity() { return *m_body; }
  const CEmbodiedEntity& GetEmbodiedEntity() const { return *m_body; }
  CWheeledEntity& GetWheeledEntity() { return *m_wheels; }
  const CWheeledEntity& GetWheeledEntity() const { return *m_wheels; }
  CLEDEquippedEntity& GetLEDEquippedEntity() { return *m_leds; }
  const CLEDEquippedEntity& GetLEDEquippedEntity() const { return *m_leds; }
  CProximitySensorEquippedEntity& GetProximitySensorEquippedEntity() { return *m_proximity; }
  const CProximitySensorEquippedEntity& GetProximitySensorEquippedEntity() const {
    return *m_proximity;
  }

  const SAppearance* GetAppearance() const override { return &m_type.Appearance; }

 protected:
  /**
   * Makes all components, but no controller yet.
   * @param type                   must outlive the robot.
   * @param position, orientation  of the body, m, world frame.
   */
  CDifferentialDriveRobotEntity(const SDifferentialDriveRobotType& type, const std::string& id,
                                const CVector3& position, const CQuaternion& orientation);

  /**
   * Reads `id`, `<body>`, and the limits of the drive in `<dynamics2d><differential_steering
   * max_force="..." max_torque="..." /></dynamics2d>`. The controller comes last: see
   * InitController().
   */
  void InitParts(TConfigurationNode& tree);
  /** Makes the controller, with its devices, that `<controller>` asks for. */
  void InitController(TConfigurationNode& tree);
  /** Makes the controller of that id, if it is not empty. */
  void InitController(const std::string& controllerId);

 private:
  void MakeWheels();

  const SDifferentialDriveRobotType& m_type;
  // components
  CEmbodiedEntity* m_body = nullptr;
  CWheeledEntity* m_wheels = nullptr;
  CLEDEquippedEntity* m_leds = nullptr;
  CProximitySensorEquippedEntity* m_proximity = nullptr;
  CControllableEntity* m_controllable = nullptr;
};

}  // namespace argos

#endif
