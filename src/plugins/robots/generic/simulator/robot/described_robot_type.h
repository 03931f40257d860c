#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_DESCRIBED_ROBOT_TYPE_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_DESCRIBED_ROBOT_TYPE_H

#include <argos3/core/simulator/entity/entity_type.h>
#include <argos3/plugins/robots/generic/simulator/differential_drive_robot_entity.h>
#include <argos3/plugins/simulator/entities/ground_sensor_equipped_entity.h>

#include <memory>
#include <string>
#include <utility>

namespace argos {

/** What the robots of a type share that an experiment file describes. */
struct SDescribedRobotType : SRobotType {
  /** Devices that robots have on demand. */
  struct SDevices {
    std::shared_ptr<const SRayLayout> Lights;
    std::shared_ptr<const SGroundSensorLayout> Ground;
    CVector3 RABOffset; /**< m, in the frame of the body, like the next three */
    CVector3 OmnidirectionalCameraOffset;
    CVector3 PerspectiveCameraOffset;
    CQuaternion PerspectiveCameraOrientation;
  };

  std::string Tag;
  SDevices Devices;
  CSharedBodies Bodies;

  SDescribedRobotType(SRobotType&& type, const SBodyDescription& body, const std::string& tag,
                      const SDevices& devices)
      : SRobotType(std::move(type)), Tag(tag), Devices(devices), Bodies(body) {}
};

/** `<robot-type>`: a robot on wheels or with propellers that an experiment file describes. */
class CDescribedRobotType : public CEntityType {
 public:
  void Init(TConfigurationNode& tree) override;
  std::unique_ptr<CEntity> New() const override;

 private:
  std::unique_ptr<const SDescribedRobotType> m_type;
};

}  // namespace argos

#endif
