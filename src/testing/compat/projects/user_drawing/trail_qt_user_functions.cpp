#include "trail_qt_user_functions.h"
#include "trail_loop_functions.h"

CTrailQTUserFunctions::CTrailQTUserFunctions()
    : m_cTrailLF(dynamic_cast<CTrailLoopFunctions&>(CSimulator::GetInstance().GetLoopFunctions())),
      m_pcSelected(NULL) {
  RegisterUserFunction<CTrailQTUserFunctions, CFootBotEntity>(&CTrailQTUserFunctions::Draw);
}

void CTrailQTUserFunctions::Init(TConfigurationNode& t_tree) {
  std::string strOutput;
  GetNodeAttribute(t_tree, "output", strOutput);
  m_cOutput.open(strOutput.c_str(), std::ios_base::trunc | std::ios_base::out);
}

void CTrailQTUserFunctions::Destroy() {
  m_cOutput.close();
}

void CTrailQTUserFunctions::KeyPressed(QKeyEvent* pc_event) {
  switch (pc_event->key()) {
    case Qt::Key_Space:
      DeselectEntity();
      break;
    default:
      GetQTOpenGLWidget().KeyPressed(pc_event);
      break;
  }
}

void CTrailQTUserFunctions::EntitySelected(CEntity& c_entity) {
  m_pcSelected = dynamic_cast<CFootBotEntity*>(&c_entity);
}

void CTrailQTUserFunctions::Draw(CFootBotEntity& c_entity) {
  m_cOutput << CSimulator::GetInstance().GetSpace().GetSimulationClock() << " " << c_entity.GetId()
            << std::endl;
  DrawText(CVector3(0.0, 0.0, 0.3), c_entity.GetId().c_str());
  DrawCylinder(CVector3(0.0, 0.0, 0.25), CQuaternion(), 0.05, 0.02, CColor::GREEN);
}

void CTrailQTUserFunctions::DrawInWorld() {
  glDisable(GL_LIGHTING);
  for (CTrailLoopFunctions::TWaypointMap::const_iterator it = m_cTrailLF.GetWaypoints().begin();
       it != m_cTrailLF.GetWaypoints().end(); ++it) {
    const std::vector<CVector3>& vecPoints = it->second;
    for (size_t i = 1; i < vecPoints.size(); ++i) {
      DrawRay(CRay3(vecPoints[i - 1], vecPoints[i]), CColor::BLUE, 2.0f);
    }
  }
  DrawCircle(CVector3(0.0, 0.0, 0.0), CQuaternion(), 0.5, CColor::RED);
  glEnable(GL_LIGHTING);
}

REGISTER_QTOPENGL_USER_FUNCTIONS(CTrailQTUserFunctions, "trail_qt_user_functions")
