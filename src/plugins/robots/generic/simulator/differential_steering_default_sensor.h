#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DIFFERENTIAL_STEERING_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DIFFERENTIAL_STEERING_DEFAULT_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_sensor.h>

#include <memory>

namespace argos {

class CControllableEntity;
class CWheeledEntity;

/** Encoders: how the wheels turn, which is not how far the robot gets if it slips or pushes. */
class CDifferentialSteeringDefaultSensor : public CSimulatedSensor,
                                           public CCI_DifferentialSteeringSensor {
 public:
  /** @throws CARGoSException unless the robot has "wheels", two of them. */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `vel_noise_range` (cm/s) and `dist_noise_range` (cm). */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  void Reset() override;

 private:
  struct SNoise {
    CRange<Real> Velocity;  // cm/s
    CRange<Real> Distance;  // cm
    CRandomStream Stream;
  };

  CRandomStream MakeStream() const;
  void AddNoise();

  const CWheeledEntity* m_wheels = nullptr;  // of the robot
  CControllableEntity* m_robot = nullptr;
  std::unique_ptr<SNoise> m_noise;  // only with noise
};

}  // namespace argos

#endif
