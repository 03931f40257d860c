#ifndef ARGOS3_COMPAT_QT_OPENGL_QTOPENGL_MAIN_WINDOW_H
#define ARGOS3_COMPAT_QT_OPENGL_QTOPENGL_MAIN_WINDOW_H

#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_widget.h>

namespace argos {

/** What user functions see of the window that this simulator does not have. */
class CQTOpenGLMainWindow : public QMainWindow {
 public:
  explicit CQTOpenGLMainWindow(CQTOpenGLUserFunctions& userFunctions) : m_widget(userFunctions) {}

  CQTOpenGLWidget& GetOpenGLWidget() { return m_widget; }
  const CQTOpenGLWidget& GetOpenGLWidget() const { return m_widget; }
  CQTOpenGLUserFunctions& GetUserFunctions() { return m_widget.GetUserFunctions(); }
  const CQTOpenGLUserFunctions& GetUserFunctions() const {
    return const_cast<CQTOpenGLWidget&>(m_widget).GetUserFunctions();
  }
  /** Folders of icons, textures and models: empty, there are none. */
  const QString& GetIconDir() const { return m_folder; }
  const QString& GetTextureDir() const { return m_folder; }
  const QString& GetModelDir() const { return m_folder; }

 private:
  CQTOpenGLWidget m_widget;
  QString m_folder;
};

}  // namespace argos

#endif
