#ifndef ARGOS3_COMPAT_QT_OPENGL_QTOPENGL_OBJ_MODEL_H
#define ARGOS3_COMPAT_QT_OPENGL_QTOPENGL_OBJ_MODEL_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/gl_calls.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qt_types.h>

#include <array>
#include <map>
#include <string>

namespace argos {

/**
 * A solid of a Wavefront file, for users' drawing code: it has the materials that the code changes,
 * but pictures do not show it (views have models of their own: doc/povray.md).
 */
class CQTOpenGLObjModel {
 public:
  struct SMaterial {
    typedef std::map<std::string, SMaterial>::iterator TMapIterator;

    std::array<GLfloat, 4> Ambient{{0.0f, 0.0f, 0.0f, 1.0f}};
    std::array<GLfloat, 4> Diffuse{{0.0f, 0.0f, 0.0f, 1.0f}};
    std::array<GLfloat, 4> Emission{{0.0f, 0.0f, 0.0f, 1.0f}};
    std::array<GLfloat, 4> Specular{{0.0f, 0.0f, 0.0f, 1.0f}};
    std::array<GLfloat, 1> Shininess{{0.0f}};
    GLfloat Alpha = 1.0f;
    bool EnableTransparency = false;
  };

  /** @param file  is not read. */
  CQTOpenGLObjModel(const std::string& file);
  /** Two texts in the formats of .mtl and .obj files; not read. */
  CQTOpenGLObjModel(const std::string& materials, const std::string& solid);

  /** @return the material of that name, which is created if there is none. */
  SMaterial& GetMaterial(const std::string& name) { return m_materials[name]; }
  /** Draws nothing. */
  void Draw() const {}

 private:
  std::map<std::string, SMaterial> m_materials;
};

}  // namespace argos

#endif
