#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_tag_detector_algorithm.h>
#include <argos3/plugins/robots/generic/simulator/camera_detector.h>
#include <argos3/plugins/simulator/entities/spare_elements.h>
#include <argos3/plugins/simulator/entities/tag_entity.h>
#include <argos3/plugins/simulator/media/tag_medium.h>

#include <algorithm>
#include <string>

namespace argos {

namespace {

/** Detects the tags that face a camera and are completely in its image: centre and corners. */
class CCameraTagDetector
    : public CCameraDetector<CCI_CameraSensorTagDetectorAlgorithm, CTagEntity, CTagMedium, 5> {
 public:
  void Update(const CPinholeCamera& camera) override;

 protected:
  std::string GetMediumKind() const override { return "a tag medium"; }
  void ClearReadings() override { m_spare.Shrink(m_tReadings, 0); }

 private:
  /** @return a new reading; its payload has memory for the longest payload so far. */
  SReading& NextReading();
  void ReserveFor(const std::string& payload);

  CSpareElements<SReading> m_spare;
  size_t m_longest = 0;  // bytes of a payload so far
};

}  // namespace

void CCameraTagDetector::Update(const CPinholeCamera& camera) {
  Detect(
      camera,
      [&camera](const CTagEntity& tag, const CVector3& image, SSightPoint* corners) {
        if (!tag.Faces(camera.GetPosition() - image)) {
          return false;
        }
        for (const CVector3& corner : tag.ComputeCorners()) {
          (corners++)->Position = corner + image;
        }
        return true;
      },
      [this](const CTagEntity& tag, const CVector2* pixels) {
        ReserveFor(tag.GetPayload());
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

// Reserves in all readings: the assignment of tags to readings changes from tick to tick.
void CCameraTagDetector::ReserveFor(const std::string& payload) {
  if (payload.size() > m_longest) {
    m_longest = payload.size();
    const auto reserve = [this](SReading& reading) { reading.Payload.reserve(m_longest); };
    m_spare.ForEach(reserve);
    std::for_each(m_tReadings.begin(), m_tReadings.end(), reserve);
  }
}

REGISTER_CAMERA_SENSOR_ALGORITHM(CCameraTagDetector, "tag_detector", "the authors of this project",
                                 "1.0", "Detects the tags in the images of a camera.",
                                 "See the sensor \"cameras (default)\".", "Usable")

}  // namespace argos
