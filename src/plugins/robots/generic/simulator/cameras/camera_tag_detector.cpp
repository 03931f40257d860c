#include <argos3/plugins/robots/generic/simulator/camera_tag_detector.h>

#include <argos3/plugins/simulator/entities/tag_entity.h>
#include <argos3/plugins/simulator/media/tag_medium.h>

#include <algorithm>

namespace argos {

void CCameraTagDetector::Reset() {
  CCameraDetector::Reset();
  m_spare.Shrink(m_tReadings, 0);
}

void CCameraTagDetector::Update(const CPinholeCamera& camera) {
  m_spare.Shrink(m_tReadings, 0);
  Detect(
      camera,
      [&camera](const CTagEntity& tag, CVector3* corners) {
        if (!tag.Faces(camera.GetPosition())) {
          return false;
        }
        const std::array<CVector3, 4> all = tag.ComputeCorners();
        std::copy(all.begin(), all.end(), corners);
        return true;
      },
      [this](const CTagEntity& tag, const CVector2* pixels) {
        MakeRoomFor(tag.GetPayload());
        SReading& reading = NextReading();
        reading.Payload = tag.GetPayload();
        reading.Center = pixels[0];
        std::copy(pixels + 1, pixels + 5, reading.Corners.begin());
      });
}

CCameraTagDetector::SReading& CCameraTagDetector::NextReading() {
  return m_spare.Append(m_tReadings,
                        [this](SReading& reading) { reading.Payload.reserve(m_longest); });
}

// all at once: which reading gets which tag differs from tick to tick
void CCameraTagDetector::MakeRoomFor(const std::string& payload) {
  if (payload.size() > m_longest) {
    m_longest = payload.size();
    const auto makeRoom = [this](SReading& reading) { reading.Payload.reserve(m_longest); };
    m_spare.ForEach(makeRoom);
    std::for_each(m_tReadings.begin(), m_tReadings.end(), makeRoom);
  }
}

REGISTER_CAMERA_SENSOR_ALGORITHM(CCameraTagDetector, "tag_detector", "the authors of this project",
                                 "1.0", "Reads the tags in the pictures of a camera.",
                                 "See the sensor \"cameras (default)\".", "Usable")

}  // namespace argos
