#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_DRAWING_FLOOR_SAMPLES_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_DRAWING_FLOOR_SAMPLES_H

#include <argos3/core/utility/math/vector3.h>

#include <cstdint>
#include <vector>

namespace argos {

class CFloorEntity;

/** A floor as views show it. Row 0 is at the lowest y. */
struct SFloorSamples {
  int Width = 0; /**< pixels */
  int Height = 0; /**< pixels */
  std::vector<std::uint8_t> Pixels; /**< red, green, blue, 255 of each; (Height, Width, 4) */
};

/**
 * Samples a floor, at most 8192 pixels along each side.
 *
 * A floor that loop functions paint is sampled at its pixels per metre and filtered: a pixel in
 * which the colour changes is the mean of 2 x 2 samples. An image keeps its pixels. Sampling what
 * was sampled at the same resolution gives the same again.
 * @param center, size  of the arena, m.
 */
SFloorSamples SampleFloor(CFloorEntity& floor, const CVector3& center, const CVector3& size);

}  // namespace argos

#endif
