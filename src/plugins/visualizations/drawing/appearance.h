#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_DRAWING_APPEARANCE_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_DRAWING_APPEARANCE_H

#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

#include <string>
#include <string_view>
#include <vector>

namespace argos {

/** What a solid is made of, for views that show it, such as `<povray>`. */
enum class EMaterial : UInt8 {
  Plastic, /**< hard, with soft highlights */
  Matte, /**< rubber, wood, paint: no highlights */
  Metal, /**< reflects its surroundings in its colour */
  Glass, /**< clear: transmits and bends light; the colour tints it */
  Count
};

/** Lower case, as in XML: "plastic", "matte", "metal", "glass". */
std::string_view ToText(EMaterial material);
/** @throws CARGoSException listing the names, with the nearest. */
EMaterial MaterialFromText(std::string_view text);

/** One drawable solid of an entity, in the frame of one of its anchors. */
struct SVisualPart {
  enum class EKind : UInt8 {
    Box, /**< Size = full extents; stands on its base */
    Cylinder, /**< Size = (diameter x, diameter y, height); stands on its base */
    Cone, /**< has the sizes of Cylinder, tip up */
    Sphere, /**< Size = diameters; Position is the centre */
    Ring, /**< torus around z: Size = (outer diameter, outer diameter, thickness); centre */
    LED /**< small glowing sphere; Size = diameters; colour from the LED component */
  };

  EKind Kind = EKind::Box;
  CVector3 Position; /**< anchor's frame, m */
  CQuaternion Orientation; /**< anchor's frame */
  CVector3 Size; /**< m, see EKind */
  CColor Color; /**< colour of the surface; alpha < 255 is translucent */
  std::string Anchor =
      "origin"; /**< the part moves with this anchor if enabled, else with the origin */
  /** Kind LED: which LED of the entity's "leds" component gives the colour, 0-based. */
  UInt32 LED = 0;
  EMaterial Material = EMaterial::Plastic; /**< ignored by LEDs, which are glass */
};

/**
 * The appearance of an entity, independent of the visualization. All entities of a type share it.
 */
struct SAppearance {
  std::vector<SVisualPart> Parts;
};

}  // namespace argos

#endif
