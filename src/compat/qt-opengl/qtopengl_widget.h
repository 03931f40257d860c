#ifndef ARGOS3_COMPAT_QT_OPENGL_QTOPENGL_WIDGET_H
#define ARGOS3_COMPAT_QT_OPENGL_QTOPENGL_WIDGET_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/gl_calls.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qt_types.h>

namespace argos {

class CQTOpenGLUserFunctions;
class CQTOpenGLWidget;

/**
 * The part of a window that shows the arena, for user functions: it knows which entity is selected.
 * There is no window, so keys move no camera.
 */
class CQTOpenGLWidget {
 public:
  /** @param userFunctions  its hooks are told when the selection changes. */
  explicit CQTOpenGLWidget(CQTOpenGLUserFunctions& userFunctions)
      : m_userFunctions(userFunctions) {}

  void KeyPressed(QKeyEvent*) {}
  void KeyReleased(QKeyEvent*) {}

  /** Null if none is selected. */
  CEntity* GetSelectedEntity() { return m_selected; }
  /** Calls EntityDeselected() for the entity selected before, if any, and EntitySelected(). */
  void SelectEntity(CEntity& entity);
  /** Calls EntityDeselected() if an entity is selected. */
  void DeselectEntity();

 private:
  CQTOpenGLUserFunctions& m_userFunctions;
  CEntity* m_selected = nullptr;
};

/** Kinds of operations that draw an entity with OpenGL calls; registered, but not called. */
class CQTOpenGLOperationDrawNormal
    : public CEntityOperation<CQTOpenGLOperationDrawNormal, CQTOpenGLWidget, void> {};
class CQTOpenGLOperationDrawSelected
    : public CEntityOperation<CQTOpenGLOperationDrawSelected, CQTOpenGLWidget, void> {};

}  // namespace argos

#define REGISTER_QTOPENGL_ENTITY_OPERATION(ACTION, OPERATION, ENTITY) \
  REGISTER_ENTITY_OPERATION(ACTION, CQTOpenGLWidget, OPERATION, void, ENTITY)

#endif
