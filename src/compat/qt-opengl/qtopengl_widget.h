#ifndef ARGOS3_COMPAT_QT_OPENGL_QTOPENGL_WIDGET_H
#define ARGOS3_COMPAT_QT_OPENGL_QTOPENGL_WIDGET_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/ray3.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/gl_calls.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qt_types.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qt_widgets.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_camera.h>

namespace argos {

class CControllableEntity;
class CEmbodiedEntity;
class CPositionalEntity;
class CQTOpenGLMainWindow;
class CQTOpenGLUserFunctions;

/**
 * The part of a window that shows the arena, for user functions and drawing operations: it knows
 * which entity is selected. There is no window, so keys move no camera, and it controls no run.
 */
class CQTOpenGLWidget : public QOpenGLWidget, protected QOpenGLFunctions {
 public:
  /** Settings that are kept, without effect: the element <frame_grabbing> has an effect. */
  struct SFrameGrabData {
    bool GUIGrabbing = false;
    bool HeadlessGrabbing = false;
    UInt32 HeadlessFrameRate = 1;
    QString Directory = ".";
    QString BaseName = "frame_";
    QString Format = "png";
    SInt32 Quality = -1;
    QSize Size = QSize(1600, 1200);
  };

  struct SSelectionInfo {
    bool IsSelected = false;
    CEntity* Entity = nullptr;
  };

  /** @param userFunctions  its hooks are told when the selection changes. */
  explicit CQTOpenGLWidget(CQTOpenGLUserFunctions& userFunctions)
      : m_userFunctions(userFunctions) {}

  /** User functions pass on what they do not use: the event is ignored, so the view gets the key.
   */
  void KeyPressed(QKeyEvent* event) { event->ignore(); }
  void KeyReleased(QKeyEvent* event) { event->ignore(); }

  /** The frame of what is drawn next: that of the entity. Only in hooks that draw. */
  void DrawEntity(CPositionalEntity& entity);
  void DrawEntity(CEmbodiedEntity& body);
  /**
   * The rays that sensors have recorded: magenta if obstructed, else cyan. Only in such hooks.
   * Nothing in operations: pictures have the rays anyway.
   */
  void DrawRays(CControllableEntity& entity);
  /** The edges of the bounding box, white. Only in such hooks. */
  void DrawBoundingBox(CEmbodiedEntity& body);

  /** There is no window: these are a ray and a point at the origin. */
  CRay3 RayFromWindowCoord(int /*x*/, int /*y*/) { return {}; }
  CVector3 GetWindowCoordInWorld(int /*x*/, int /*y*/) { return {}; }
  void SelectInScene(UInt32 /*x*/, UInt32 /*y*/) {}

  CQTOpenGLUserFunctions& GetUserFunctions() { return m_userFunctions; }
  CQTOpenGLCamera& GetCamera() { return m_camera; }
  SFrameGrabData& GetFrameGrabData() { return m_frameGrabData; }
  void SetDrawRays(bool draw) { m_drawsRays = draw; }
  void SetInvertMouse(bool /*invert*/) {}
  void SetShowBoundary(bool /*show*/) {}
  void SetDrawFrameEvery(int /*every*/) {}
  void SetGrabFrame(bool grab) { m_frameGrabData.GUIGrabbing = grab; }
  void SetCamera(int /*camera*/) {}
  void SetCameraFocalLength(double /*length*/) {}

  /** Views run the experiment: without effect, but for a warning. */
  void PlayExperiment() { WarnOfQtName("CQTOpenGLWidget::PlayExperiment"); }
  void FastForwardExperiment() { WarnOfQtName("CQTOpenGLWidget::FastForwardExperiment"); }
  void PauseExperiment() { WarnOfQtName("CQTOpenGLWidget::PauseExperiment"); }
  void StepExperiment() { WarnOfQtName("CQTOpenGLWidget::StepExperiment"); }
  void ResetExperiment() { WarnOfQtName("CQTOpenGLWidget::ResetExperiment"); }

  /** Signals, which nothing emits. */
  void StepDone(int /*tick*/) {}
  void ExperimentDone() {}
  void EntitySelected(CEntity* /*entity*/) {}
  void EntityDeselected(CEntity* /*entity*/) {}

  /** Null if none is selected. */
  CEntity* GetSelectedEntity() { return m_selected; }
  /** Calls EntityDeselected() for the entity selected before, if any, and EntitySelected(). */
  void SelectEntity(CEntity& entity);
  /** The selected entity does not exist any more: calls nothing. */
  void ForgetSelection() { m_selected = nullptr; }
  /** Calls EntityDeselected() if an entity is selected. */
  void DeselectEntity();

 private:
  CQTOpenGLUserFunctions& m_userFunctions;
  CEntity* m_selected = nullptr;
  CQTOpenGLCamera m_camera;
  SFrameGrabData m_frameGrabData;
  bool m_drawsRays = true;
};

/**
 * Kinds of operations that draw an entity. The normal one is called for entities without an
 * appearance; if it draws nothing, or fails, views show the solids.
 */
class CQTOpenGLOperationDrawNormal
    : public CEntityOperation<CQTOpenGLOperationDrawNormal, CQTOpenGLWidget, void> {};
class CQTOpenGLOperationDrawSelected
    : public CEntityOperation<CQTOpenGLOperationDrawSelected, CQTOpenGLWidget, void> {};

}  // namespace argos

#define REGISTER_QTOPENGL_ENTITY_OPERATION(ACTION, OPERATION, ENTITY) \
  REGISTER_ENTITY_OPERATION(ACTION, CQTOpenGLWidget, OPERATION, void, ENTITY)

#endif
