#ifndef TRAJECTORY_USER_FUNCTIONS_H
#define TRAJECTORY_USER_FUNCTIONS_H

#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_user_functions.h>

class CTrajectoryLoopFunctions;

/** Draws ids and headings of foot-bots, and where they came from. */
class CTrajectoryUserFunctions : public argos::CQTOpenGLUserFunctions {
 public:
  CTrajectoryUserFunctions();

  using CQTOpenGLUserFunctions::Draw;
  void Draw(argos::CFootBotEntity& robot);
  void DrawInWorld() override;
  void DrawOverlay(QPainter& painter) override;

 private:
  CTrajectoryLoopFunctions& m_loopFunctions;
};

#endif
