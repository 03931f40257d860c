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

/** Rays that are fixed to a robot; nothing of it is owned. */
struct SRayBundle {
  const SSensorRay* Rays;
  size_t Count; /**< at most CRayCaster::kMaxRays */
  const SRayBounds& Bounds;
  const SAnchor* const* Anchors; /**< that the rays number */
  const SAnchor& FirstAnchor; /**< of the first ray; if Bounds.Planar, of all */
};

/**
 * Looks around a robot along rays, which see through the robot's own body. A ray that starts inside
 * another body meets it at once.
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
   * Casts all rays with one query for the solids around the robot.
   * @param fractions  (Count) where each ray meets a body, in [0,1] of its length; else > 1.
   */
  void Cast(const SRayBundle& bundle, Real* fractions) const;
  /** Tells visualizations of rays that were cast. */
  void Show(const SRayBundle& bundle, const Real* fractions) const;
  /** True if @p ray meets another body; @p fraction of its length is then where, in [0,1]. */
  bool FindHit(const CRay3& ray, Real& fraction) const;
  /** True if an engine has bodies that the space's index does not know. */
  bool AreBodiesOutsideIndex() const;

 private:
  struct SWorldRays;

  void CastUpright(const SRayBundle& bundle, Real* fractions) const;
  void CastOneByOne(const SRayBundle& bundle, Real* fractions) const;

  CEmbodiedEntity* m_body = nullptr;  // of the robot
  CControllableEntity* m_robot = nullptr;
  CSpace* m_space = nullptr;
};

/** A ray of the bundle, in the world frame, m. */
CRay3 MakeWorldRay(const SRayBundle& bundle, size_t ray);

}  // namespace argos

#endif
