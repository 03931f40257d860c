#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_DRAWING_TO_SCENE_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_DRAWING_TO_SCENE_H

namespace argos {

class CDrawing;
struct SScene;

/**
 * Adds what users' code has drawn to a scene.
 *
 * Boxes and cylinders become solids, which are lit and cast shadows; points, lines, polygons and
 * circles keep their even colour. Over the picture, a box is drawn as a rectangle, a cylinder as a
 * disc.
 */
void AddDrawing(const CDrawing& drawing, SScene& scene);

}  // namespace argos

#endif
