#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GRIPPING_GRIPPER_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GRIPPING_GRIPPER_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>

namespace argos {

/**
 * Base of the actuators of a gripper, whose controller sets one value.
 *
 * Noise is drawn whenever the controller changes the value. A reset unlocks the gripper.
 * @tparam INTERFACE  the control interface.
 * @tparam VALUE      Real, or CRadians.
 */
template <class INTERFACE, class VALUE>
class CGripperActuator : public CSimulatedActuator, public INTERFACE {
 public:
  /** @throws CARGoSException if the robot has no "gripper" or "controller". */
  void SetRobot(CComposableEntity& robot) override {
    m_gripper = &robot.GetComponent<CGripperEquippedEntity>("gripper");
    m_robot = &robot.GetComponent<CControllableEntity>("controller");
  }
  /** Reads `<noise>`. */
  void Init(TConfigurationNode& tree) override {
    INTERFACE::Init(tree);
    m_noise.Init(tree, *m_robot, {GetQuantity()});
  }
  void Update() override {
    if (GetOrder() != m_ordered) {
      m_ordered = GetOrder();
      m_applied = AddNoise(m_ordered);
    }
    m_gripper->SetLockState(ComputeLockState(m_applied));
  }
  void Reset() override {
    this->Unlock();
    m_ordered = m_applied = GetOrder();
    m_noise.Reset();
  }

 protected:
  CDeviceNoise& GetNoise() { return m_noise; }

 private:
  /** Name of the value for `<noise>`. */
  virtual const char* GetQuantity() const = 0;
  /** What the controller has set. */
  virtual VALUE GetOrder() const = 0;
  virtual VALUE AddNoise(const VALUE& value) = 0;
  /** In [0,1]; see CGripperEquippedEntity. */
  virtual Real ComputeLockState(const VALUE& value) const = 0;

  CGripperEquippedEntity* m_gripper = nullptr;
  const CControllableEntity* m_robot = nullptr;
  VALUE m_ordered{};  // last value set by the controller
  VALUE m_applied{};  // value with noise
  CDeviceNoise m_noise;
};

}  // namespace argos

#endif
