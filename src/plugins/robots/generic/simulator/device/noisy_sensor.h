#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_NOISY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_NOISY_SENSOR_H

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

namespace argos {

/**
 * Base of the sensors that read components of their robot, with noise.
 * @tparam INTERFACE  the control interface.
 */
template <class INTERFACE>
class CNoisySensor : public CSimulatedSensor, public INTERFACE {
 public:
  /** @throws CARGoSException if the robot has no "controller", or lacks another component. */
  void SetRobot(CComposableEntity& robot) override {
    m_robot = &robot.GetComponent<CControllableEntity>("controller");
    FindParts(robot);
  }
  /** Reads `<noise>`, and the attributes of the sensor. */
  void Init(TConfigurationNode& tree) override {
    INTERFACE::Init(tree);
    Configure(tree);
    this->Enable();
  }
  void Reset() override {
    ResetReading();
    m_noise.Reset();
  }

 protected:
  CControllableEntity* m_robot = nullptr;
  CDeviceNoise m_noise;

 private:
  /** Looks up the components that the sensor reads. */
  virtual void FindParts(CComposableEntity& /*robot*/) {}
  /** Reads the attributes, and calls m_noise.Init(). */
  virtual void Configure(TConfigurationNode& tree) = 0;
  /** Sets the reading to that at the start. */
  virtual void ResetReading() = 0;
};

}  // namespace argos

#endif
