#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_ENTITY_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_ENTITY_H

#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/generic/simulator/differential_drive_robot_entity.h>

namespace argos {

class CBatteryEquippedEntity;
class CFootBotDistanceScannerEquippedEntity;
class CFootBotTurretEntity;
class CGripperEquippedEntity;
class CGroundSensorEquippedEntity;
class CLightSensorEquippedEntity;
class COmnidirectionalCameraEquippedEntity;
class CPerspectiveCameraEquippedEntity;
class CRABEquippedEntity;

/**
 * The foot-bot of the Swarmanoid project: 17 cm across, with wheels and tracks, 24 proximity
 * sensors, 12 LEDs and a beacon on a turret.
 *
 * Source: M. Bonani et al., "The marXbot, a miniature mobile robot opening new perspectives for the
 * collective-robotic research", IROS 2010; numbers in footbot_measures.h.
 */
class CFootBotEntity : public CDifferentialDriveRobotEntity {
 public:
  ENABLE_VTABLE();

  CFootBotEntity();
  /**
   * Creates a robot with its controller, and calls the controller's Init().
   *
   * The parameters of range and bearing, battery and cameras are checked here.
   * @param controllerId           `id` of a child of `<controllers>`; empty for none.
   * @param position, orientation  m, world frame.
   * @param rabRange               range of messages, m, >= 0.
   * @param rabDataSize            bytes of a message.
   * @param batteryModel           label of the discharge model; empty: constant charge.
   * @param omnicamAperture        half angle of the view from the downward vertical, in (0, 90)
   * deg.
   * @param perspcamFront          true: looks ahead; false: looks up.
   * @param perspcamAperture       half angle of the view, in (0, 90) degrees.
   * @param perspcamFocalLength, perspcamRange  m, > 0.
   * @throws CARGoSException if a parameter is out of range, or the controller cannot be created.
   */
  CFootBotEntity(const std::string& id, const std::string& controllerId,
                 const CVector3& position = CVector3(),
                 const CQuaternion& orientation = CQuaternion(), Real rabRange = 3.0,
                 size_t rabDataSize = 10, const std::string& batteryModel = "",
                 const CRadians& omnicamAperture = ToRadians(CDegrees(70.0)),
                 bool perspcamFront = true,
                 const CRadians& perspcamAperture = ToRadians(CDegrees(30.0)),
                 Real perspcamFocalLength = 0.035, Real perspcamRange = 2.0);

  void Init(TConfigurationNode& tree) override;
  std::string GetTypeDescription() const override { return "foot-bot"; }

  /** Components that are created on the first call; see CRobotEntity. */
  CBatteryEquippedEntity& GetBatterySensorEquippedEntity();
  CFootBotDistanceScannerEquippedEntity& GetDistanceScannerEquippedEntity();
  CGripperEquippedEntity& GetGripperEquippedEntity();
  CFootBotTurretEntity& GetTurretEntity();
  CGroundSensorEquippedEntity& GetGroundSensorEquippedEntity();
  CLightSensorEquippedEntity& GetLightSensorEquippedEntity();
  COmnidirectionalCameraEquippedEntity& GetOmnidirectionalCameraEquippedEntity();
  CPerspectiveCameraEquippedEntity& GetPerspectiveCameraEquippedEntity();
  CRABEquippedEntity& GetRABEquippedEntity();
};

}  // namespace argos

#endif
