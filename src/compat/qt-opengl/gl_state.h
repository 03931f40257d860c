#ifndef ARGOS3_COMPAT_QT_OPENGL_GL_STATE_H
#define ARGOS3_COMPAT_QT_OPENGL_GL_STATE_H

#include <argos3/core/simulator/visualization/drawing.h>

#include "gl_lists.h"

#include <array>
#include <cstddef>
#include <vector>

namespace argos {

/**
 * What OpenGL calls of one hook have set, and the faces and lines that they draw.
 *
 * The frame of the drawing holds what a matrix moves and turns; what it scales is held here.
 */
class CGlState {
 public:
  /** Anything is drawn to @p drawing, which is the same in a hook. */
  void Do(const SGlCommand& command, CDrawing& drawing);
  /** True between glBegin() and glEnd(). */
  bool IsInShape() const { return m_isInShape; }

 private:
  typedef std::array<GLdouble, 4> TColor;

  // columns of a matrix without translation
  struct SLinear {
    CVector3 X = CVector3::X;
    CVector3 Y = CVector3::Y;
    CVector3 Z = CVector3::Z;

    CVector3 operator()(const CVector3& v) const {
      return X * v.GetX() + Y * v.GetY() + Z * v.GetZ();
    }
  };
  struct SFrame {
    CVector3 Position;
    CQuaternion Orientation;
    SLinear Linear;
  };
  struct SAttributes {
    TColor Color{{1.0, 1.0, 1.0, 1.0}};  // not lit
    TColor Diffuse{{0.8, 0.8, 0.8, 1.0}};  // of the material; the default of OpenGL
    TColor Emission{{0.0, 0.0, 0.0, 1.0}};
    bool IsLit = true;  // the material counts, else the colour
    bool IsBlended = false;  // alpha counts
    Real LineWidth = 1.0;
    Real PointSize = 1.0;
  };

  void DoMatrix(const SGlCommand& command, CDrawing& drawing);
  void Rotate(const CQuaternion& rotation, CDrawing& drawing);
  void Multiply(const SLinear& right);
  void Push(const CDrawing& drawing);
  void Pop(CDrawing& drawing);
  void Call(GLuint list, CDrawing& drawing);
  void Switch(GLuint what, bool isOn);

  void Begin(GLuint shape);
  void End(CDrawing& drawing);
  void AddVertex(const CVector3& vertex, CDrawing& drawing);
  void AddToLines(const CVector3& point, CDrawing& drawing);
  void AddToFaces(const CVector3& point, CDrawing& drawing);
  void DrawLine(const CVector3& from, const CVector3& to, CDrawing& drawing);
  void DrawTriangle(const CVector3& a, const CVector3& b, const CVector3& c, CDrawing& drawing);
  /** @param light  on the surface, from 0 to 1. */
  CColor MixColor(Real light) const;

  SAttributes m_attributes;
  std::vector<SAttributes> m_pushedAttributes;
  SLinear m_linear;
  SLinear m_columns;  // of a matrix that is being read
  std::vector<SFrame> m_frames;  // pushed ones
  std::size_t m_framesLeftOut = 0;  // pushed above the limit
  bool m_isModelMatrix = true;
  std::size_t m_depth = 0;  // of lists that call lists
  std::size_t m_numCommands = 0;  // of lists
  CVector3 m_normal = CVector3::Z;

  bool m_isInShape = false;
  GLuint m_shape = GL_POINTS;
  std::size_t m_count = 0;  // of vertices since glBegin()
  CVector3 m_first;
  std::array<CVector3, 3> m_last;  // the newest vertex is the last
};

/** Writes a warning, each text once on a thread. */
void WarnOfGl(const char* text);

}  // namespace argos

#endif
