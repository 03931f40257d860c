#ifndef MANUAL_CONTROL_USER_FUNCTIONS_H
#define MANUAL_CONTROL_USER_FUNCTIONS_H

#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_user_functions.h>

#include <array>

class CFootBotManualControl;

/**
 * Drives the selected foot-bot by the arrow keys, or by W, A, S and D, in an interactive view, with
 * Shift at twice the speed. All other keys are left to the view.
 */
class CManualControlUserFunctions : public argos::CQTOpenGLUserFunctions {
 public:
  void KeyPressed(QKeyEvent* event) override;
  void KeyReleased(QKeyEvent* event) override;
  void EntitySelected(argos::CEntity& entity) override;
  void EntityDeselected(argos::CEntity& entity) override;
  void EntityMoved(argos::CEntity& entity, const argos::CVector3& oldPos,
                   const argos::CVector3& newPos) override;
  void DrawInWorld() override;

 private:
  enum EDirection { kForwards, kBackwards, kLeft, kRight, kNumDirections };

  static EDirection FindDirection(int key);
  /** @return false if the key means nothing here. */
  bool SetKey(const QKeyEvent& event, bool isDown);
  /** Null if the entity is no foot-bot with that controller. */
  static CFootBotManualControl* FindController(argos::CEntity* entity);
  void Drive();

  std::array<bool, kNumDirections> m_isDown{};  // by direction
  bool m_isFast = false;
};

#endif
