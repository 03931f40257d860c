#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_DRAWING_SOLID_PART_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_DRAWING_SOLID_PART_H

#include <argos3/core/simulator/visualization/appearance.h>

namespace argos {

struct SShapeDescription;

/** What a solid looks like, in the frame in which it is described. A hull is drawn as its box. */
SVisualPart MakeSolidPart(const SShapeDescription& shape, const CColor& color);

}  // namespace argos

#endif
