#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_DIFFERENTIAL_DRIVE_ROBOT_ENTITY_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_DIFFERENTIAL_DRIVE_ROBOT_ENTITY_H

#include <argos3/core/simulator/physics_engine/body_description.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/robots/generic/simulator/robot_entity.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>

#include <memory>
#include <mutex>
#include <string>
#include <utility>
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
struct SDifferentialDriveRobotType : SRobotType {
  CSharedBodies Bodies;

  SDifferentialDriveRobotType(SRobotType&& type, const SBodyDescription& body)
      : SRobotType(std::move(type)), Bodies(body) {}
};

/** A robot with two driven wheels: what such robots have in common. */
class CDifferentialDriveRobotEntity : public CRobotEntity {
 public:
  CWheeledEntity& GetWheeledEntity() { return *m_wheels; }
  const CWheeledEntity& GetWheeledEntity() const { return *m_wheels; }

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

 private:
  void MakeWheels();

  const CSharedBodies& m_bodies;  // of the type
  CWheeledEntity* m_wheels = nullptr;  // a component
};

}  // namespace argos

#endif
