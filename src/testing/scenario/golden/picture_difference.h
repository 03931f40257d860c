#ifndef ARGOS3_TESTING_SCENARIO_GOLDEN_PICTURE_DIFFERENCE_H
#define ARGOS3_TESTING_SCENARIO_GOLDEN_PICTURE_DIFFERENCE_H

#include <argos3/plugins/simulator/visualizations/offscreen/picture.h>

#include <string>

namespace argos {

/** How different two pictures look. */
struct SPictureDifference {
  double Mean = 0.0;
  double Most = 0.0;
};

/**
 * Compares two pictures of the same size, as eyes do: distances of colours in CIELAB (D65, CIE
 * 1976), in which about 2.3 is just noticeable, after a binomial blur over 3 x 3 pixels in linear
 * light. So an edge that is antialiased otherwise counts little, and a part that is missing,
 * elsewhere or of another colour counts much.
 * @throws CARGoSException if the sizes differ.
 */
SPictureDifference ComputeDifference(const SPicture& a, const SPicture& b);

/** Reads an image file. @throws CARGoSException if it cannot be read. */
SPicture ReadPicture(const std::string& path);

}  // namespace argos

#endif
