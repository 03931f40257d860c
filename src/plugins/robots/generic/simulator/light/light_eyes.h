#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_LIGHT_LIGHT_EYES_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_LIGHT_LIGHT_EYES_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/simulator/entities/ray_layout.h>

#include <algorithm>
#include <cstddef>

namespace argos {

struct SAnchor;
struct SIndexedShape;

/**
 * Some light sensors of one robot in the world frame, in arrays over which loops are vectorized.
 *
 * Numbers of the sensors are from 0 to Count; arrays are filled up to a multiple of
 * SRayBlock::kSize by repetitions of the last sensor. Results are equal to the bit to those of
 * single vectors.
 */
struct SLightEyes {
  static constexpr size_t kCapacity = 32;
  static_assert(kCapacity % SRayBlock::kSize == 0);

  size_t Count = 0;
  Real X[kCapacity], Y[kCapacity], Z[kCapacity]; /**< positions, m */
  /** Directions, of length 1. */
  Real DirectionX[kCapacity], DirectionY[kCapacity], DirectionZ[kCapacity];
  CVector3 Center; /**< mean of the positions, m */
  Real Reach = 0.0; /**< m, from the centre to the farthest position, seen from above */
  Real MinZ, MaxZ; /**< m, of the positions */

  // written by LookAt()
  CVector3 Light; /**< m */
  Real DX[kCapacity], DY[kCapacity], DZ[kCapacity]; /**< vector to the light, m */
  Real Distance[kCapacity]; /**< to the light, m */
  UInt64 IsClear[kCapacity]; /**< 1 if the light is visible, 0 if not */

  Real Readings[kCapacity]; /**< sum of the lights so far */

  /**
   * Places sensors; clears the readings.
   * @param first  number of the first one in the layout, a multiple of SRayBlock::kSize.
   * @param count  at most kCapacity.
   */
  void Place(const SRayLayout& layout, const SAnchor* const* anchors, size_t first, size_t count);
  /**
   * Measures the distances to a light, and marks the sensors as clear that it is not behind.
   * @return number of these.
   */
  size_t LookAt(const CVector3& light);
  /**
   * Finds for which sensors the light of LookAt() stays visible beside an upright disc; equal to
   * the bit to IntersectRay() of each line to the light.
   * @param disc   the radius is HalfX.
   * @param clear  (kCapacity) is set to 1 if the sensor was clear and is not behind the disc, else
   *               to 0; may be IsClear.
   * @return false if no sensor is clear.
   */
  bool FindClear(const SIndexedShape& disc, UInt64* clear) const;
  /** Adds the light (@p intensity / distance)^2 to the readings of the clear sensors. */
  void AddSquares(Real intensity);

  CVector3 GetPosition(size_t eye) const { return CVector3(X[eye], Y[eye], Z[eye]); }
  /** From the height of the centre to the farthest position, m. */
  Real GetVerticalReach() const { return std::max(MaxZ - Center.GetZ(), Center.GetZ() - MinZ); }

 private:
  // sine of the angle below the horizon at which a light still counts as visible: much larger than
  // the rounding error of a robot's pose, so that mirrored sensors decide alike
  static constexpr Real kGrazing = 1e-9;

  size_t GetEnd() const { return SRayBlock::GetNumBlocks(Count) * SRayBlock::kSize; }
  void Enclose();
};

}  // namespace argos

#endif
