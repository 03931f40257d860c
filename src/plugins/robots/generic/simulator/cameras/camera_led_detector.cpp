#include <argos3/plugins/robots/generic/simulator/camera_led_detector.h>

#include <argos3/plugins/simulator/entities/led_entity.h>
#include <argos3/plugins/simulator/media/led_medium.h>

namespace argos {

void CCameraLEDDetector::Reset() {
  CCameraDetector::Reset();
  m_tReadings.clear();
}

void CCameraLEDDetector::Update(const CPinholeCamera& camera) {
  m_tReadings.clear();
  Detect(
      camera, [](const CLEDEntity& led, CVector3*) { return led.IsLit(); },
      [this](const CLEDEntity& led, const CVector2* pixel) {
        m_tReadings.emplace_back(led.GetColor(), *pixel);
      });
}

REGISTER_CAMERA_SENSOR_ALGORITHM(CCameraLEDDetector, "led_detector", "the authors of this project",
                                 "1.0", "Finds LEDs and lights in the pictures of a camera.",
                                 "See the sensor \"cameras (default)\".", "Usable")

}  // namespace argos
