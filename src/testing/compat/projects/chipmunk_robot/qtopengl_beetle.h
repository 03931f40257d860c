#ifndef QTOPENGL_BEETLE_H
#define QTOPENGL_BEETLE_H

namespace argos {
class CQTOpenGLBeetle;
class CBeetleEntity;
}  // namespace argos

#include <QElapsedTimer>
#include <QOpenGLTexture>
#ifdef __APPLE__
#include <OpenGL/gl.h>
#else
#include <GL/gl.h>
#endif

#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_obj_model.h>

namespace argos {

/* Draws a beetle with display lists, as robots' plug-ins for ARGoS 3 do. */
class CQTOpenGLBeetle {
 public:
  CQTOpenGLBeetle();
  virtual ~CQTOpenGLBeetle();

  virtual void Draw(CBeetleEntity& c_entity);

 protected:
  void RenderWheel();
  void RenderBody();
  void RenderLED();
  void SetMaterial(GLfloat f_red, GLfloat f_green, GLfloat f_blue);
  void SetLEDMaterial(GLfloat f_red, GLfloat f_green, GLfloat f_blue);

 private:
  GLuint m_unLists;
  GLuint m_unBodyList;
  GLuint m_unWheelList;
  GLuint m_unLEDList;
  GLuint m_unVertices;
  CQTOpenGLObjModel m_cShell;
  CQTOpenGLObjModel::SMaterial& m_sLight;
  QElapsedTimer m_cTimer;
};

}  // namespace argos

#endif
