#include "gl_state.h"

#include <argos3/core/utility/logging/argos_log.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace argos {

namespace {

// of all that is drawn to one picture, which takes some 200 bytes a triangle
constexpr std::size_t kMaxShapes = 1000000;
constexpr std::size_t kMaxPushed = 1024;
constexpr std::size_t kMaxDepth = 64;  // that of OpenGL
constexpr std::size_t kMaxRepeated = 10000000;  // of lists, in a hook

// light from above, ahead of the camera's usual place
const CVector3 kToLight = CVector3(-0.3, 0.4, 0.85).Normalize();
constexpr Real kSkyLight = 0.45;  // share of the light that comes from everywhere

UInt8 ToByte(Real share) {
  return std::isfinite(share) ? static_cast<UInt8>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)))
                              : 0;
}

CVector3 Cross(CVector3 a, const CVector3& b) {
  return a.CrossProduct(b);
}

CVector3 ToVector(const std::array<GLdouble, 4>& values) {
  return CVector3(values[0], values[1], values[2]);
}

bool HasRoom(const CDrawing& drawing) {
  if (drawing.GetShapes().size() < kMaxShapes) {
    return true;
  }
  WarnOfGl("OpenGL calls draw more than 1,000,000 shapes to a picture: the others are left out");
  return false;
}

}  // namespace

void WarnOfGl(const char* text) {
  static thread_local std::set<std::string> written;
  if (written.insert(text).second) {
    LOGERR << "[WARNING] " << text << std::endl;
  }
}

void CGlState::Do(const SGlCommand& command, CDrawing& drawing) {
  typedef SGlCommand::EKind EKind;
  switch (command.Kind) {
    case EKind::Begin:
      return Begin(command.Number);
    case EKind::End:
      return End(drawing);
    case EKind::Vertex:
      return AddVertex(ToVector(command.Values), drawing);
    case EKind::Normal:
      m_normal = ToVector(command.Values);
      return;
    case EKind::Color:
      m_attributes.Color = command.Values;
      m_attributes.IsLit = false;
      return;
    case EKind::Diffuse:
      m_attributes.Diffuse = command.Values;
      m_attributes.IsLit = true;
      return;
    case EKind::Emission:
      m_attributes.Emission = command.Values;
      m_attributes.IsLit = true;
      return;
    case EKind::Switch:
      return Switch(command.Number, command.Values[0] != 0.0);
    case EKind::LineWidth:
      m_attributes.LineWidth = command.Values[0];
      return;
    case EKind::PointSize:
      m_attributes.PointSize = command.Values[0];
      return;
    case EKind::PushAttributes:
      if (m_pushedAttributes.size() < kMaxPushed) {
        m_pushedAttributes.push_back(m_attributes);
      }
      return;
    case EKind::PopAttributes:
      if (!m_pushedAttributes.empty()) {
        m_attributes = m_pushedAttributes.back();
        m_pushedAttributes.pop_back();
      }
      return;
    case EKind::MatrixMode:
      m_isModelMatrix = command.Number == GL_MODELVIEW;
      return;
    case EKind::Call:
      return Call(command.Number, drawing);
    default:
      return DoMatrix(command, drawing);
  }
}

// Others than the model's matrix are of the camera and of textures.
void CGlState::DoMatrix(const SGlCommand& command, CDrawing& drawing) {
  typedef SGlCommand::EKind EKind;
  if (!m_isModelMatrix) {
    return;
  }
  const CVector3 values = ToVector(command.Values);
  if (command.Kind == EKind::PushMatrix) {
    Push(drawing);
  } else if (command.Kind == EKind::PopMatrix) {
    Pop(drawing);
  } else if (command.Kind == EKind::Translate) {
    drawing.MoveFrame(m_linear(values), CQuaternion());
  } else if (command.Kind == EKind::Rotate && values.SquareLength() > 0.0) {
    CVector3 axis = values;
    Rotate(CQuaternion(ToRadians(CDegrees(command.Values[3])), axis.Normalize()), drawing);
  } else if (command.Kind == EKind::Scale) {
    Multiply(
        {CVector3::X * values.GetX(), CVector3::Y * values.GetY(), CVector3::Z * values.GetZ()});
  } else if (command.Kind == EKind::Column) {
    (command.Number == 0 ? m_columns.X : command.Number == 1 ? m_columns.Y : m_columns.Z) = values;
    if (command.Number == 2) {
      Multiply(m_columns);
    }
  }
}

// The frame F and the linear part M give F M. A rotation R makes that F M R = (F R) (R^-1 M R).
void CGlState::Rotate(const CQuaternion& rotation, CDrawing& drawing) {
  drawing.MoveFrame(CVector3(), rotation);
  const CQuaternion back = rotation.Conjugate();
  const auto turn = [&](CVector3 axis) {
    CVector3 column = m_linear(axis.Rotate(rotation));
    return column.Rotate(back);
  };
  m_linear = {turn(CVector3::X), turn(CVector3::Y), turn(CVector3::Z)};
}

void CGlState::Multiply(const SLinear& right) {
  m_linear = {m_linear(right.X), m_linear(right.Y), m_linear(right.Z)};
}

void CGlState::Push(const CDrawing& drawing) {
  if (m_frames.size() < kMaxPushed) {
    m_frames.push_back({drawing.GetFramePosition(), drawing.GetFrameOrientation(), m_linear});
  } else {
    ++m_framesLeftOut;
    WarnOfGl("glPushMatrix() is called more often than glPopMatrix(), by more than 1,024 times");
  }
}

void CGlState::Pop(CDrawing& drawing) {
  if (m_framesLeftOut > 0) {
    --m_framesLeftOut;
  } else if (!m_frames.empty()) {
    drawing.SetFrame(m_frames.back().Position, m_frames.back().Orientation);
    m_linear = m_frames.back().Linear;
    m_frames.pop_back();
  }
}

void CGlState::Call(GLuint list, CDrawing& drawing) {
  const std::shared_ptr<const TGlList> commands = CGlLists::Get().Find(list);
  if (commands == nullptr) {
    return;
  }
  if (m_depth >= kMaxDepth) {
    WarnOfGl("Display lists call each other more than 64 deep: the calls below are left out");
    return;
  }
  ++m_depth;
  for (const SGlCommand& command : *commands) {
    if (++m_numCommands > kMaxRepeated) {
      WarnOfGl(
          "Display lists repeat more than 10,000,000 calls for an entity: the others are left "
          "out");
      break;
    }
    Do(command, drawing);
  }
  --m_depth;
}

void CGlState::Switch(GLuint what, bool isOn) {
  (what == GL_LIGHTING ? m_attributes.IsLit : m_attributes.IsBlended) = isOn;
}

void CGlState::Begin(GLuint shape) {
  m_isInShape = true;
  m_shape = shape;
  m_count = 0;
}

void CGlState::End(CDrawing& drawing) {
  if (m_isInShape && m_shape == GL_LINE_LOOP && m_count > 2) {
    DrawLine(m_last[2], m_first, drawing);
  }
  m_isInShape = false;
}

void CGlState::AddVertex(const CVector3& vertex, CDrawing& drawing) {
  if (!m_isInShape) {
    return;
  }
  const CVector3 point = m_linear(vertex);
  if (m_count == 0) {
    m_first = point;
  }
  if (m_shape == GL_POINTS && HasRoom(drawing)) {
    drawing.DrawPoint(point, MixColor(1.0), m_attributes.PointSize);
  } else if (m_shape == GL_LINES || m_shape == GL_LINE_STRIP || m_shape == GL_LINE_LOOP) {
    AddToLines(point, drawing);
  } else {
    AddToFaces(point, drawing);
  }
  m_last = {m_last[1], m_last[2], point};
  ++m_count;
}

void CGlState::AddToLines(const CVector3& point, CDrawing& drawing) {
  if (m_shape == GL_LINES ? m_count % 2 == 1 : m_count > 0) {
    DrawLine(m_last[2], point, drawing);
  }
}

// The triangles that a vertex completes, counter-clockwise if the vertices are.
void CGlState::AddToFaces(const CVector3& point, CDrawing& drawing) {
  const bool isOdd = m_count % 2 == 1;
  switch (m_shape) {
    case GL_TRIANGLES:
      if (m_count % 3 == 2) {
        DrawTriangle(m_last[1], m_last[2], point, drawing);
      }
      return;
    case GL_TRIANGLE_STRIP:
      if (m_count >= 2) {
        DrawTriangle(m_last[isOdd ? 2 : 1], m_last[isOdd ? 1 : 2], point, drawing);
      }
      return;
    case GL_TRIANGLE_FAN:
    case GL_POLYGON:
      if (m_count >= 2) {
        DrawTriangle(m_first, m_last[2], point, drawing);
      }
      return;
    case GL_QUADS:
      if (m_count % 4 == 3) {
        DrawTriangle(m_last[0], m_last[1], m_last[2], drawing);
        DrawTriangle(m_last[0], m_last[2], point, drawing);
      }
      return;
    case GL_QUAD_STRIP:
      if (m_count >= 3 && isOdd) {
        DrawTriangle(m_last[0], m_last[1], point, drawing);
        DrawTriangle(m_last[0], point, m_last[2], drawing);
      }
      return;
    default:
      return;
  }
}

void CGlState::DrawLine(const CVector3& from, const CVector3& to, CDrawing& drawing) {
  if (HasRoom(drawing)) {
    drawing.DrawLine(from, to, MixColor(1.0), m_attributes.LineWidth);
  }
}

void CGlState::DrawTriangle(const CVector3& a, const CVector3& b, const CVector3& c,
                            CDrawing& drawing) {
  CVector3 normal = Cross(b - a, c - a);
  if (!(normal.SquareLength() > 0.0) || !HasRoom(drawing)) {
    return;
  }
  normal.Normalize();
  // normals are turned by the inverse of the transposed matrix, here times its determinant
  const CVector3 towardsX = Cross(m_linear.Y, m_linear.Z);
  const SLinear turn{towardsX, Cross(m_linear.Z, m_linear.X), Cross(m_linear.X, m_linear.Y)};
  const Real determinant = towardsX.DotProduct(m_linear.X);
  if (determinant * normal.DotProduct(turn(m_normal)) < 0.0) {
    normal = -normal;
  }
  normal.Rotate(drawing.GetFrameOrientation());
  const Real direct = std::max(0.0, normal.DotProduct(kToLight));
  drawing.DrawFace({a, b, c}, MixColor(kSkyLight + (1.0 - kSkyLight) * direct));
}

CColor CGlState::MixColor(Real light) const {
  const SAttributes& from = m_attributes;
  const auto channel = [&](std::size_t i) {
    return ToByte(from.IsLit ? from.Emission[i] + light * from.Diffuse[i] : from.Color[i]);
  };
  const Real alpha = from.IsLit ? from.Diffuse[3] : from.Color[3];
  return CColor(channel(0), channel(1), channel(2), from.IsBlended ? ToByte(alpha) : 255);
}

}  // namespace argos
