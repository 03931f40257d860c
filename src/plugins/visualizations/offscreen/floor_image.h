#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FLOOR_IMAGE_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FLOOR_IMAGE_H

#include <argos3/plugins/simulator/visualizations/offscreen/scene.h>

namespace argos {

class CSpace;

/**
 * The floor of a space as an image of `pixels_per_meter`, at most 8192 pixels along each side.
 *
 * A floor that loop functions paint is filtered: a pixel in which the colour changes is the mean of
 * 2 x 2 samples, and the image is blended between pixels. An image file keeps its pixels.
 */
class CFloorImage {
 public:
  /** Samples the floor if it has changed since the last call; resets the floor's mark of that. */
  void Update(CSpace& space);
  const SFloorImage& GetImage() const { return m_image; }

 private:
  SFloorImage m_image;
};

}  // namespace argos

#endif
