#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_RAY_CASTER_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_RAY_CASTER_H

#include <argos3/core/utility/math/ray3.h>
#include <argos3/plugins/simulator/entities/ray_layout.h>

#include <cstddef>

namespace argos {

class CComposableEntity;
class CControllableEntity;
class CEmbodiedEntity;
class CSpace;
struct SAnchor;

/** Rays fixed to a robot; owns nothing. */
struct SRayBundle {
  const SSensorRay* Rays;
  const SRayBlock* Blocks; /**< hold the same rays */
  size_t Count; /**< at most CRayCaster::kMaxRays */
  const SRayBounds& Bounds;
  const SAnchor* const* Anchors; /**< indexed by SSensorRay::Anchor */
  const SAnchor& FirstAnchor; /**< holds the first ray, or all rays if Bounds.Planar */
};

/**
 * Casts rays from a robot. Rays ignore the robot's own body. A ray that starts inside another body
 * hits it at fraction 0.
 */
class CRayCaster {
 public:
  static constexpr size_t kMaxRays = 32;

  /** @throws CARGoSException if the robot has no "body" or no "controller". */
  void SetRobot(CComposableEntity& robot);
  CControllableEntity& GetRobot() const { return *m_robot; }
  CEmbodiedEntity& GetBody() const { return *m_body; }
  CSpace& GetSpace() const { return *m_space; }

  /**
   * For sensors whose derived classes find the robot's parts themselves: the pointers that
   * SetRobot() sets. All three must be set before rays are cast.
   */
  CControllableEntity*& AccessRobot() { return m_robot; }
  CEmbodiedEntity*& AccessBody() { return m_body; }
  void SetSpace(CSpace& space) { m_space = &space; }

  /**
   * Casts all rays with one query of the index.
   * @param fractions  (Count) fraction of its length at which each ray hits a body, in [0,1]; > 1
   *                   without a hit.
   */
  void Cast(const SRayBundle& bundle, Real* fractions) const;
  /** Records the rays for visualizations. */
  void Show(const SRayBundle& bundle, const Real* fractions) const;
  /** @return true if @p ray hits another body, at @p fraction of its length, in [0,1]. */
  bool FindHit(const CRay3& ray, Real& fraction) const;
  /** The same without the place, which takes less time. */
  bool IsBlocked(const CRay3& ray) const;
  /** @return true if an engine has bodies that are not in the space's index. */
  bool AreBodiesOutsideIndex() const;

 private:
  class CUprightCast;

  void CastUpright(const SRayBundle& bundle, Real* fractions) const;
  void CastOneByOne(const SRayBundle& bundle, Real* fractions) const;

  CEmbodiedEntity* m_body = nullptr;
  CControllableEntity* m_robot = nullptr;
  CSpace* m_space = nullptr;
};

/** @return a ray of the bundle, in the world frame, m. */
CRay3 MakeWorldRay(const SRayBundle& bundle, size_t ray);

}  // namespace argos

#endif
