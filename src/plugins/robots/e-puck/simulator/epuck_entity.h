#ifndef ARGOS3_PLUGINS_ROBOTS_E_PUCK_SIMULATOR_EPUCK_ENTITY_H
#define ARGOS3_PLUGINS_ROBOTS_E_PUCK_SIMULATOR_EPUCK_ENTITY_H

#include <argos3/plugins/robots/generic/simulator/differential_drive_robot_entity.h>

namespace argos {

class CBatteryEquippedEntity;
class CGroundSensorEquippedEntity;
class CLightSensorEquippedEntity;
class CRABEquippedEntity;

/**
 * The e-puck: 7 cm across, with two wheels, eight proximity sensors, and eight LEDs.
 *
 * Source: F. Mondada et al., "The e-puck, a robot designed for education in engineering", Proc. 9th
 * Conference on Autonomous Robot Systems and Competitions, 2009; numbers in epuck_measures.h.
 */
class CEPuckEntity : public CDifferentialDriveRobotEntity {
 public:
  ENABLE_VTABLE();

  CEPuckEntity();
  /**
   * Creates a robot with its controller, and calls the controller's Init().
   *
   * The parameters of range and bearing and of the battery are checked here.
   * @param controllerId           `id` of a child of `<controllers>`; empty for none.
   * @param position, orientation  m, world frame.
   * @param rabRange               range of messages, m, >= 0.
   * @param rabDataSize            bytes of a message.
   * @param batteryModel           label of the discharge model; empty: constant charge.
   * @throws CARGoSException if a parameter is out of range, or the controller cannot be created.
   */
  CEPuckEntity(const std::string& id, const std::string& controllerId,
               const CVector3& position = CVector3(),
               const CQuaternion& orientation = CQuaternion(), Real rabRange = 0.8,
               size_t rabDataSize = 2, const std::string& batteryModel = "");

  void Init(TConfigurationNode& tree) override;
  std::string GetTypeDescription() const override { return "e-puck"; }

  /** Components that are created on the first call; see CRobotEntity. */
  CBatteryEquippedEntity& GetBatterySensorEquippedEntity();
  CGroundSensorEquippedEntity& GetGroundSensorEquippedEntity();
  CLightSensorEquippedEntity& GetLightSensorEquippedEntity();
  CRABEquippedEntity& GetRABEquippedEntity();
};

}  // namespace argos

#endif
