#include <argos3/plugins/robots/generic/simulator/camera_tag_detector.h>

#include <argos3/plugins/simulator/entities/tag_entity.h>
#include <argos3/plugins/simulator/media/tag_medium.h>

#include <algorithm>
#include <utility>

namespace argos {

void CCameraTagDetector::Reset() {
  CCameraDetector::Reset();
  m_tReadings.clear();
}

void CCameraTagDetector::Update(const CPinholeCamera& camera) {
  for (SReading& reading : m_tReadings) {
    m_spare.push_back(std::move(reading));
  }
  m_tReadings.clear();
  Detect(
      camera,
      [&camera](const CTagEntity& tag, CVector3* points) {
        points[0] = tag.GetPosition();
        const std::array<CVector3, 4> corners = tag.ComputeCorners();
        std::copy(corners.begin(), corners.end(), points + 1);
        return tag.Faces(camera.GetPosition());
      },
      [this](const CTagEntity& tag, const CVector2* pixels) {
        SReading& reading = NextReading();
        reading.Payload = tag.GetPayload();
        reading.Center = pixels[0];
        std::copy(pixels + 1, pixels + 5, reading.Corners.begin());
      });
}

CCameraTagDetector::SReading& CCameraTagDetector::NextReading() {
  if (m_spare.empty()) {
    return m_tReadings.emplace_back();
  }
  m_tReadings.push_back(std::move(m_spare.back()));
  m_spare.pop_back();
  return m_tReadings.back();
}

REGISTER_CAMERA_SENSOR_ALGORITHM(CCameraTagDetector, "tag_detector", "the authors of this project",
                                 "1.0", "Reads the tags in the pictures of a camera.",
                                 "See the sensor \"cameras (default)\".", "Usable")

}  // namespace argos
