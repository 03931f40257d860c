#include "user_drawing.h"

CUserDrawing::CUserDrawing() : m_punKeys() {
  CSimulator::GetInstance().GetLoopFunctions();
  RegisterUserFunction<CUserDrawing, CFootBotEntity>(&CUserDrawing::Draw);
}

void CUserDrawing::Init(TConfigurationNode& t_tree) {
  std::string strTitle;
  GetNodeAttributeOrDefault(t_tree, "title", strTitle, strTitle);
  m_vecEvents.push_back("init " + strTitle);
}

void CUserDrawing::Reset() {
  m_vecEvents.push_back("reset");
}

void CUserDrawing::Destroy() {}

void CUserDrawing::KeyPressed(QKeyEvent* pc_event) {
  switch (pc_event->key()) {
    case Qt::Key_W:
      m_punKeys[0] = 1;
      break;
    case Qt::Key_Up:
      m_punKeys[1] = 1;
      break;
    default:
      GetQTOpenGLWidget().KeyPressed(pc_event);
      break;
  }
}

void CUserDrawing::KeyReleased(QKeyEvent* pc_event) {
  if (pc_event->key() == Qt::Key_W && pc_event->text().toStdString() == "w") {
    m_punKeys[0] = 0;
  } else {
    CQTOpenGLUserFunctions::KeyReleased(pc_event);
  }
}

void CUserDrawing::MouseKeyPressed(QMouseEvent* pc_event) {
  if (pc_event->button() == Qt::LeftButton) {
    m_vecEvents.push_back("left");
  }
}

void CUserDrawing::MouseKeyReleased(QMouseEvent* pc_event) {
  CQTOpenGLUserFunctions::MouseKeyReleased(pc_event);
}

void CUserDrawing::MouseMoved(QMouseEvent* pc_event) {
  m_vecEvents.push_back("mouse at " + std::to_string(pc_event->x() + pc_event->y()));
}

void CUserDrawing::EntitySelected(CEntity& c_entity) {
  CFootBotEntity* pcFootBot = dynamic_cast<CFootBotEntity*>(&c_entity);
  m_vecEvents.push_back("selected " + c_entity.GetId() + (pcFootBot != NULL ? "" : " (other)"));
}

void CUserDrawing::EntityDeselected(CEntity& c_entity) {
  m_vecEvents.push_back("deselected " + c_entity.GetId());
}

void CUserDrawing::EntityMoved(CEntity& c_entity, const CVector3& c_old_pos,
                               const CVector3& c_new_pos) {
  CQTOpenGLUserFunctions::EntityMoved(c_entity, c_old_pos, c_new_pos);
}

void CUserDrawing::EntityRotated(CEntity& c_entity, const CQuaternion& c_old_orientation,
                                 const CQuaternion& c_new_orientation) {
  CQTOpenGLUserFunctions::EntityRotated(c_entity, c_old_orientation, c_new_orientation);
}

void CUserDrawing::SelectEntity(CEntity& c_entity) {
  CQTOpenGLUserFunctions::SelectEntity(c_entity);
}

void CUserDrawing::DeselectEntity() {
  CQTOpenGLUserFunctions::DeselectEntity();
}

void CUserDrawing::Call(CEntity& c_entity) {
  CQTOpenGLUserFunctions::Call(c_entity);
}

void CUserDrawing::Draw(CFloorEntity& c_entity) {
  DrawPoint(CVector3(0.0f, 0.0f, 0.0f));
  m_vecEvents.push_back("floor " + c_entity.GetId());
}

void CUserDrawing::Draw(CFootBotEntity& c_entity) {
  glDisable(GL_LIGHTING);
  ::glEnable(GL_CULL_FACE);
  glColor3f(1.0f, 0.0, 0);
  DrawText(CVector3(0.0, 0.0, 0.3), c_entity.GetId());
  DrawText(CVector3(0.0, 0.0, 0.4), c_entity.GetId().c_str(), CColor::RED,
           QFont("Helvetica", 18, QFont::Bold));
  glEnable(GL_LIGHTING);
}

void CUserDrawing::DrawInWorld() {
  const CVector3 cPos(1.0, 0.0, 0.1);
  const CQuaternion cRot;
  std::vector<CVector2> vecPoints;
  vecPoints.push_back(CVector2(0.0, 0.0));
  vecPoints.push_back(CVector2(1.0, 0.0));
  vecPoints.push_back(CVector2(1.0, 1.0));
  SetColor(CColor::BLUE);
  DrawPoint(cPos, CColor::GREEN, 8.0);
  DrawTriangle(cPos, cRot, 0.2, 0.1);
  DrawTriangle(cPos, cRot, 0.2, 0.1, CColor::BLUE, false);
  DrawPolygon(cPos, cRot, vecPoints);
  DrawPolygon(cPos, cRot, vecPoints, CColor::BLUE, false);
  DrawCircle(cPos, cRot, 0.3);
  DrawCircle(cPos, cRot, 0.3, CColor::BLUE, false, 5);
  DrawCylinder(cPos, cRot, 0.1, 0.3);
  DrawCylinder(cPos, cRot, 0.1, 0.3, CColor::BLUE, 40);
  DrawBox(cPos, cRot, CVector3(0.1, 0.2, 0.3));
  DrawBox(cPos, cRot, CVector3(0.1, 0.2, 0.3), CColor::BLUE);
  DrawRay(CRay3(CVector3(), cPos));
  DrawRay(CRay3(CVector3(), cPos), CColor::BLUE, 3.0f);
}

void CUserDrawing::DrawOverlay(QPainter& c_painter) {
  c_painter.setPen(QColor(10, 20, 30));
  c_painter.setFont(QFont("Monospace", 9));
  c_painter.drawText(5, c_painter.viewport().height() - 5, "hello");
}

REGISTER_QTOPENGL_USER_FUNCTIONS(CUserDrawing, "user_drawing")

// drawing code for OpenGL of a user's robot: registered, but not called
class CUserRobotDrawing : public CQTOpenGLOperationDrawNormal {
 public:
  void ApplyTo(CQTOpenGLWidget&, CFootBotEntity&) {
    glPushMatrix();
    glBegin(GL_QUADS);
    glVertex3f(0.0f, 0.0f, 0.0f);
    glEnd();
    glPopMatrix();
  }
};

REGISTER_QTOPENGL_ENTITY_OPERATION(CQTOpenGLOperationDrawNormal, CUserRobotDrawing, CFootBotEntity);
