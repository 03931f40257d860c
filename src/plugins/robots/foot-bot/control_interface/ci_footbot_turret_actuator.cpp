#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_turret_actuator.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/wrappers/lua/lua_table.h>

#include <cmath>
#include <limits>

namespace argos {

const CRange<SInt32> CCI_FootBotTurretActuator::SPEED_RANGE(-4, 4);
const CRange<Real> CCI_FootBotTurretActuator::NORMALIZED_SPEED_RANGE(-1.0, 1.0);

void CCI_FootBotTurretActuator::SetActiveWithRotation(const CRadians& angle) {
  SetPositionControlMode();
  SetRotation(angle);
}

void CCI_FootBotTurretActuator::SetSpeedControlMode() {
  SetMode(MODE_SPEED_CONTROL);
}

void CCI_FootBotTurretActuator::SetPositionControlMode() {
  SetMode(MODE_POSITION_CONTROL);
}

void CCI_FootBotTurretActuator::SetPassiveMode() {
  SetMode(MODE_PASSIVE);
}

void CCI_FootBotTurretActuator::CreateLuaState(lua_State* state) {
  CLuaTable turret(state, *this, "turret");
  turret.AddMethod<&CCI_FootBotTurretActuator::SetRotation>("set_rotation", *this);
  turret.AddFunction("set_rotation_speed", *this, [](CCI_FootBotTurretActuator& self, Real rpm) {
    constexpr Real kMax = std::numeric_limits<SInt32>::max();
    if (!(std::abs(rpm) <= kMax)) {
      THROW_ARGOSEXCEPTION("the speed (turns per minute) must be a number, got " << rpm);
    }
    self.SetRotationSpeed(static_cast<SInt32>(rpm));
  });
  turret.AddMethod<&CCI_FootBotTurretActuator::SetPassiveMode>("set_passive_mode", *this);
  turret.AddMethod<&CCI_FootBotTurretActuator::SetPositionControlMode>("set_position_control_mode",
                                                                       *this);
  turret.AddMethod<&CCI_FootBotTurretActuator::SetSpeedControlMode>("set_speed_control_mode",
                                                                    *this);
}

}  // namespace argos
