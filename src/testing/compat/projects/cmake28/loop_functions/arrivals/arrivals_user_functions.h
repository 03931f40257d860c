#ifndef ARRIVALS_USER_FUNCTIONS_H
#define ARRIVALS_USER_FUNCTIONS_H

#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_user_functions.h>

using namespace argos;

/* Writes the id of each robot above it. */
class CArrivalsUserFunctions : public CQTOpenGLUserFunctions {
 public:
  CArrivalsUserFunctions();
  virtual ~CArrivalsUserFunctions() {}
  void Draw(CFootBotEntity& c_entity);
};

#endif
