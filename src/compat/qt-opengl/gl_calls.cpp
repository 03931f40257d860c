#include <argos3/plugins/simulator/visualizations/qt-opengl/gl_calls.h>

#include <argos3/core/simulator/visualization/drawing_functions.h>

#include "gl_state.h"

#include <utility>

namespace argos {

namespace {

typedef SGlCommand::EKind ECall;

constexpr std::size_t kMaxListCommands = 1000000;

// What calls have set on a thread: in one hook, or outside of hooks since the last one.
struct SGlThread {
  CGlState State;
  UInt64 Hook = 0;
  bool IsInList = false;
  GLuint List = 0;
  bool IsExecuted = false;  // what is called is also done
  TGlList Commands;
};

SGlThread& GetThread() {
  static thread_local SGlThread thread;
  const UInt64 hook = CDrawingFunctions::GetNumHooks();
  if (thread.Hook != hook) {
    if (thread.IsInList) {
      WarnOfGl("glNewList() without glEndList(): the display list is left out");
    }
    if (thread.State.IsInShape()) {
      WarnOfGl("glBegin() without glEnd(): the shape ends with what draws the entity");
    }
    thread = SGlThread();
    thread.Hook = hook;
  }
  return thread;
}

// Keeps a call in a list, or does it.
void Do(ECall kind, GLuint number = 0, const std::array<GLdouble, 4>& values = {}) {
  SGlThread& thread = GetThread();
  const SGlCommand command{kind, number, values};
  if (thread.IsInList) {
    if (thread.Commands.size() < kMaxListCommands) {
      thread.Commands.push_back(command);
    } else {
      WarnOfGl("A display list has more than 1,000,000 calls: the others are left out");
    }
    if (!thread.IsExecuted) {
      return;
    }
  }
  CDrawing* const drawing = CDrawingFunctions::GetCurrentDrawing();
  if (drawing != nullptr && !drawing->IsOverlay()) {
    thread.State.Do(command, *drawing);
  }
}

void SwitchGl(GLenum what, bool isOn) {
  if (what == GL_LIGHTING || what == GL_BLEND) {
    Do(ECall::Switch, what, {isOn ? 1.0 : 0.0});
  }
}

}  // namespace

void BeginGl(GLenum shape) {
  Do(ECall::Begin, shape);
}

void EndGl() {
  Do(ECall::End);
}

void AddGlVertex(GLdouble x, GLdouble y, GLdouble z) {
  Do(ECall::Vertex, 0, {x, y, z});
}

void SetGlNormal(GLdouble x, GLdouble y, GLdouble z) {
  Do(ECall::Normal, 0, {x, y, z});
}

void SetGlColor(GLdouble red, GLdouble green, GLdouble blue, GLdouble alpha) {
  Do(ECall::Color, 0, {red, green, blue, alpha});
}

void SetGlColorBytes(GLubyte red, GLubyte green, GLubyte blue, GLubyte alpha) {
  constexpr GLdouble kOne = 255.0;
  SetGlColor(red / kOne, green / kOne, blue / kOne, alpha / kOne);
}

void SetGlMaterial(GLenum face, GLenum kind, const GLfloat* values) {
  if (face == GL_BACK) {
    return;
  }
  const bool isDiffuse = kind == GL_DIFFUSE || kind == GL_AMBIENT_AND_DIFFUSE;
  if (isDiffuse || kind == GL_EMISSION) {
    Do(isDiffuse ? ECall::Diffuse : ECall::Emission, 0,
       {values[0], values[1], values[2], values[3]});
  }
}

void SwitchGlOn(GLenum what) {
  SwitchGl(what, true);
}

void SwitchGlOff(GLenum what) {
  SwitchGl(what, false);
}

void SetGlLineWidth(GLdouble width) {
  Do(ECall::LineWidth, 0, {width});
}

void SetGlPointSize(GLdouble size) {
  Do(ECall::PointSize, 0, {size});
}

void PushGlAttributes(GLbitfield /*kinds*/) {
  Do(ECall::PushAttributes);
}

void PopGlAttributes() {
  Do(ECall::PopAttributes);
}

void DrawGlRectangle(GLdouble x1, GLdouble y1, GLdouble x2, GLdouble y2) {
  BeginGl(GL_QUADS);
  AddGlVertex(x1, y1);
  AddGlVertex(x2, y1);
  AddGlVertex(x2, y2);
  AddGlVertex(x1, y2);
  EndGl();
}

void SetGlMatrixMode(GLenum mode) {
  Do(ECall::MatrixMode, mode);
}

void PushGlMatrix() {
  Do(ECall::PushMatrix);
}

void PopGlMatrix() {
  Do(ECall::PopMatrix);
}

void TranslateGlMatrix(GLdouble x, GLdouble y, GLdouble z) {
  Do(ECall::Translate, 0, {x, y, z});
}

void RotateGlMatrix(GLdouble angle, GLdouble x, GLdouble y, GLdouble z) {
  Do(ECall::Rotate, 0, {x, y, z, angle});
}

void ScaleGlMatrix(GLdouble x, GLdouble y, GLdouble z) {
  Do(ECall::Scale, 0, {x, y, z});
}

void SetGlMatrixColumn(GLuint column, GLdouble x, GLdouble y, GLdouble z) {
  Do(ECall::Column, column, {x, y, z});
}

GLuint ReserveGlLists(GLsizei count) {
  return CGlLists::Get().Reserve(count);
}

void BeginGlList(GLuint list, GLenum mode) {
  SGlThread& thread = GetThread();
  thread.IsInList = true;
  thread.List = list;
  thread.IsExecuted = mode == GL_COMPILE_AND_EXECUTE;
  thread.Commands.clear();
}

void EndGlList() {
  SGlThread& thread = GetThread();
  if (thread.IsInList && !CGlLists::Get().Set(thread.List, std::exchange(thread.Commands, {}))) {
    WarnOfGl("Display lists have more than 5,000,000 calls: the others are left out");
  }
  thread.IsInList = false;
}

void CallGlList(GLuint list) {
  Do(ECall::Call, list);
}

// not of the thread: called also when the process ends
void DeleteGlLists(GLuint first, GLsizei count) {
  CGlLists::Get().Delete(first, count);
}

GLboolean IsGlList(GLuint list) {
  return CGlLists::Get().Find(list) != nullptr ? GL_TRUE : GL_FALSE;
}

}  // namespace argos
