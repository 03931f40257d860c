#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_LED_GLOWS_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_LED_GLOWS_H

#include <argos3/core/utility/datatypes/color.h>
#include <argos3/plugins/simulator/visualizations/scene/scene_parts.h>

namespace argos {

class CDirectionalLEDEquippedEntity;
class CLEDEquippedEntity;
struct SAppearance;

/** Colour of an LED; black, which is dark, if @p leds is null or has no LED of that number. */
CColor GetLEDColorOrBlack(const CLEDEquippedEntity* leds, UInt32 number);

/** The same for directional LEDs, which appear from all sides. */
CColor GetLEDColorOrBlack(const CDirectionalLEDEquippedEntity* leds, UInt32 number);

/** An LED as a part of a scene. @param diameter  m. @param color  black: dark. */
SGlow MakeLEDGlow(const SPose& pose, double diameter, const CColor& color);

/**
 * A lamp as a part of a scene.
 * @param diameter   m.
 * @param intensity  of CLightEntity; 0 or less: the lamp is off, as light sensors ignore it, and is
 *   drawn as an LED that is off.
 */
SGlow MakeLampGlow(const SPose& pose, double diameter, const CColor& color, Real intensity);

/**
 * Adds those LEDs of the component that the appearance does not contain, 1 cm wide, at their places
 * on the body. Creates no LED entities.
 */
void AddUndeclaredLEDs(const SAppearance& appearance, const CLEDEquippedEntity& leds,
                       SScene& scene);

}  // namespace argos

#endif
