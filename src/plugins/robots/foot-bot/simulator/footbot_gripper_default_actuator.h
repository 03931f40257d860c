#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_GRIPPER_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_GRIPPER_DEFAULT_ACTUATOR_H

#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_gripper_actuator.h>
#include <argos3/plugins/robots/generic/simulator/gripper_actuator.h>

namespace argos {

/** Rotates the claw of a foot-bot's gripper; see the manual in the source. */
class CFootBotGripperDefaultActuator
    : public CGripperActuator<CCI_FootBotGripperActuator, CRadians> {
 public:
  /** No effect: a simulated gripper never closes on nothing. */
  void EnableCheckForObjectGrippedRoutine() override {}
  void DisableCheckForObjectGrippedRoutine() override {}

 private:
  const char* GetQuantity() const override { return "aperture"; }
  CRadians GetOrder() const override { return m_cAperture; }
  CRadians AddNoise(const CRadians& aperture) override;
  Real ComputeLockState(const CRadians& aperture) const override {
    return Abs(aperture) / CRadians::PI_OVER_TWO;
  }
};

}  // namespace argos

#endif
