#include <argos3/plugins/simulator/visualizations/qt-opengl/gl_calls.h>

#include <argos3/core/simulator/visualization/drawing_functions.h>

namespace argos {

namespace {

// between glNewList() and glEndList(), where calls do not draw
thread_local bool g_isInList = false;

CDrawing* CurrentDrawing() {
  return g_isInList ? nullptr : CDrawingFunctions::GetCurrentDrawing();
}

}  // namespace

void PushGlMatrix() {
  if (CDrawing* const drawing = CurrentDrawing()) {
    drawing->PushFrame();
  }
}

void PopGlMatrix() {
  if (CDrawing* const drawing = CurrentDrawing()) {
    drawing->PopFrame();
  }
}

void TranslateGlMatrix(GLdouble x, GLdouble y, GLdouble z) {
  if (CDrawing* const drawing = CurrentDrawing()) {
    drawing->MoveFrame(CVector3(x, y, z), CQuaternion());
  }
}

void RotateGlMatrix(GLdouble angle, GLdouble x, GLdouble y, GLdouble z) {
  CVector3 axis(x, y, z);
  CDrawing* const drawing = CurrentDrawing();
  if (drawing != nullptr && axis.SquareLength() > 0.0) {
    drawing->MoveFrame(CVector3(), CQuaternion(ToRadians(CDegrees(angle)), axis.Normalize()));
  }
}

void BeginGlList(GLuint /*list*/, GLenum mode) {
  g_isInList = mode == GL_COMPILE;
}

void EndGlList() {
  g_isInList = false;
}

bool IsInGlList() {
  return g_isInList;
}

}  // namespace argos
