#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_GROUND_TEXTURE_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_GROUND_TEXTURE_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/plugins/simulator/visualizations/scene/scene.h>

namespace argos {

/**
 * Reads the attributes `ground_texture` and `ground_texture_size` of a view.
 * @return an image without pixels if there is no texture.
 * @throws CARGoSException with file and line if the file cannot be opened or is no image, or if the
 * size is not positive.
 */
SFloorImage ReadGroundTexture(TConfigurationNode& view);

}  // namespace argos

#endif
