#include <argos3/core/simulator/visualization/drawing.h>

#include <argos3/core/utility/logging/argos_log.h>

#include <cmath>

namespace argos {

namespace {

constexpr Real kOutlineWidth = 1.5;  // pixels

const char* NameOf(SDrawnShape::EKind kind) {
  switch (kind) {
    case SDrawnShape::EKind::Point:
      return "point";
    case SDrawnShape::EKind::Line:
      return "line";
    case SDrawnShape::EKind::Polygon:
      return "polygon";
    case SDrawnShape::EKind::Circle:
      return "circle";
    case SDrawnShape::EKind::Cylinder:
      return "cylinder";
    case SDrawnShape::EKind::Box:
      return "box";
    case SDrawnShape::EKind::Text:
      return "text";
  }
  return "shape";
}

// a sum is finite only if all its terms are
bool IsFinite(const SDrawnShape& shape) {
  const CQuaternion& q = shape.Orientation;
  const Real sum = shape.Position.GetX() + shape.Position.GetY() + shape.Position.GetZ() +
                   shape.Size.GetX() + shape.Size.GetY() + shape.Size.GetZ() + q.GetW() + q.GetX() +
                   q.GetY() + q.GetZ() + shape.Pixels;
  return std::isfinite(sum);
}

}  // namespace

void CDrawing::Begin(UInt32 width, UInt32 height) {
  m_shapes.clear();
  m_corners.clear();
  m_texts.clear();
  m_styles.clear();
  m_width = width;
  m_height = height;
  SetWorldFrame();
}

void CDrawing::SetFrame(const CVector3& position, const CQuaternion& orientation) {
  m_framePosition = position;
  m_frameOrientation = orientation;
  m_space = SDrawnShape::ESpace::World;
}

void CDrawing::MoveFrame(const CVector3& position, const CQuaternion& orientation) {
  CVector3 offset = position;
  m_framePosition += offset.Rotate(m_frameOrientation);
  m_frameOrientation *= orientation;
}

void CDrawing::SetWorldFrame() {
  SetFrame(CVector3(), CQuaternion());
}

void CDrawing::SetOverlay() {
  SetWorldFrame();
  m_space = SDrawnShape::ESpace::Overlay;
}

SDrawnShape CDrawing::MakeShape(SDrawnShape::EKind kind, const CVector3& position,
                                const CColor& color) {
  SDrawnShape shape;
  shape.Kind = kind;
  shape.Space = m_space;
  shape.Color = color;
  shape.Position = position;
  shape.Position.Rotate(m_frameOrientation);
  shape.Position += m_framePosition;
  return shape;
}

void CDrawing::Rotate(SDrawnShape& shape, const CQuaternion& orientation) const {
  shape.Orientation = m_frameOrientation * orientation;
}

bool CDrawing::Add(const SDrawnShape& shape, Real sizes) {
  if (!IsFinite(shape) || !std::isfinite(sizes)) {
    if (!m_hasWarned) {
      LOGERR << "[WARNING] A " << NameOf(shape.Kind) << " at (" << shape.Position
             << ") is not drawn: its position or size is infinite or not a number. Other such "
                "shapes are left out without a warning"
             << std::endl;
      m_hasWarned = true;
    }
    return false;
  }
  m_shapes.push_back(shape);
  return true;
}

void CDrawing::DrawPoint(const CVector3& position, const CColor& color, Real diameter) {
  SDrawnShape shape = MakeShape(SDrawnShape::EKind::Point, position, color);
  shape.Pixels = diameter;
  Add(shape);
}

void CDrawing::DrawLine(const CVector3& start, const CVector3& end, const CColor& color,
                        Real width) {
  SDrawnShape shape = MakeShape(SDrawnShape::EKind::Line, start, color);
  shape.Size = end - start;
  shape.Size.Rotate(m_frameOrientation);
  shape.Pixels = width;
  Add(shape);
}

void CDrawing::DrawTriangle(const CVector3& position, const CQuaternion& orientation, Real base,
                            Real height, const CColor& color, bool fill) {
  DrawPolygon(position, orientation,
              {CVector2(0.5 * height, 0.0), CVector2(-0.5 * height, 0.5 * base),
               CVector2(-0.5 * height, -0.5 * base)},
              color, fill);
}

void CDrawing::DrawPolygon(const CVector3& position, const CQuaternion& orientation,
                           const std::vector<CVector2>& corners, const CColor& color, bool fill) {
  if (corners.size() < 3) {
    return;
  }
  SDrawnShape shape = MakeShape(SDrawnShape::EKind::Polygon, position, color);
  Rotate(shape, orientation);
  shape.IsFilled = fill;
  shape.Pixels = fill ? 0.0 : kOutlineWidth;
  shape.First = static_cast<UInt32>(m_corners.size());
  shape.Count = static_cast<UInt32>(corners.size());
  Real sizes = 0.0;
  for (const CVector2& corner : corners) {
    sizes += corner.GetX() + corner.GetY();
  }
  if (Add(shape, sizes)) {
    m_corners.insert(m_corners.end(), corners.begin(), corners.end());
  }
}

void CDrawing::DrawFace(const CVector3& position, const CQuaternion& orientation,
                        const std::vector<CVector2>& corners, const CColor& color) {
  const std::size_t count = m_shapes.size();
  if (m_space == SDrawnShape::ESpace::World) {
    DrawPolygon(position, orientation, corners, color);
  }
  if (m_shapes.size() > count) {
    m_shapes.back().IsFace = true;
  }
}

void CDrawing::DrawFace(const std::array<CVector3, 3>& corners, const CColor& color) {
  CVector3 normal = corners[1] - corners[0];
  normal.CrossProduct(corners[2] - corners[0]);
  if (!(normal.SquareLength() > 0.0)) {
    return;
  }
  const CQuaternion orientation(CVector3::Z, normal.Normalize());
  const CQuaternion toFace = orientation.Conjugate();
  std::vector<CVector2> flat;
  for (const CVector3& corner : corners) {
    CVector3 point = corner - corners[0];
    point.Rotate(toFace);
    flat.emplace_back(point.GetX(), point.GetY());
  }
  DrawFace(corners[0], orientation, flat, color);
}

void CDrawing::DrawCircle(const CVector3& position, const CQuaternion& orientation, Real radius,
                          const CColor& color, bool fill, UInt32 corners) {
  SDrawnShape shape = MakeShape(SDrawnShape::EKind::Circle, position, color);
  Rotate(shape, orientation);
  shape.IsFilled = fill;
  shape.Pixels = fill ? 0.0 : kOutlineWidth;
  shape.Size.SetX(radius);
  shape.Count = corners;
  Add(shape);
}

void CDrawing::DrawCylinder(const CVector3& position, const CQuaternion& orientation, Real radius,
                            Real height, const CColor& color) {
  SDrawnShape shape = MakeShape(SDrawnShape::EKind::Cylinder, position, color);
  Rotate(shape, orientation);
  shape.Size.Set(2.0 * radius, 2.0 * radius, height);
  Add(shape);
}

void CDrawing::DrawBox(const CVector3& position, const CQuaternion& orientation,
                       const CVector3& size, const CColor& color) {
  SDrawnShape shape = MakeShape(SDrawnShape::EKind::Box, position, color);
  Rotate(shape, orientation);
  shape.Size = size;
  Add(shape);
}

void CDrawing::DrawText(const CVector3& position, std::string_view text, const CColor& color,
                        const STextStyle& style) {
  SDrawnShape shape = MakeShape(SDrawnShape::EKind::Text, position, color);
  shape.Pixels = style.Size;
  shape.First = static_cast<UInt32>(m_texts.size());
  shape.Count = static_cast<UInt32>(text.size());
  // most texts of a picture share their style
  const bool isNewStyle = m_styles.empty() || !(m_styles.back() == style);
  shape.Style = static_cast<UInt32>(m_styles.size()) - (isNewStyle ? 0 : 1);
  if (Add(shape)) {
    m_texts.append(text);
    if (isNewStyle) {
      m_styles.push_back(style);
    }
  }
}

}  // namespace argos
