#ifndef ARGOS3_COMPAT_QT_OPENGL_QTOPENGL_MAIN_WINDOW_H
#define ARGOS3_COMPAT_QT_OPENGL_QTOPENGL_MAIN_WINDOW_H

#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_widget.h>

namespace argos {

/** What user functions see of the window that this simulator does not have. */
class CQTOpenGLMainWindow {
 public:
  explicit CQTOpenGLMainWindow(CQTOpenGLUserFunctions& userFunctions) : m_widget(userFunctions) {}

  CQTOpenGLWidget& GetOpenGLWidget() { return m_widget; }

 private:
  CQTOpenGLWidget m_widget;
};

}  // namespace argos

#endif
