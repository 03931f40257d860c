// Drawing functions as users write them: all signatures of the API.
#ifndef USER_DRAWING_H
#define USER_DRAWING_H

#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_main_window.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_user_functions.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_widget.h>

#include <QFont>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <string>
#include <vector>

using namespace argos;

class CUserDrawing : public CQTOpenGLUserFunctions {
 public:
  CUserDrawing();
  virtual ~CUserDrawing() {}

  virtual void Init(TConfigurationNode& t_tree);
  virtual void Reset();
  virtual void Destroy();

  virtual void KeyPressed(QKeyEvent* pc_event);
  virtual void KeyReleased(QKeyEvent* pc_event);
  virtual void MouseKeyPressed(QMouseEvent* pc_event);
  virtual void MouseKeyReleased(QMouseEvent* pc_event);
  virtual void MouseMoved(QMouseEvent* pc_event);

  virtual void EntitySelected(CEntity& c_entity);
  virtual void EntityDeselected(CEntity& c_entity);
  virtual void EntityMoved(CEntity& c_entity, const CVector3& c_old_pos, const CVector3& c_new_pos);
  virtual void EntityRotated(CEntity& c_entity, const CQuaternion& c_old_orientation,
                             const CQuaternion& c_new_orientation);
  virtual void SelectEntity(CEntity& c_entity);
  virtual void DeselectEntity();

  virtual void Call(CEntity& c_entity);
  virtual void Draw(CFloorEntity& c_entity);
  void Draw(CFootBotEntity& c_entity);
  virtual void DrawInWorld();
  virtual void DrawOverlay(QPainter& c_painter);

  std::vector<std::string> m_vecEvents;
  UInt8 m_punKeys[4];
};

#endif
