#ifndef ARGOS3_PLUGINS_ENTITIES_RAY_LAYOUT_H
#define ARGOS3_PLUGINS_ENTITIES_RAY_LAYOUT_H

#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/vector3.h>

#include <vector>

namespace argos {

/** A ray that is fixed in the frame of an anchor. */
struct SSensorRay {
  CVector3 Offset; /**< start in the anchor's frame, m */
  CVector3 Direction; /**< from start to end in the anchor's frame, m */
  UInt32 Anchor = 0; /**< index of the anchor in the layout */

  /** Changes the ray. @return true if it differed. */
  bool Set(const CVector3& offset, const CVector3& direction) {
    const bool differs = offset != Offset || direction != Direction;
    Offset = offset;
    Direction = direction;
    return differs;
  }
};

/** A vector of that direction and length. */
inline CVector3 WithLength(CVector3 direction, Real length) {
  return direction.Normalize() *= length;
}

/** Bounds of several rays, for casting them together. */
struct SRayBounds {
  /** True if all rays are horizontal and on one anchor; only then the circle is valid. */
  bool Planar = true;
  /** A circle in the anchor's xy plane that contains all rays, m. */
  Real CenterX = 0.0, CenterY = 0.0, Reach = 0.0;
};

/** Sensors along rays, common to a type of robot. */
struct SRayLayout : SRayBounds {
  typedef SSensorRay TPlace;

  std::vector<SSensorRay> Rays;
  /** From the centre of the circle to the start that is farthest from it, m. */
  Real FarthestStart = 0.0;

  std::vector<SSensorRay>& GetPlaces() { return Rays; }
  const std::vector<SSensorRay>& GetPlaces() const { return Rays; }

  /**
   * @param offset     start of the ray in the anchor's frame, m.
   * @param direction  in the anchor's frame, of any length but 0.
   * @param range      length of the ray, m, > 0.
   * @throws CARGoSException if the direction is zero or the range is not > 0.
   */
  void AddSensor(const CVector3& offset, const CVector3& direction, Real range, UInt32 anchor = 0);
  /**
   * Adds rays that start on a horizontal arc and point outward, counter-clockwise: ray i at
   * startAngle + i (endAngle - startAngle) / num.
   */
  void AddSensorFan(const CVector3& center, Real radius, const CRadians& startAngle,
                    const CRadians& endAngle, Real range, UInt32 num, UInt32 anchor = 0);
  /** Recomputes the bounds, and the farthest start. */
  void ComputeBounds();
};

}  // namespace argos

#endif
