#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_TURRET_ENCODER_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_TURRET_ENCODER_SENSOR_H

#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

namespace argos {

/** The rotation of the foot-bot's turret. */
class CCI_FootBotTurretEncoderSensor : public CVirtualTableSensor {
 public:
  static const CRange<CRadians> ANGULAR_RANGE; /**< [-pi, pi] */

  /** @return rotation on the base, in (-pi, pi], counter-clockwise from straight ahead. */
  const CRadians& GetRotation() const { return m_cRotation; }

 protected:
  CRadians m_cRotation;

 private:
  const char* GetLuaName() const override { return "turret"; }
  /** robot.turret.rotation, rad */
  void ListNumbers(CNumberList& list) const override;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/math/vector2.h>
#endif

#endif
