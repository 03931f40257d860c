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
#include <vector>

namespace argos {

/**
 * A solid of a Wavefront file (.obj) with its materials (.mtl), for users' drawing code, m.
 *
 * Reads v, vn, f (polygons are convex), usemtl and mtllib; of materials Ka, Kd, Ks, d and Tr. Other
 * statements, textures among them, are ignored. At most 64 MiB and 200,000 triangles.
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

  /**
   * @param file  in include/argos3/plugins/simulator/visualizations/qt-opengl/models/ of the
   * installation, else in the working directory, or an absolute path.
   * @throws CARGoSException if it or its materials cannot be read, or it has no normals (vn).
   */
  CQTOpenGLObjModel(const std::string& file);
  /** Two texts in the formats of .mtl and .obj files. @throws CARGoSException */
  CQTOpenGLObjModel(const std::string& materials, const std::string& solid);

  /** May be changed, also between pictures. @throws CARGoSException if there is none. */
  SMaterial& GetMaterial(const std::string& name);
  /** Draws all triangles in the current frame, or adds them to a display list that is made. */
  void Draw() const;

 private:
  class CReader;

  struct STriangle {
    std::array<UInt32, 3> Vertices;
    CVector3 Normal;  // unit length, outwards
  };
  // the triangles of a material
  struct SPart {
    std::string Material;
    std::vector<STriangle> Triangles;
  };

  const SMaterial& FindMaterial(const std::string& name) const;

  std::map<std::string, SMaterial> m_materials;
  std::vector<CVector3> m_vertices;
  std::vector<SPart> m_parts;
};

/** A folder of the installation with files for drawing, such as "models", with a final slash. */
std::string GetQtOpenGLFolder(const std::string& name);

}  // namespace argos

#endif
