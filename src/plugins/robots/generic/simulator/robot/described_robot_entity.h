#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_DESCRIBED_ROBOT_ENTITY_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_DESCRIBED_ROBOT_ENTITY_H

#include <argos3/plugins/robots/generic/simulator/described_robot_type.h>
#include <argos3/plugins/robots/generic/simulator/robot_entity.h>

#include <string>

namespace argos {

/** A robot whose type an experiment file describes; see CDescribedRobotType. */
class CDescribedRobotEntity : public CRobotEntity {
 public:
  ENABLE_VTABLE();

  /** @param type  must outlive the robot. */
  explicit CDescribedRobotEntity(const SDescribedRobotType& type);

  /** Reads the element of a robot: that of the built-in robots. */
  void Init(TConfigurationNode& tree) override;
  std::string GetTypeDescription() const override { return m_described.Tag; }

  const SDescribedRobotType& GetType() const { return m_described; }

 private:
  void ReadDrive(TConfigurationNode& tree);

  const SDescribedRobotType& m_described;
};

}  // namespace argos

#endif
