#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_obj_model.h>

#include <argos3/plugins/simulator/visualizations/qt-opengl/qt_widgets.h>

namespace argos {

CQTOpenGLObjModel::CQTOpenGLObjModel(const std::string& /*file*/) {
  WarnOfQtName("CQTOpenGLObjModel");
}

CQTOpenGLObjModel::CQTOpenGLObjModel(const std::string& /*materials*/,
                                     const std::string& /*solid*/) {
  WarnOfQtName("CQTOpenGLObjModel");
}

}  // namespace argos
