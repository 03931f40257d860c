#ifndef ARGOS3_TESTING_DETERMINISM_WATCHERS_H
#define ARGOS3_TESTING_DETERMINISM_WATCHERS_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_omnidirectional_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_perspective_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_directional_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pan_tilt_camera_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_tags_actuator.h>
#include <argos3/testing/support/experiment.h>

namespace argos {

/** "watcher": drives towards lights seen by its cameras, and shows its direction by LEDs. */
class CWatcher : public CCI_Controller {
 public:
  /** Reads `moving`: if false, it turns in place at a speed that does not depend on readings. */
  void Init(TConfigurationNode& params) override;
  void ControlStep() override;
  /** Number of readings of each kind. */
  struct SSights {
    size_t LEDs = 0;
    size_t Signals = 0;  // directional LEDs
    size_t Tags = 0;
  };
  SSights CountSights() const;

 private:
  CVector2 SumUpSights() const;
  void Show(const CVector2& sum);

  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  CCI_LEDsActuator* m_leds = nullptr;
  CCI_DirectionalLEDsActuator* m_signals = nullptr;
  CCI_TagsActuator* m_tags = nullptr;
  CCI_PanTiltCameraActuator* m_head = nullptr;
  CCI_ColoredBlobOmnidirectionalCameraSensor* m_allAround = nullptr;
  CCI_ColoredBlobPerspectiveCameraSensor* m_ahead = nullptr;
  CCI_CameraSensor* m_cameras = nullptr;
  bool m_moving = true;
};

/**
 * Foot-bots in rows, with all cameras, LEDs and tags, with noise if @p noisy.
 * @param moving  see CWatcher::Init().
 */
SExperiment Watchers(UInt32 robots, bool moving, bool noisy);

}  // namespace argos

#endif
