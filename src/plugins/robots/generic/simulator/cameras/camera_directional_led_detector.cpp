#include <argos3/plugins/robots/generic/simulator/camera_directional_led_detector.h>

#include <argos3/plugins/simulator/entities/directional_led_entity.h>
#include <argos3/plugins/simulator/media/directional_led_medium.h>

namespace argos {

void CCameraDirectionalLEDDetector::Reset() {
  CCameraDetector::Reset();
  m_tReadings.clear();
}

void CCameraDirectionalLEDDetector::Update(const CPinholeCamera& camera) {
  m_tReadings.clear();
  Detect(
      camera,
      [&camera](const CDirectionalLEDEntity& led, CVector3*) {
        return led.IsLit() && led.ShinesOn(camera.GetPosition());
      },
      [this](const CDirectionalLEDEntity& led, const CVector2* pixel) {
        m_tReadings.emplace_back(led.GetColor(), *pixel);
      });
}

REGISTER_CAMERA_SENSOR_ALGORITHM(CCameraDirectionalLEDDetector, "directional_led_detector",
                                 "the authors of this project", "1.0",
                                 "Finds directional LEDs that shine on a camera.",
                                 "See the sensor \"cameras (default)\".", "Usable")

}  // namespace argos
