#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_DIFFERENTIAL_DRIVE_ROBOT_ENTITY_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_DIFFERENTIAL_DRIVE_ROBOT_ENTITY_H

#include <argos3/core/simulator/geometry/body_description.h>
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
 * Body descriptions of the robots of one type, which differ only in the limits of their drives.
 *
 * Robots with equal drives share one description. Thread-safe.
 */
class CSharedBodies {
 public:
  /** @param body the description with the default drive of the type. */
  explicit CSharedBodies(const SBodyDescription& body);

  const SBodyDescription& GetDefault() const { return *m_default; }
  const std::shared_ptr<const SBodyDescription>& GetSharedDefault() const { return m_default; }
  /** @return the description with drive @p drive. */
  std::shared_ptr<const SBodyDescription> Get(const SDifferentialDriveDescription& drive) const;

 private:
  std::shared_ptr<const SBodyDescription> m_default;
  mutable std::mutex m_mutex;
  mutable std::vector<std::weak_ptr<const SBodyDescription>>
      m_nonDefault;  // bodies that at least one robot uses
};

/**
 * Describes a cylinder on two driven wheels.
 * @param radius, height         m.
 * @param mass, planarInertia    kg, kg m^2.
 */
SBodyDescription DescribeWheeledCylinder(Real radius, Real height, Real mass, Real planarInertia,
                                         const SDifferentialDriveDescription& drive);

/**
 * Reads the limits of a drive from the child `<dynamics2d><differential_steering max_force="..."
 * max_torque="..." /></dynamics2d>`.
 * @return false if there is none. @throws CARGoSException if a limit is not > 0.
 */
bool ReadDriveLimits(TConfigurationNode& tree, SDifferentialDriveDescription& drive);

/** Adds the component "wheels" of a robot whose description has a Drive; owned by the robot. */
CWheeledEntity& AddWheels(CComposableEntity& robot, const SDifferentialDriveDescription& drive);

/** The properties that all robots of a type with two driven wheels share. */
struct SDifferentialDriveRobotType : SRobotType {
  CSharedBodies Bodies;

  SDifferentialDriveRobotType(SRobotType&& type, const SBodyDescription& body)
      : SRobotType(std::move(type)), Bodies(body) {}
};

/** Base of robots with two driven wheels. */
class CDifferentialDriveRobotEntity : public CRobotEntity {
 public:
  CWheeledEntity& GetWheeledEntity() { return *m_wheels; }
  const CWheeledEntity& GetWheeledEntity() const { return *m_wheels; }

 protected:
  /**
   * Creates all components, without the controller itself.
   * @param type                   must outlive the robot.
   * @param position, orientation  of the body, m, world frame.
   */
  CDifferentialDriveRobotEntity(const SDifferentialDriveRobotType& type, const std::string& id,
                                const CVector3& position, const CQuaternion& orientation);

  /**
   * Reads `id`, `<body>`, and the limits of the drive in `<dynamics2d><differential_steering
   * max_force="..." max_torque="..." /></dynamics2d>`. Call
   * InitController() afterwards.
   */
  void InitParts(TConfigurationNode& tree);

 private:
  const CSharedBodies& m_bodies;  // shared by all robots of the type
  CWheeledEntity* m_wheels = nullptr;  // a component
};

}  // namespace argos

#endif
