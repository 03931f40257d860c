#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_LOOK_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_LOOK_H

#include <argos3/plugins/simulator/visualizations/scene/scene.h>

#include <string>

namespace argos {

/**
 * Visual style of the pictures: colours and strengths of everything that is not in the scene.
 *
 * Intensities are in linear light; a white, lit, upward face comes out at about 1.
 */
struct SLook {
  SRgba Background;
  SRgba Ground; /**< colour of the arena where the floor has no image */
  SRgba GroundOutside; /**< colour around the arena, fading into the background */
  SRgba GridLine;
  SRgba Boundary;
  SRgba Marker; /**< robots too small to be seen */
  float SunIntensity = 0.0f;
  SRgba SkyLight; /**< diffuse light on upward faces */
  SRgba BounceLight; /**< diffuse light on downward faces */
  float AmbientIntensity = 0.0f;
  float SpecularIntensity = 0.0f;
  float EdgeDarkening = 0.0f; /**< strength of the lines along the edges of solids, 0 to 1 */
  float ContactDarkening = 0.0f; /**< strength of the shade under solids, 0 to 1 */
  float HaloStrength = 0.0f; /**< 0 to 1 */
  /** Opacity of a halo: 1 hides the background like fog, 0 adds to it like light. */
  float HaloOpacity = 0.0f;

  /**
   * @param name  "light" (for print) or "dark" (for slides).
   * @throws CARGoSException listing the valid names.
   */
  static SLook FromName(const std::string& name);
};

}  // namespace argos

#endif
