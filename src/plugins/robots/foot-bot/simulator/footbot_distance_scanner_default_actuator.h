#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_DISTANCE_SCANNER_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_DISTANCE_SCANNER_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_distance_scanner_actuator.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_distance_scanner_equipped_entity.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

#include <optional>

namespace argos {

class CControllableEntity;

/** The motor of the foot-bot's distance scanner. */
class CFootBotDistanceScannerDefaultActuator : public CSimulatedActuator,
                                               public CCI_FootBotDistanceScannerActuator {
 public:
  /** @throws CARGoSException if the robot has no "distance_scanner" or "controller". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `<noise>`. */
  void Init(TConfigurationNode& tree) override;
  void SetAngle(const CRadians& angle) override;
  void SetRPM(Real rpm) override;
  void Enable() override;
  void Disable() override;
  void Update() override;
  void Reset() override;

 private:
  typedef CFootBotDistanceScannerEquippedEntity TScanner;

  void RequireFinite(Real value, const char* what) const;

  TScanner* m_scanner = nullptr;
  const CControllableEntity* m_robot = nullptr;
  CDeviceNoise m_noise;
  // last commands of the controller
  TScanner::EMode m_mode = TScanner::MODE_OFF;
  std::optional<CRadians> m_angle;  // target angle, until the next Update()
  Real m_speed = 0.0;  // rad/s
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#endif

#endif
