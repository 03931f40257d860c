#ifndef ARGOS3_TESTING_DETERMINISM_WATCHERS_H
#define ARGOS3_TESTING_DETERMINISM_WATCHERS_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_omnidirectional_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/testing/support/experiment.h>

namespace argos {

/** "watcher": goes where its cameras see lights, and shows which way it turns. */
class CWatcher : public CCI_Controller {
 public:
  /** Reads `moving`: false turns on the spot at a speed that does not depend on what it sees. */
  void Init(TConfigurationNode& params) override;
  void ControlStep() override;

 private:
  CVector2 SumUpSights() const;

  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  CCI_LEDsActuator* m_leds = nullptr;
  CCI_ColoredBlobOmnidirectionalCameraSensor* m_allAround = nullptr;
  bool m_moving = true;
};

/**
 * Foot-bots in rows, with all cameras and LEDs, noisy if @p noisy.
 * @param moving  see CWatcher::Init().
 */
SExperiment Watchers(UInt32 robots, bool moving, bool noisy);

}  // namespace argos

#endif
