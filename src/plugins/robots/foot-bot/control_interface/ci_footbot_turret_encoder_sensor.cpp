#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_turret_encoder_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

const CRange<CRadians> CCI_FootBotTurretEncoderSensor::ANGULAR_RANGE(-CRadians::PI, CRadians::PI);

void CCI_FootBotTurretEncoderSensor::CreateLuaState(lua_State* state) {
  CLuaTable turret(state, *this, "turret");
  turret.Set("rotation", m_cRotation);
}

void CCI_FootBotTurretEncoderSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable turret(state, *this);
  turret.Set("rotation", m_cRotation);
}

}  // namespace argos
