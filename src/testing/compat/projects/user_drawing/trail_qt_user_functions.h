#ifndef TRAIL_QT_USER_FUNCTIONS_H
#define TRAIL_QT_USER_FUNCTIONS_H

#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_user_functions.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <fstream>

using namespace argos;

class CTrailLoopFunctions;

class CTrailQTUserFunctions : public CQTOpenGLUserFunctions {
 public:
  CTrailQTUserFunctions();
  virtual ~CTrailQTUserFunctions() {}

  virtual void Init(TConfigurationNode& t_tree);
  virtual void Destroy();
  virtual void KeyPressed(QKeyEvent* pc_event);
  virtual void EntitySelected(CEntity& c_entity);
  virtual void DrawInWorld();
  void Draw(CFootBotEntity& c_entity);

 private:
  CTrailLoopFunctions& m_cTrailLF;
  CFootBotEntity* m_pcSelected;
  std::ofstream m_cOutput;
};

#endif
