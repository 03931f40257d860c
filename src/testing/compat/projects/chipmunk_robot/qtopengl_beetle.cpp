#include "qtopengl_beetle.h"

#include "beetle_entity.h"

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_widget.h>

namespace argos {

CQTOpenGLBeetle::CQTOpenGLBeetle()
    : m_unVertices(20), m_cShell("beetle.obj"), m_sLight(m_cShell.GetMaterial("light")) {
  m_unLists = glGenLists(2);
  if (m_unLists == 0) {
    return;
  }
  m_unBodyList = m_unLists;
  m_unWheelList = m_unLists + 1;
  glNewList(m_unBodyList, GL_COMPILE);
  RenderBody();
  glEndList();
  glNewList(m_unWheelList, GL_COMPILE);
  RenderWheel();
  glEndList();
  m_cTimer.start();
}

CQTOpenGLBeetle::~CQTOpenGLBeetle() {
  glDeleteLists(m_unLists, 2);
}

void CQTOpenGLBeetle::Draw(CBeetleEntity&) {
  m_sLight.Emission = {{1.0f, 0.0f, 0.0f, 1.0f}};
  m_cShell.Draw();
  glCallList(m_unBodyList);
  glPushMatrix();
  glTranslatef(0.0f, 0.04f, 0.02f);
  glRotatef(90.0f, 1.0f, 0.0f, 0.0f);
  glCallList(m_unWheelList);
  glPopMatrix();
  if (m_cTimer.elapsed() > 1000) {
    m_cTimer.restart();
  }
}

void CQTOpenGLBeetle::SetBlackTireMaterial() {
  const GLfloat pfColor[] = {0.0f, 0.0f, 0.0f, 1.0f};
  const GLfloat pfSpecular[] = {0.0f, 0.0f, 0.0f, 1.0f};
  const GLfloat pfShininess[] = {0.0f};
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, pfColor);
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, pfSpecular);
  glMaterialfv(GL_FRONT_AND_BACK, GL_SHININESS, pfShininess);
}

void CQTOpenGLBeetle::RenderWheel() {
  SetBlackTireMaterial();
  CVector2 cVertex(0.02, 0.0f);
  CRadians cAngle(CRadians::TWO_PI / m_unVertices);
  glBegin(GL_QUAD_STRIP);
  for (GLuint i = 0; i <= m_unVertices; i++) {
    glNormal3d(cVertex.GetX(), cVertex.GetY(), 0.0f);
    glVertex3d(cVertex.GetX(), cVertex.GetY(), 0.005f);
    glVertex3d(cVertex.GetX(), cVertex.GetY(), 0.0f);
    cVertex.Rotate(cAngle);
  }
  glEnd();
}

void CQTOpenGLBeetle::RenderBody() {
  glEnable(GL_NORMALIZE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.0f, 1.0f);
  glBegin(GL_POLYGON);
  glNormal3f(0.0f, 0.0f, 1.0f);
  glTexCoord2f(0.0f, 0.0f);
  glVertex3f(0.06f, 0.0f, 0.05f);
  glVertex3f(-0.06f, 0.06f, 0.05f);
  glVertex3f(-0.06f, -0.06f, 0.05f);
  glEnd();
  glDisable(GL_POLYGON_OFFSET_FILL);
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
