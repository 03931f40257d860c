#include "manual_control_user_functions.h"

#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>

#include "../../controllers/footbot_manual_control/footbot_manual_control.h"

using namespace argos;

namespace {

constexpr Real kSpeed = 15.0;  // cm/s
constexpr Real kTurn = 4.0;  // cm/s, of a wheel

}  // namespace

CManualControlUserFunctions::EDirection CManualControlUserFunctions::FindDirection(int key) {
  switch (key) {
    case Qt::Key_W:
    case Qt::Key_Up:
      return kForwards;
    case Qt::Key_S:
    case Qt::Key_Down:
      return kBackwards;
    case Qt::Key_A:
    case Qt::Key_Left:
      return kLeft;
    case Qt::Key_D:
    case Qt::Key_Right:
      return kRight;
    default:
      return kNumDirections;
  }
}

bool CManualControlUserFunctions::SetKey(const QKeyEvent& event, bool isDown) {
  const EDirection direction = FindDirection(event.key());
  if (direction == kNumDirections && event.key() != Qt::Key_Shift) {
    return false;
  }
  if (direction != kNumDirections) {
    m_isDown[direction] = isDown;
  }
  // also of the key Shift itself: the modifiers that are down after the event
  m_isFast = (event.modifiers() & Qt::ShiftModifier) != 0;
  Drive();
  return true;
}

void CManualControlUserFunctions::KeyPressed(QKeyEvent* event) {
  if (!SetKey(*event, true)) {
    // what is not used here is the view's, such as Space
    GetQTOpenGLWidget().KeyPressed(event);
  }
}

void CManualControlUserFunctions::KeyReleased(QKeyEvent* event) {
  if (!SetKey(*event, false)) {
    GetQTOpenGLWidget().KeyReleased(event);
  }
}

CFootBotManualControl* CManualControlUserFunctions::FindController(CEntity* entity) {
  auto* const robot = dynamic_cast<CFootBotEntity*>(entity);
  return robot == nullptr ? nullptr
                          : dynamic_cast<CFootBotManualControl*>(
                                &robot->GetControllableEntity().GetController());
}

void CManualControlUserFunctions::Drive() {
  if (CFootBotManualControl* const controller = FindController(GetSelectedEntity())) {
    const Real speed = m_isFast ? 2.0 * kSpeed : kSpeed;
    const Real ahead = speed * (int{m_isDown[kForwards]} - int{m_isDown[kBackwards]});
    const Real turn = kTurn * (int{m_isDown[kLeft]} - int{m_isDown[kRight]});
    controller->SetSpeeds(ahead - turn, ahead + turn);
  }
}

void CManualControlUserFunctions::EntitySelected(CEntity& entity) {
  if (CFootBotManualControl* const controller = FindController(&entity)) {
    controller->SetSelected(true);
    Drive();
  }
}

void CManualControlUserFunctions::EntityDeselected(CEntity& entity) {
  if (CFootBotManualControl* const controller = FindController(&entity)) {
    controller->SetSelected(false);
  }
}

void CManualControlUserFunctions::EntityMoved(CEntity& entity, const CVector3& oldPos,
                                              const CVector3& newPos) {
  LOG << entity.GetId() << " was moved by " << Distance(oldPos, newPos) << " m" << std::endl;
}

void CManualControlUserFunctions::DrawInWorld() {
  if (auto* const robot = dynamic_cast<CFootBotEntity*>(GetSelectedEntity())) {
    CVector3 place = robot->GetEmbodiedEntity().GetOriginAnchor().Position;
    place.SetZ(0.01);
    DrawCircle(place, CQuaternion(), 0.15, CColor::YELLOW, false);
  }
}

REGISTER_QTOPENGL_USER_FUNCTIONS(CManualControlUserFunctions, "manual_control_user_functions")
