#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_gripper_actuator.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/wrappers/lua/lua_table.h>

#include <cmath>

namespace argos {

CRadians CCI_FootBotGripperActuator::UNLOCKED(0.0);
CRadians CCI_FootBotGripperActuator::LOCKED_POSITIVE(CRadians::PI_OVER_TWO);
CRadians CCI_FootBotGripperActuator::LOCKED_NEGATIVE(-CRadians::PI_OVER_TWO);

CCI_FootBotGripperActuator::CCI_FootBotGripperActuator() : m_cAperture(UNLOCKED) {}

void CCI_FootBotGripperActuator::SetAperture(const CRadians& aperture) {
  if (!std::isfinite(aperture.GetValue())) {
    THROW_ARGOSEXCEPTION("footbot_gripper: the aperture must be a finite angle, got "
                         << aperture.GetValue() << " rad");
  }
  m_cAperture = aperture;
  m_cAperture.SignedNormalize();
  CRange<CRadians>(-CRadians::PI_OVER_TWO, CRadians::PI_OVER_TWO).TruncValue(m_cAperture);
}

void CCI_FootBotGripperActuator::LockPositive() {
  SetAperture(LOCKED_POSITIVE);
}

void CCI_FootBotGripperActuator::LockNegative() {
  SetAperture(LOCKED_NEGATIVE);
}

void CCI_FootBotGripperActuator::Unlock() {
  SetAperture(UNLOCKED);
}

void CCI_FootBotGripperActuator::CreateLuaState(lua_State* state) {
  CLuaTable gripper(state, *this, "gripper");
  gripper.AddMethod<&CCI_FootBotGripperActuator::LockPositive>("lock_positive", *this);
  gripper.AddMethod<&CCI_FootBotGripperActuator::LockNegative>("lock_negative", *this);
  gripper.AddMethod<&CCI_FootBotGripperActuator::Unlock>("unlock", *this);
}

}  // namespace argos
