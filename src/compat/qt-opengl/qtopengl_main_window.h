#ifndef ARGOS3_COMPAT_QT_OPENGL_QTOPENGL_MAIN_WINDOW_H
#define ARGOS3_COMPAT_QT_OPENGL_QTOPENGL_MAIN_WINDOW_H

#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_obj_model.h>
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
  /** Folders of the installation, in which plug-ins install files: with a final slash. */
  const QString& GetIconDir() const { return m_icons; }
  const QString& GetTextureDir() const { return m_textures; }
  const QString& GetModelDir() const { return m_models; }

 private:
  CQTOpenGLWidget m_widget;
  QString m_icons = GetQtOpenGLFolder("icons");
  QString m_textures = GetQtOpenGLFolder("textures");
  QString m_models = GetQtOpenGLFolder("models");
};

}  // namespace argos

#endif
