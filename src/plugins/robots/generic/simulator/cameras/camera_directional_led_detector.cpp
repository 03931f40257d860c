#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_directional_led_detector_algorithm.h>
#include <argos3/plugins/robots/generic/simulator/camera_detector.h>
#include <argos3/plugins/simulator/entities/directional_led_entity.h>
#include <argos3/plugins/simulator/media/directional_led_medium.h>

namespace argos {

namespace {

/** Detects the directional LEDs that shine on a camera. */
class CCameraDirectionalLEDDetector
    : public CCameraDetector<CCI_CameraSensorDirectionalLEDDetectorAlgorithm, CDirectionalLEDEntity,
                             CDirectionalLEDMedium, 1> {
 public:
  void Update(const CPinholeCamera& camera) override {
    Detect(
        camera,
        [&camera](const CDirectionalLEDEntity& led, const CVector3& image, SSightPoint*) {
          return led.IsLit() && led.ShinesOn(camera.GetPosition() - image);
        },
        [this](const CDirectionalLEDEntity& led, const CVector2* pixel) {
          m_tReadings.emplace_back(led.GetColor(), *pixel);
        });
  }

 protected:
  std::string GetMediumKind() const override { return "a directional LED medium"; }
};

}  // namespace

REGISTER_CAMERA_SENSOR_ALGORITHM(CCameraDirectionalLEDDetector, "directional_led_detector",
                                 "the authors of this project", "1.0",
                                 "Detects the directional LEDs that shine on a camera.",
                                 "See the sensor \"cameras (default)\".", "Usable")

}  // namespace argos
