#ifndef ARGOS3_COMPAT_QT_OPENGL_QTOPENGL_USER_FUNCTIONS_H
#define ARGOS3_COMPAT_QT_OPENGL_QTOPENGL_USER_FUNCTIONS_H

#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/visualization/drawing_functions.h>
#include <argos3/core/utility/math/ray3.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/gl_calls.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qt_types.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_main_window.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_widget.h>

#include <string>
#include <vector>

namespace argos {

/**
 * Base class of drawing functions written for ARGoS 3; they draw into the pictures of every view.
 *
 * CDrawingFunctions says when hooks are called and in which frame they draw: in a function that is
 * registered for a class of entities it is the entity's, elsewhere the world's. m and rad, unless
 * said otherwise. Functions that draw throw outside of hooks that draw.
 */
class CQTOpenGLUserFunctions : public CDrawingFunctions {
 public:
  CQTOpenGLUserFunctions();

  /**
   * Input: called by views with a keyboard or a mouse. As in ARGoS 3, a key that is passed on to
   * the widget, as these do, is left to the view; one that is not passed on was used here.
   */
  virtual void KeyPressed(QKeyEvent* event);
  virtual void KeyReleased(QKeyEvent* event);
  virtual void MouseKeyPressed(QMouseEvent*) {}
  virtual void MouseKeyReleased(QMouseEvent*) {}
  virtual void MouseMoved(QMouseEvent*) {}

  /** Selection: called by views in which a user selects and moves root entities. */
  virtual void EntitySelected(CEntity&) {}
  virtual void EntityDeselected(CEntity&) {}
  virtual void EntityMoved(CEntity&, const CVector3& /*oldPos*/, const CVector3& /*newPos*/) {}
  virtual void EntityRotated(CEntity&, const CQuaternion& /*oldOrientation*/,
                             const CQuaternion& /*newOrientation*/) {}

  /** Null if none is selected. */
  CEntity* GetSelectedEntity();
  /** Selects an entity, after deselecting another one; calls the hooks. */
  virtual void SelectEntity(CEntity& entity);
  virtual void DeselectEntity();

  /** In the world frame, if the arena has a floor. */
  virtual void Draw(CFloorEntity&) {}
  void HandleSelection(CEntity* root) override;
  void ForgetSelection() override;
  void HandleMove(CEntity& root, const SBodyPose& before, const SBodyPose& now) override;
  bool HandleKey(const SViewKey& key) override;

  /** Draws over the picture, in pixels from its upper left corner. */
  virtual void DrawOverlay(QPainter&) {}
  void DrawInOverlay() override;

  CQTOpenGLMainWindow& GetMainWindow() { return *m_mainWindow; }
  void SetMainWindow(CQTOpenGLMainWindow& window) { m_mainWindow = &window; }
  CQTOpenGLWidget& GetQTOpenGLWidget() { return m_mainWindow->GetOpenGLWidget(); }

  /** The colour of OpenGL calls. */
  void SetColor(const CColor& color);
  /** @param diameter pixels. */
  void DrawPoint(const CVector3& position, const CColor& color = CColor::RED, Real diameter = 5.0);
  /** Isosceles, in the x-y plane of its frame, tip towards +x; @p position bisects its height. */
  void DrawTriangle(const CVector3& position, const CQuaternion& orientation, Real base,
                    Real height, const CColor& color = CColor::RED, const bool fill = true);
  /** Convex or not, in the x-y plane of its frame. */
  void DrawPolygon(const CVector3& position, const CQuaternion& orientation,
                   const std::vector<CVector2>& corners, const CColor& color = CColor::RED,
                   const bool fill = true);
  /** @param vertices  less than 20 give that regular polygon, others a round circle. */
  void DrawCircle(const CVector3& position, const CQuaternion& orientation, Real radius,
                  const CColor& color = CColor::RED, const bool fill = true, GLuint vertices = 20);
  /** Round and closed, whatever @p vertices; @p position is its centre. */
  void DrawCylinder(const CVector3& position, const CQuaternion& orientation, Real radius,
                    Real height, const CColor& color = CColor::RED, GLuint vertices = 20);
  /** @p position is its centre. */
  void DrawBox(const CVector3& position, const CQuaternion& orientation, const CVector3& size,
               const CColor& color = CColor::RED);
  /** @param width pixels. */
  void DrawRay(const CRay3& ray, const CColor& color = CColor::RED, Real width = 1.0f);
  /** Faces the viewer; its base line begins at @p position. */
  void DrawText(const CVector3& position, const std::string& text,
                const CColor& color = CColor::BLACK, const QFont& font = QFont());

 private:
  CQTOpenGLMainWindow m_ownMainWindow;
  CQTOpenGLMainWindow* m_mainWindow;
};

}  // namespace argos

#define REGISTER_QTOPENGL_USER_FUNCTIONS(CLASSNAME, LABEL) \
  REGISTER_DRAWING_FUNCTIONS(CLASSNAME, LABEL)

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#endif

#endif
