#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_VOLUME_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_VOLUME_H

#include <argos3/core/simulator/geometry/region_geometry.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/ray2.h>
#include <argos3/core/utility/math/vector3.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

struct SBodyDescription;

/**
 * A face of a region. A wall stops bodies; a gate transfers bodies that cross it to a named engine;
 * any other face transfers them to the first engine, in document order, that accepts them.
 */
struct SFace {
  bool IsWall = false;
  std::string Gate; /**< id of the engine behind it; empty: no gate */
};

/** A horizontal face of a region: its height, m, world frame. */
struct SHorizontalFace : SFace {
  Real Height = 0.0;
};

/** A vertical face of a region; the inside is on the left of its base segment. */
struct SVerticalFace : SFace {
  CRay2 BaseSegment;
};

/** A vertical wall of a region as a solid: an upright box outside it, with one side on the face. */
struct SWallSlab {
  std::shared_ptr<const SBodyDescription> Description;
  CVector3 Position; /**< m, world frame; of the base's centre */
  CQuaternion Orientation;
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
   * (counter-clockwise, convex, at least three vertices). Each `<top>`, `<bottom>` and `<vertex>`
   * may have wall="true" or gate="id of an engine"; a vertex stands for the side from there to the
   * next one.
   * @throws CARGoSException with the geometry if the polygon crosses itself, is not convex or not
   * counter-clockwise, or if the top is not above the bottom.
   */
  void Init(TConfigurationNode& node);
  /** True if any face limits the region. */
  bool IsActive() const {
    return TopFace != nullptr || BottomFace != nullptr || !SideFaces.empty();
  }
  bool HasWalls() const;
  /** True if @p point (m, world frame) is inside or on a face. */
  bool Contains(const CVector3& point) const;
  /** Of the faces with @p point on their outer side, the nearest; null if it is inside. */
  const SFace* FindExit(const CVector3& point) const;
  /** Distance from @p point to the region, m; 0 inside. */
  Real ComputeDistance(const CVector3& point) const;
  /**
   * @return true if a solid of the body, as its box or disc seen from above, is within @p reach m.
   */
  bool IsTouchedBy(const SBodyDescription& body, const CVector3& position,
                   const CQuaternion& orientation, Real reach) const;
  /** The corners of the region seen from above; empty without sides. */
  std::vector<CVector2> GetCorners() const;
  /** Height of the bottom, m; -infinity without one. */
  Real GetLowest() const;
  /** Height of the top, m; +infinity without one. */
  Real GetHighest() const;
  /** The sides that are walls, as solids. */
  std::vector<SWallSlab> DescribeWalls() const;
  /**
   * Moves a point out of the walls, for bodies without contacts.
   * @param position  m; of the base of a body.
   * @param radius    m; of the upright cylinder around it.
   * @param height    m; of that cylinder.
   * @param velocity  m/s; the component into a wall is removed.
   * @return true if position or velocity was changed.
   */
  bool HoldInside(CVector3& position, CVector3& velocity, Real radius, Real height) const;

 private:
  std::unique_ptr<SHorizontalFace> m_top;
  std::unique_ptr<SHorizontalFace> m_bottom;
  std::vector<std::unique_ptr<SVerticalFace>> m_sides;
  std::vector<CBorderSide>
      m_borderSides;  // borders of m_sides; computed once, as each tick tests all bodies
};

}  // namespace argos

#endif
