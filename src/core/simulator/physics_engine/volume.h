#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_VOLUME_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_VOLUME_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/ray2.h>
#include <argos3/core/utility/math/vector3.h>

#include <memory>
#include <vector>

namespace argos {

/** A horizontal face of a region: its height, m, world frame. */
struct SHorizontalFace {
  Real Height = 0.0;
};

/** A vertical face of a region; the inside is on the left of its base segment. */
struct SVerticalFace {
  CRay2 BaseSegment;
};

/** The region of an engine: a right prism over a convex polygon, open where a face is missing. */
struct SVolume {
  SHorizontalFace* TopFace = nullptr;
  SHorizontalFace* BottomFace = nullptr;
  std::vector<SVerticalFace*> SideFaces;

  SVolume() = default;
  SVolume(const SVolume&) = delete;
  SVolume& operator=(const SVolume&) = delete;

  /**
   * Reads a `<boundaries>` element: `<top height>`, `<bottom height>`, `<sides><vertex point>`
   * (counter-clockwise, convex, at least three vertices).
   * @throws CARGoSException with the geometry if the polygon is not convex or not
   * counter-clockwise.
   */
  void Init(TConfigurationNode& node);
  /** True if any face limits the region. */
  bool IsActive() const {
    return TopFace != nullptr || BottomFace != nullptr || !SideFaces.empty();
  }
  /** True if @p point (m, world frame) is inside or on a face. */
  bool Contains(const CVector3& point) const;

 private:
  std::unique_ptr<SHorizontalFace> m_top;
  std::unique_ptr<SHorizontalFace> m_bottom;
  std::vector<std::unique_ptr<SVerticalFace>> m_sides;
};

}  // namespace argos

#endif
