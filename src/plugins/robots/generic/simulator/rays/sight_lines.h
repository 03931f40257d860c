#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_SIGHT_LINES_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_SIGHT_LINES_H

#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/robots/generic/simulator/ray_caster.h>

#include <vector>

namespace argos {

class CBodyIndex;
class CComposableEntity;
struct SIndexedShape;

/**
 * Tells which of many points can be seen from one place: to which ones no body is in the way.
 *
 * All lines share one query for the solids around them. They look through the robot's own body. A
 * body hides nothing that lies on its surface, to within kTouch, on the side of the viewer: so LEDs
 * and tags may be mounted flush.
 *
 * Keeps its memory from look to look.
 */
class CSightLines {
 public:
  static constexpr Real kTouch = 1e-9;  // m; far above roundings, far below any body

  /** @throws CARGoSException if the robot has no "body" or "controller". */
  void SetRobot(CComposableEntity& robot) { m_robot.SetRobot(robot); }

  /** Starts a new look, without points. @param eye m, world frame. */
  void Start(const CVector3& eye);
  /** Makes room for so many lines. */
  void Reserve(size_t num) { m_lines.reserve(num); }
  /** @param point m, world frame. */
  void Add(const CVector3& point);
  /** Finds out which points are hidden. */
  void Trace();

  size_t GetNumPoints() const { return m_lines.size(); }
  const CVector3& GetPoint(size_t number) const { return m_lines[number].End; }
  /** As of Trace(). */
  bool IsClear(size_t number) const { return m_lines[number].Hit >= m_lines[number].Limit; }

  /** Records line @p number, to be drawn. */
  void Show(size_t number) const;

 private:
  struct SLine {
    CVector3 End;  // m, world frame
    Real DX, DY;  // from the eye to the end, m
    Real SquareLengthXY;  // m^2
    Real Limit;  // fraction of the length from which on bodies do not hide the end
    Real Hit;  // fraction at which the line meets the first body; 1 if none
  };

  struct SDisc;

  void TraceShape(const CBodyIndex& index, const SIndexedShape& shape);
  void TraceOneByOne();

  CRayCaster m_robot;  // for its body and its space
  CVector3 m_eye;  // m, world frame
  Real m_minZ = 0.0, m_maxZ = 0.0;  // m, world frame, of the eye and all points
  std::vector<SLine> m_lines;
};

}  // namespace argos

#endif
