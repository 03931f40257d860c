#ifndef ARGOS3_PLUGINS_ENTITIES_RAY_LAYOUT_H
#define ARGOS3_PLUGINS_ENTITIES_RAY_LAYOUT_H

#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/vector3.h>

#include <cstddef>
#include <vector>

namespace argos {

/** A ray that is fixed in the frame of an anchor. */
struct SSensorRay {
  CVector3 Offset; /**< start in the anchor's frame, m */
  CVector3 Direction; /**< leads from start to end in the anchor's frame, m */
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

/** Eight rays, in arrays over which loops are vectorized. */
struct SRayBlock {
  static constexpr size_t kSize = 8;

  // start in the anchor's frame, m
  Real OffsetX[kSize], OffsetY[kSize], OffsetZ[kSize];
  // lead from start to end in the anchor's frame, m
  Real DirectionX[kSize], DirectionY[kSize], DirectionZ[kSize];

  static constexpr size_t GetNumBlocks(size_t rays) { return (rays + kSize - 1) / kSize; }
};

/** Copies rays to GetNumBlocks(count) blocks; repeats the last one to fill the last block. */
void FillBlocks(const SSensorRay* rays, size_t count, SRayBlock* blocks);

/** Bounds of several rays, for casting them together. */
struct SRayBounds {
  /** True if all rays are horizontal and on one anchor; only then the rest is valid. */
  bool Planar = true;
  /** True if each ray is so long that its square length is a normal number, > 0. */
  bool HaveLengths = true;
  /** A circle in the anchor's xy plane that contains all rays, m. */
  Real CenterX = 0.0, CenterY = 0.0, Reach = 0.0;
  /** Heights of the rays in the anchor's frame, m. */
  Real MinZ = 0.0, MaxZ = 0.0;

  /** Extends the heights, and HaveLengths, to a ray. @param isFirst  of all. */
  void Include(const SSensorRay& ray, bool isFirst);
};

/** Sensors along rays, common to a type of robot. */
struct SRayLayout : SRayBounds {
  typedef SSensorRay TPlace;

  std::vector<SSensorRay> Rays;
  /** The same, in their order. */
  std::vector<SRayBlock> Blocks;
  /** Of each ray, m. */
  std::vector<Real> Lengths;
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
  /** Recomputes everything from Rays. */
  void ComputeBounds();
};

}  // namespace argos

#endif
