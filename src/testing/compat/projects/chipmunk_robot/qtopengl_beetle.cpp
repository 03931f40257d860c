#include "qtopengl_beetle.h"

#include "beetle_entity.h"

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_widget.h>

namespace argos {

CQTOpenGLBeetle::CQTOpenGLBeetle()
    : m_unVertices(20), m_cShell("beetle.obj"), m_sLight(m_cShell.GetMaterial("light")) {
  m_unLists = glGenLists(3);
  if (m_unLists == 0) {
    return;
  }
  m_unBodyList = m_unLists;
  m_unWheelList = m_unLists + 1;
  m_unLEDList = m_unLists + 2;
  glNewList(m_unBodyList, GL_COMPILE);
  RenderBody();
  glEndList();
  glNewList(m_unWheelList, GL_COMPILE);
  RenderWheel();
  glEndList();
  glNewList(m_unLEDList, GL_COMPILE);
  RenderLED();
  glEndList();
  m_cTimer.start();
}

CQTOpenGLBeetle::~CQTOpenGLBeetle() {
  glDeleteLists(m_unLists, 3);
}

void CQTOpenGLBeetle::Draw(CBeetleEntity&) {
  m_sLight.Emission = {{1.0f, 0.0f, 0.0f, 1.0f}};
  m_cShell.Draw();
  glCallList(m_unBodyList);
  for (int nSide = -1; nSide <= 1; nSide += 2) {
    glPushMatrix();
    glTranslatef(0.0f, 0.055f * nSide, 0.02f);
    glRotatef(90.0f, 1.0f, 0.0f, 0.0f);
    glCallList(m_unWheelList);
    glPopMatrix();
  }
  // one that shines, and one that does not
  SetLEDMaterial(0.0f, 1.0f, 0.0f);
  glPushMatrix();
  glTranslatef(-0.03f, 0.0f, 0.0501f);
  glCallList(m_unLEDList);
  SetLEDMaterial(0.0f, 0.0f, 0.0f);
  glTranslatef(-0.025f, 0.0f, 0.0f);
  glCallList(m_unLEDList);
  glPopMatrix();
  if (m_cTimer.elapsed() > 1000) {
    m_cTimer.restart();
  }
}

void CQTOpenGLBeetle::SetMaterial(GLfloat f_red, GLfloat f_green, GLfloat f_blue) {
  const GLfloat pfColor[] = {f_red, f_green, f_blue, 1.0f};
  const GLfloat pfSpecular[] = {0.0f, 0.0f, 0.0f, 1.0f};
  const GLfloat pfShininess[] = {0.0f};
  const GLfloat pfEmission[] = {0.0f, 0.0f, 0.0f, 1.0f};
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, pfColor);
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, pfSpecular);
  glMaterialfv(GL_FRONT_AND_BACK, GL_SHININESS, pfShininess);
  glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, pfEmission);
}

void CQTOpenGLBeetle::SetLEDMaterial(GLfloat f_red, GLfloat f_green, GLfloat f_blue) {
  const GLfloat pfEmission[] = {f_red, f_green, f_blue, 1.0f};
  SetMaterial(f_red, f_green, f_blue);
  glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, pfEmission);
}

void CQTOpenGLBeetle::RenderWheel() {
  SetMaterial(0.1f, 0.1f, 0.1f);
  CVector2 cVertex(0.02f, 0.0f);
  CRadians cAngle(CRadians::TWO_PI / m_unVertices);
  glBegin(GL_QUAD_STRIP);
  for (GLuint i = 0; i <= m_unVertices; i++) {
    glNormal3d(cVertex.GetX(), cVertex.GetY(), 0.0f);
    glVertex3d(cVertex.GetX(), cVertex.GetY(), 0.005f);
    glVertex3d(cVertex.GetX(), cVertex.GetY(), 0.0f);
    cVertex.Rotate(cAngle);
  }
  glEnd();
  // the discs, of which the farther one is listed clockwise
  for (int nSide = 0; nSide <= 1; ++nSide) {
    glBegin(GL_POLYGON);
    glNormal3f(0.0f, 0.0f, nSide == 0 ? -1.0f : 1.0f);
    for (GLuint i = 0; i < m_unVertices; i++) {
      glVertex3d(cVertex.GetX(), cVertex.GetY(), 0.005f * nSide);
      cVertex.Rotate(nSide == 0 ? -cAngle : cAngle);
    }
    glEnd();
  }
}

void CQTOpenGLBeetle::RenderBody() {
  glEnable(GL_NORMALIZE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.0f, 1.0f);
  SetMaterial(1.0f, 0.6f, 0.1f);
  // the sides of a block of 12 x 8 x 3 cm, then its top and bottom
  const GLfloat pfCorners[][2] = {
      {0.06f, -0.04f}, {0.06f, 0.04f}, {-0.06f, 0.04f}, {-0.06f, -0.04f}};
  glBegin(GL_QUADS);
  for (int i = 0; i < 4; ++i) {
    const GLfloat* pfFrom = pfCorners[i];
    const GLfloat* pfTo = pfCorners[(i + 1) % 4];
    glNormal3f(pfTo[1] - pfFrom[1], pfFrom[0] - pfTo[0], 0.0f);
    glVertex3f(pfFrom[0], pfFrom[1], 0.02f);
    glVertex3f(pfTo[0], pfTo[1], 0.02f);
    glVertex3f(pfTo[0], pfTo[1], 0.05f);
    glVertex3f(pfFrom[0], pfFrom[1], 0.05f);
  }
  glNormal3f(0.0f, 0.0f, 1.0f);
  for (int i = 0; i < 4; ++i) {
    glTexCoord2f(0.0f, 0.0f);
    glVertex3f(pfCorners[i][0], pfCorners[i][1], 0.05f);
  }
  glNormal3f(0.0f, 0.0f, -1.0f);
  for (int i = 3; i >= 0; --i) {
    glVertex3f(pfCorners[i][0], pfCorners[i][1], 0.02f);
  }
  glEnd();
  glDisable(GL_POLYGON_OFFSET_FILL);
}

void CQTOpenGLBeetle::RenderLED() {
  CVector2 cVertex(0.01f, 0.0f);
  CRadians cAngle(CRadians::TWO_PI / m_unVertices);
  glBegin(GL_TRIANGLE_FAN);
  glNormal3f(0.0f, 0.0f, 1.0f);
  glVertex3f(0.0f, 0.0f, 0.0f);
  for (GLuint i = 0; i <= m_unVertices; i++) {
    glVertex3f(cVertex.GetX(), cVertex.GetY(), 0.0f);
    cVertex.Rotate(cAngle);
  }
  glEnd();
}

class CQTOpenGLOperationDrawBeetleNormal : public CQTOpenGLOperationDrawNormal {
 public:
  void ApplyTo(CQTOpenGLWidget& c_visualization, CBeetleEntity& c_entity) {
    static CQTOpenGLBeetle m_cModel;
    c_visualization.DrawRays(c_entity.GetControllableEntity());
    c_visualization.DrawEntity(c_entity.GetEmbodiedEntity());
    m_cModel.Draw(c_entity);
  }
};

class CQTOpenGLOperationDrawBeetleSelected : public CQTOpenGLOperationDrawSelected {
 public:
  void ApplyTo(CQTOpenGLWidget& c_visualization, CBeetleEntity& c_entity) {
    c_visualization.DrawBoundingBox(c_entity.GetEmbodiedEntity());
  }
};

REGISTER_QTOPENGL_ENTITY_OPERATION(CQTOpenGLOperationDrawNormal, CQTOpenGLOperationDrawBeetleNormal,
                                   CBeetleEntity);

REGISTER_QTOPENGL_ENTITY_OPERATION(CQTOpenGLOperationDrawSelected,
                                   CQTOpenGLOperationDrawBeetleSelected, CBeetleEntity);

}  // namespace argos
