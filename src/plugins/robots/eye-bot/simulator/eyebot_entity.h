#ifndef ARGOS3_PLUGINS_ROBOTS_EYE_BOT_SIMULATOR_EYEBOT_ENTITY_H
#define ARGOS3_PLUGINS_ROBOTS_EYE_BOT_SIMULATOR_EYEBOT_ENTITY_H

#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/generic/simulator/robot_entity.h>
#include <argos3/plugins/simulator/entities/quadrotor_entity.h>

namespace argos {

class CBatteryEquippedEntity;
class CFootBotDistanceScannerEquippedEntity;
class CLightSensorEquippedEntity;
class CPerspectiveCameraEquippedEntity;
class CRABEquippedEntity;

/**
 * The eye-bot of the Swarmanoid project: a flying robot, 50 cm across, with 24 proximity sensors,
 * two rings of 16 LEDs, and one LED under an arm. Needs a physics engine in which robots fly.
 *
 * Source: J. F. Roberts et al., "Quadrotor using minimal sensing for autonomous indoor flight",
 * European Micro Air Vehicle Conference, 2007; numbers in eyebot_measures.h.
 */
class CEyeBotEntity : public CRobotEntity {
 public:
  ENABLE_VTABLE();

  CEyeBotEntity();
  /**
   * Creates a robot with its controller, and calls the controller's Init().
   *
   * The parameters of range and bearing, battery and camera are checked here.
   * @param controllerId           `id` of a child of `<controllers>`; empty for none.
   * @param position, orientation  m, world frame.
   * @param rabRange               range of messages, m, >= 0.
   * @param rabDataSize            bytes of a message.
   * @param batteryModel           label of the discharge model; empty: constant charge.
   * @param perspcamAperture       half angle of the view straight down, in (0, 90) degrees.
   * @param perspcamFocalLength, perspcamRange  m, > 0.
   * @throws CARGoSException if a parameter is out of range, or the controller cannot be created.
   */
  CEyeBotEntity(const std::string& id, const std::string& controllerId,
                const CVector3& position = CVector3(),
                const CQuaternion& orientation = CQuaternion(), Real rabRange = 3.0,
                size_t rabDataSize = 10, const std::string& batteryModel = "",
                const CRadians& perspcamAperture = ToRadians(CDegrees(30.0)),
                Real perspcamFocalLength = 0.035, Real perspcamRange = 2.0);

  void Init(TConfigurationNode& tree) override;
  std::string GetTypeDescription() const override { return "eye-bot"; }

  CQuadRotorEntity& GetQuadRotorEntity() { return *m_quadrotor; }
  const CQuadRotorEntity& GetQuadRotorEntity() const { return *m_quadrotor; }

  /** Components that are created on the first call; see CRobotEntity. */
  CBatteryEquippedEntity& GetBatterySensorEquippedEntity();
  CFootBotDistanceScannerEquippedEntity& GetDistanceScannerEquippedEntity();
  CLightSensorEquippedEntity& GetLightSensorEquippedEntity();
  CPerspectiveCameraEquippedEntity& GetPerspectiveCameraEquippedEntity();
  CRABEquippedEntity& GetRABEquippedEntity();

 private:
  CEyeBotEntity(const std::string& id, const CVector3& position, const CQuaternion& orientation);

  CQuadRotorEntity* m_quadrotor = nullptr;  // a component
};

}  // namespace argos

#endif
