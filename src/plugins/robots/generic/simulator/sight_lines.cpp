#include <argos3/plugins/robots/generic/simulator/sight_lines.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/ray_queries.h>
#include <argos3/core/simulator/space/body_index.h>
#include <argos3/core/simulator/space/space.h>

#include <algorithm>
#include <cmath>

namespace argos {

void CSightLines::Start(const CVector3& eye) {
  m_eye = eye;
  m_lines.clear();
}

void CSightLines::Add(const CVector3& point) {
  const CVector3 toEnd = point - m_eye;
  const Real length = toEnd.Length();
  SLine line;
  line.End = point;
  line.DX = toEnd.GetX();
  line.DY = toEnd.GetY();
  line.SquareLengthXY = line.DX * line.DX + line.DY * line.DY;
  line.Limit = length > kTouch ? 1.0 - kTouch / length : 0.0;
  line.Hit = 1.0;
  m_lines.push_back(line);
}

void CSightLines::Trace() {
  if (m_lines.empty()) {
    return;
  }
  if (m_robot.AreBodiesOutsideIndex()) {
    TraceOneByOne();
    return;
  }
  // a circle around all lines, seen from above
  Real minX = m_eye.GetX();
  Real maxX = minX;
  Real minY = m_eye.GetY();
  Real maxY = minY;
  for (const SLine& line : m_lines) {
    minX = std::min(minX, line.End.GetX());
    maxX = std::max(maxX, line.End.GetX());
    minY = std::min(minY, line.End.GetY());
    maxY = std::max(maxY, line.End.GetY());
  }
  const Real reach = 0.5 * std::hypot(maxX - minX, maxY - minY);
  const CBodyIndex& index = m_robot.GetSpace().GetBodyIndex();
  const UInt32 ownBody = m_robot.GetBody().GetBodyNumber();
  index.ForShapesNear(0.5 * (minX + maxX), 0.5 * (minY + maxY), reach,
                      [&](const SIndexedShape& shape) {
                        if (shape.Body == ownBody) {
                          return;
                        }
                        for (SLine& line : m_lines) {
                          if (MayMeet(line, shape)) {
                            const Real hit = index.Intersect(shape, CRay3(m_eye, line.End));
                            line.Hit = std::min(line.Hit, hit);
                          }
                        }
                      });
}

// false only if the line misses the upright cylinder around the solid
bool CSightLines::MayMeet(const SLine& line, const SIndexedShape& shape) const {
  const Real low = std::min(m_eye.GetZ(), line.End.GetZ());
  const Real high = std::max(m_eye.GetZ(), line.End.GetZ());
  if (low > shape.ZMax || high < shape.ZMin) {
    return false;
  }
  const Real x = shape.X - m_eye.GetX();
  const Real y = shape.Y - m_eye.GetY();
  const Real squareRadius = shape.Radius * shape.Radius;
  const Real along = x * line.DX + y * line.DY;
  if (along <= 0.0) {
    return x * x + y * y <= squareRadius;
  }
  if (along >= line.SquareLengthXY) {
    const Real fromEndX = x - line.DX;
    const Real fromEndY = y - line.DY;
    return fromEndX * fromEndX + fromEndY * fromEndY <= squareRadius;
  }
  const Real aside = line.DX * y - line.DY * x;
  return aside * aside <= squareRadius * line.SquareLengthXY;
}

void CSightLines::TraceOneByOne() {
  SEmbodiedEntityIntersectionItem hit;
  for (SLine& line : m_lines) {
    if (GetClosestEmbodiedEntityIntersectedByRay(hit, CRay3(m_eye, line.End), m_robot.GetBody())) {
      line.Hit = hit.TOnRay;
    }
  }
}

void CSightLines::Show(size_t number) const {
  const CRay3 ray(m_eye, m_lines[number].End);
  const bool clear = IsClear(number);
  m_robot.GetRobot().AddCheckedRay(!clear, ray);
  if (!clear) {
    m_robot.GetRobot().AddIntersectionPoint(ray, m_lines[number].Hit);
  }
}

}  // namespace argos
