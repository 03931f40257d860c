#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_led_detector_algorithm.h>
#include <argos3/plugins/robots/generic/simulator/camera_detector.h>
#include <argos3/plugins/simulator/entities/led_entity.h>
#include <argos3/plugins/simulator/media/led_medium.h>

namespace argos {

namespace {

/** Detects LEDs and lights in the images of a camera. */
class CCameraLEDDetector
    : public CCameraDetector<CCI_CameraSensorLEDDetectorAlgorithm, CLEDEntity, CLEDMedium, 1> {
 public:
  void Update(const CPinholeCamera& camera) override {
    Detect(
        camera, [](const CLEDEntity& led, const CVector3&, SSightPoint*) { return led.IsLit(); },
        [this](const CLEDEntity& led, const CVector2* pixel) {
          m_tReadings.emplace_back(led.GetColor(), *pixel);
        });
  }

 protected:
  std::string GetMediumKind() const override { return "an LED medium"; }
};

}  // namespace

REGISTER_CAMERA_SENSOR_ALGORITHM(CCameraLEDDetector, "led_detector", "the authors of this project",
                                 "1.0", "Detects LEDs and lights in the images of a camera.",
                                 "See the sensor \"cameras (default)\".", "Usable")

}  // namespace argos
