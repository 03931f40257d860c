#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_SIGHT_LINES_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_SIGHT_LINES_H

#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/robots/generic/simulator/ray_caster.h>

#include <vector>

namespace argos {

class CBodyIndex;
class CComposableEntity;
class CEmbodiedEntity;
struct SIndexedShape;

/**
 * Computes which of many points are visible from one point, the eye.
 *
 * All lines share one query of the index. They ignore the robot's own body. A body does not occlude
 * points on its surface, to within kTouch, that are on the side of the eye: LEDs and tags may be
 * mounted flush.
 *
 * Keeps its memory allocated between uses.
 */
class CSightLines {
 public:
  static constexpr Real kTouch =
      1e-9;  // m; much larger than rounding errors, much smaller than any body

  /** @throws CARGoSException if the robot has no "body" or "controller". */
  void SetRobot(CComposableEntity& robot) { m_robot.SetRobot(robot); }

  /** Removes all points. @param eye m, world frame. */
  void Start(const CVector3& eye);
  /** Reserves memory for @p num points. */
  void Reserve(size_t num) { m_lines.reserve(num); }
  /**
   * @param point m, world frame.
   * @param open  a body that does not occlude the point if the eye is below its base; may be null.
   */
  void Add(const CVector3& point, const CEmbodiedEntity* open = nullptr);
  /** Computes which points are occluded. */
  void Trace();

  size_t GetNumPoints() const { return m_lines.size(); }
  const CVector3& GetPoint(size_t number) const { return m_lines[number].End; }
  /** @return true if the point was visible in Trace(). */
  bool IsClear(size_t number) const { return m_lines[number].Hit >= m_lines[number].Limit; }

  /** Records line @p number for visualizations. */
  void Show(size_t number) const;

 private:
  struct SLine {
    CVector3 End;  // m, world frame
    const CEmbodiedEntity* Open;  // does not occlude the end; null if all others do
    Real DX, DY;  // from the eye to the end, m
    Real SquareLengthXY;  // m^2
    Real Limit;  // fraction of the length from which on bodies do not occlude the end
    Real Hit;  // fraction at which the line hits the first body; 1 if none
  };

  struct SDisc;

  void TraceShape(const CBodyIndex& index, const SIndexedShape& shape);
  void TraceOneByOne();
  Real FindHitBesides(const CEmbodiedEntity& open, const CRay3& ray) const;

  CRayCaster m_robot;  // for its body and its space
  CVector3 m_eye;  // m, world frame
  Real m_minZ = 0.0, m_maxZ = 0.0;  // m, world frame, of the eye and all points
  std::vector<SLine> m_lines;
};

}  // namespace argos

#endif
