#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_VISUAL_PARTS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_VISUAL_PARTS_H

#include <argos3/core/simulator/visualization/appearance.h>

namespace argos {

/*
 * Parts of the appearances of robots. All lengths are in m.
 */

/** @return the new part; valid until the next one is added. */
SVisualPart& AddPart(SAppearance& robot, SVisualPart::EKind kind, const CVector3& position,
                     const CVector3& size, const CColor& color,
                     EMaterial material = EMaterial::Plastic);
/** Adds an upright cylinder. @param axis  intersection of its axis with the xy plane. */
void AddDisc(SAppearance& robot, Real radius, Real bottom, Real top, const CColor& color,
             const CVector3& axis = CVector3(), EMaterial material = EMaterial::Plastic);
/** @param number of the LED. @param color of its glass. */
void AddLED(SAppearance& robot, UInt32 number, const CVector3& position, Real diameter,
            const CColor& color);

/** LEDs on a horizontal circle around the z axis, counter-clockwise. */
struct SVisualLEDRing {
  UInt32 First = 0; /**< number of the first LED */
  UInt32 Num = 0; /**< number of LEDs */
  Real StartAngle = 0.0; /**< angle of the first LED, degrees */
  Real Radius = 0.0;
  Real Elevation = 0.0;
};
void AddLEDRing(SAppearance& robot, const SVisualLEDRing& ring, Real diameter, const CColor& color);

}  // namespace argos

#endif
