#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STEERING_DIFFERENTIAL_STEERING_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STEERING_DIFFERENTIAL_STEERING_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

#include <array>
#include <memory>

namespace argos {

class CControllableEntity;
class CWheeledEntity;

/**
 * Sets both wheel speeds of a robot, with optional noise.
 *
 * With noise, a wheel whose speed is set to v rolls at f (v + b) unless both speeds are 0: f is
 * drawn from a Gaussian at each command, b from another one once at the start of the experiment.
 */
class CDifferentialSteeringDefaultActuator : public CSimulatedActuator,
                                             public CCI_DifferentialSteeringActuator {
 public:
  /** @throws CARGoSException if the robot does not have two "wheels". */
  void SetRobot(CComposableEntity& robot) override;
  /**
   * Reads the parameters of the noise, and `<noise>` children.
   * @throws CARGoSException if a deviation is negative.
   */
  void Init(TConfigurationNode& tree) override;
  /** @throws CARGoSException if a speed is not finite. */
  void SetLinearVelocity(Real left, Real right) override;
  void Update() override;
  void Reset() override;

  /**
   * From the next tick on, the wheels turn at these speeds, without noise. What the controller sets
   * meanwhile counts from the end of it, or of a reset, on. For views whose users drive robots.
   * @param left, right  as for SetLinearVelocity(), finite.
   */
  void Override(Real left, Real right);
  void EndOverride() { m_override.reset(); }

 protected:
  CWheeledEntity& GetWheels() const { return *m_wheels; }
  /** The speeds of left and right wheel now, m/s: of the controller, or those that override them.
   */
  const Real* GetSpeeds() const {
    return m_override == nullptr ? m_fCurrentVelocity : m_override->data();
  }
  const CControllableEntity& GetRobot() const { return *m_robot; }

 private:
  struct SWheelNoise {
    Real BiasAverage = 0.0, BiasDeviation = 0.0;  // m/s
    Real FactorAverage = 1.0, FactorDeviation = 0.0;
    Real Bias = 0.0;  // m/s, drawn
  };
  struct SNoise {
    SWheelNoise Wheels[2];  // left, right
    CRandomStream Stream;
  };

  CRandomStream MakeStream() const;
  void DrawBiases();

  CWheeledEntity* m_wheels = nullptr;
  CControllableEntity* m_robot = nullptr;
  std::unique_ptr<SNoise> m_wheelNoise;  // null without this noise
  std::unique_ptr<std::array<Real, 2>> m_override;  // m/s; null: none
  CDeviceNoise m_noise;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>
#endif

#endif
