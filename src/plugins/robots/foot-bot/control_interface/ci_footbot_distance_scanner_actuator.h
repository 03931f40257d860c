#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_DISTANCE_SCANNER_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_DISTANCE_SCANNER_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>

namespace argos {

/**
 * The motor of the distance scanner of the foot-bot. It is off at the start. The last call in a
 * step takes effect in the next tick.
 */
class CCI_FootBotDistanceScannerActuator : virtual public CCI_Actuator {
 public:
  /**
   * Rotates the scanner to an angle at once, and holds it there.
   * @param angle  of the first short-range head, counter-clockwise from ahead.
   * @throws CARGoSException if it is not finite.
   */
  virtual void SetAngle(const CRadians& angle) = 0;
  /**
   * Rotates the scanner continuously.
   * @param rpm  turns per minute, positive counter-clockwise.
   * @throws CARGoSException if it is not finite.
   */
  virtual void SetRPM(Real rpm) = 0;
  /** Switches it on; it holds its angle. */
  virtual void Enable() = 0;
  /** Switches it off. */
  virtual void Disable() = 0;

  /** robot.distance_scanner.enable(), .disable(), .set_angle(rad), .set_rpm(rpm) */
  void CreateLuaState(lua_State* state) override;
};

}  // namespace argos

#endif
