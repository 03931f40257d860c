#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_FLOOR_IMAGE_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_FLOOR_IMAGE_H

#include <argos3/plugins/simulator/visualizations/scene/scene.h>

#include <cstdint>

namespace argos {

class CFloorEntity;
class CSpace;

/**
 * The floor of a space as an image, see SampleFloor(). That of a floor which loop functions paint
 * is blended between pixels.
 */
class CFloorImage {
 public:
  /** Samples the floor if it has changed since the last call. */
  void Update(CSpace& space);
  const SFloorImage& GetImage() const { return m_image; }

 private:
  SFloorImage m_image;
  const CFloorEntity* m_floor = nullptr;  // floor that m_image shows; only compared
  std::uint64_t m_version = 0;  // version of that floor
};

}  // namespace argos

#endif
