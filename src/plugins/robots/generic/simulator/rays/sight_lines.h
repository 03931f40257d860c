#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_SIGHT_LINES_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_SIGHT_LINES_H

#include <argos3/core/simulator/geometry/indexed_shape.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/robots/generic/simulator/ray_caster.h>

#include <vector>

namespace argos {

class CBodyIndex;
class CComposableEntity;
class CEmbodiedEntity;
struct SBoundingBox;

/**
 * Computes which of many points are visible from the eye of a robot.
 *
 * All lines share one query of the index. They ignore the robot's own body. A body does not occlude
 * points on its surface, to within kTouch, that are on the side of the eye: LEDs and tags may be
 * mounted flush.
 *
 * Points that are close together, such as those of a tag, are a group: one cheap test in single
 * precision rejects a solid for all of them. Keeps its memory allocated between uses.
 */
class CSightLines {
 public:
  static constexpr Real kTouch =
      1e-9;  // m; much larger than rounding errors, much smaller than any body

  CSightLines();
  ~CSightLines();

  /**
   * Removes all points.
   * @param robot  must exist until the last call for these points.
   * @param eye  m, world frame. @param groupSize  points of a group.
   */
  void Start(const CRayCaster& robot, const CVector3& eye, size_t groupSize = 1);
  /** Reserves memory for @p num groups of @p groupSize points. */
  void Reserve(size_t num, size_t groupSize = 1);
  /**
   * Finds what may occlude points.
   * @param box  contains the eye and all points, m, world frame.
   * @return false if there is nothing: all points are visible, and need not be added.
   */
  bool FindOccluders(const SBoundingBox& box);
  /**
   * Adds a point, to the last group until that is complete.
   * @param point m, world frame.
   * @param open  a body that does not occlude the point if the eye is below its base; may be null.
   */
  void Add(const CVector3& point, const CEmbodiedEntity* open = nullptr);
  /**
   * Computes which groups have occluded points; after FindOccluders() of these points.
   * @param all  true: which points are occluded; false: of a group with an occluded point, the
   * others are perhaps not tested.
   */
  void Trace(bool all = true);

  size_t GetNumPoints() const { return m_lines.size(); }
  const CVector3& GetPoint(size_t number) const { return m_lines[number].End; }
  /** @return true if the point was visible in Trace(). */
  bool IsClear(size_t number) const { return m_lines[number].IsClear; }
  /** @return true if all points of a group were visible. */
  bool IsGroupClear(size_t group) const;

  /** Records line @p number for visualizations. */
  void Show(size_t number) const;

 private:
  struct SLine {
    CVector3 End;  // m, world frame
    const CEmbodiedEntity* Open;  // does not occlude the end; null if all others do
    Real Hit;  // fraction at which the line hits the first body; 1 if none
    bool IsClear;  // no body occludes the end
  };
  struct SBlock;
  struct SDisc;

  void TraceShape(const CBodyIndex& index, const SIndexedShape& shape, bool all);
  void TraceGroup(const CBodyIndex& index, const SIndexedShape& shape, const SDisc& disc,
                  size_t group);
  void Meet(SLine& line, Real fraction);
  void TraceOneByOne();
  Real FindHitBesides(const CEmbodiedEntity& open, const CRay3& ray) const;

  const CRayCaster* m_robot = nullptr;  // gives the body and the space
  CVector3 m_eye;  // m, world frame
  size_t m_groupSize = 1;
  std::vector<SLine> m_lines;
  std::vector<SBlock> m_blocks;  // of groups
  std::vector<SIndexedShape> m_occluders;  // found for the points
  bool m_isAnyHit = false;
};

}  // namespace argos

#endif
