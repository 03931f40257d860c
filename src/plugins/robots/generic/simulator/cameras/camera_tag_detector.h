#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_CAMERA_TAG_DETECTOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_CAMERAS_CAMERA_TAG_DETECTOR_H

#include <argos3/core/utility/datatypes/spare_elements.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_tag_detector_algorithm.h>
#include <argos3/plugins/robots/generic/simulator/camera_detector.h>

#include <string>

namespace argos {

class CTagEntity;
class CTagMedium;

/** Reads the tags that face a camera and are wholly in its picture: centre and four corners. */
class CCameraTagDetector : public CCameraDetector<CTagEntity, CTagMedium, 5>,
                           public CCI_CameraSensorTagDetectorAlgorithm {
 public:
  void Reset() override;
  void Update(const CPinholeCamera& camera) override;
  CCI_CameraSensorAlgorithm& GetCIAlgorithm() override { return *this; }

 protected:
  std::string GetMediumKind() const override { return "a tag medium"; }

 private:
  /** Has room for the longest payload ever. */
  SReading& NextReading();
  void MakeRoomFor(const std::string& payload);

  CSpareElements<SReading> m_spare;
  size_t m_longest = 0;  // bytes of a payload so far
};

}  // namespace argos

#endif
