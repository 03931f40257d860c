#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_FLIGHT_QUADROTOR_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_FLIGHT_QUADROTOR_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/generic/simulator/quadrotor_control.h>

namespace argos {

/**
 * Base of the actuators that set the target of a flying robot, which holds until it is replaced.
 * @tparam INTERFACE  the control interface.
 * @tparam TARGET     the control data of CQuadRotorEntity.
 */
template <class INTERFACE, class TARGET>
class CQuadRotorActuator : public CSimulatedActuator, public INTERFACE {
 public:
  void Update() override { m_control.Command(m_target); }
  void Reset() override {
    m_target = MakeStartTarget();
    m_noise.Reset();
  }

 protected:
  /** The target at the start and after a reset. */
  virtual TARGET MakeStartTarget() const = 0;
  /** @throws CARGoSException if the target is not finite. */
  void Set(const TARGET& target) {
    m_control.GetQuadRotor().Check(target);
    m_target = target;
  }

  CQuadRotorControl m_control;
  TARGET m_target;  // target with noise
  CDeviceNoise m_noise;
};

}  // namespace argos

#endif
