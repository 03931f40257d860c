/* Calls the operations that draw entities of third-party classes, for views. */

#include <argos3/core/simulator/visualization/drawing.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/string_utilities.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_user_functions.h>
#include <argos3/plugins/simulator/visualizations/scene/scene_builder.h>

#include <exception>
#include <set>
#include <string>

namespace argos {

namespace {

// Draws one entity in the hook in which functions may draw.
class COperationDrawing : public CQTOpenGLUserFunctions {
 public:
  COperationDrawing() { GetQTOpenGLWidget().SetDrawRays(false); }

  /** @return false if the operation has drawn nothing. */
  bool DrawEntity(CEntity& entity, CDrawing& drawing) {
    m_entity = &entity;
    const std::size_t count = drawing.GetShapes().size();
    DrawAll(drawing, {});
    return drawing.GetShapes().size() > count;
  }

  void DrawInWorld() override {
    CallEntityOperation<CQTOpenGLOperationDrawNormal, CQTOpenGLWidget, void>(GetQTOpenGLWidget(),
                                                                             *m_entity);
  }
  void DrawInOverlay() override {}

 private:
  CEntity* m_entity = nullptr;
};

// an error is reported once for each type of entities, whose solids are shown then
bool DrawByOperation(CEntity& entity, CDrawing& drawing) {
  static thread_local std::set<std::string> failed;
  const std::string type = entity.GetTypeDescription();
  if (failed.contains(type)) {
    return false;
  }
  try {
    static thread_local COperationDrawing operation;
    return operation.DrawEntity(entity, drawing);
  } catch (std::exception& error) {
    failed.insert(type);
    std::string reason = error.what();
    Replace(reason, "[FATAL] ", "");
    LOGERR << "[WARNING] the drawing of <" << type << "> has failed: " << reason << std::endl;
    return false;
  }
}

const bool kIsSet = [] {
  CSceneBuilder::SetDrawEntity(&DrawByOperation);
  return true;
}();

}  // namespace

}  // namespace argos
