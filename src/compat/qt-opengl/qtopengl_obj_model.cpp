#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_obj_model.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/lists.h>

#include <dlfcn.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>

namespace argos {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxBytes = std::size_t{64} << 20U;
constexpr std::size_t kMaxTriangles = 200000;

std::string ReadFile(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!fs::is_regular_file(path) || !file) {
    THROW_ARGOSEXCEPTION("\"" << path.string() << "\" cannot be read");
  }
  if (fs::file_size(path) > kMaxBytes) {
    THROW_ARGOSEXCEPTION("\"" << path.string() << "\" is too large for a model: it has more than "
                              << kMaxBytes << " bytes");
  }
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

fs::path FindModel(const std::string& name) {
  const fs::path installed = fs::path(GetQtOpenGLFolder("models")) / name;
  for (const fs::path& path : {installed, fs::path(name)}) {
    if (fs::is_regular_file(path)) {
      return path;
    }
  }
  THROW_ARGOSEXCEPTION("There is no model \"" << name << "\": neither \"" << installed.string()
                                              << "\", nor in the working directory");
}

}  // namespace

std::string GetQtOpenGLFolder(const std::string& name) {
  Dl_info info;
  fs::path prefix;
  // <prefix>/lib/argos3/libargos3plugin_simulator_qtopengl.so
  if (dladdr(reinterpret_cast<const void*>(&GetQtOpenGLFolder), &info) != 0) {
    prefix = fs::path(info.dli_fname).parent_path().parent_path().parent_path();
  }
  return (prefix / "include/argos3/plugins/simulator/visualizations/qt-opengl" / name / "")
      .string();
}

// Reads the lines of a text to a model.
class CQTOpenGLObjModel::CReader {
 public:
  /** @param name  of the text, for errors. */
  CReader(CQTOpenGLObjModel& model, std::string name, fs::path folder)
      : m_model(model), m_name(std::move(name)), m_folder(std::move(folder)) {}

  void ReadSolid(const std::string& text) {
    ForEachLine(text, [this](std::string_view word) { ReadSolidLine(word); });
    if (m_normals.empty()) {
      THROW_ARGOSEXCEPTION(m_name << ": the model has no normals (vn)");
    }
  }

  void ReadMaterials(const std::string& text) {
    ForEachLine(text, [this](std::string_view word) { ReadMaterialLine(word); });
  }

 private:
  template <typename FUNCTION>
  void ForEachLine(std::string_view text, const FUNCTION& read) {
    for (m_line = 1; !text.empty(); ++m_line) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      m_rest = text.substr(0, std::min(end, text.find('#')));
      text.remove_prefix(std::min(end + 1, text.size()));
      const std::string_view word = NextWord();
      if (!word.empty()) {
        read(word);
      }
    }
  }

  void ReadSolidLine(std::string_view word) {
    if (word == "v") {
      m_model.m_vertices.push_back(ReadVector());
    } else if (word == "vn") {
      m_normals.push_back(ReadVector());
    } else if (word == "f") {
      ReadFace();
    } else if (word == "usemtl") {
      m_material = ReadName();
      m_part = nullptr;
    } else if (word == "mtllib" && !m_folder.empty()) {
      const fs::path path = m_folder / ReadName();
      CReader(m_model, path.string(), {}).ReadMaterials(ReadFile(path));
    }
  }

  void ReadMaterialLine(std::string_view word) {
    if (word == "newmtl") {
      const auto [place, isNew] = m_model.m_materials.try_emplace(ReadName());
      if (!isNew) {
        Fail("the material \"", place->first, "\" is defined twice");
      }
      m_newMaterial = &place->second;
    } else if (m_newMaterial == nullptr) {
      return;
    } else if (word == "Ka") {
      ReadColor(m_newMaterial->Ambient);
    } else if (word == "Kd") {
      ReadColor(m_newMaterial->Diffuse);
    } else if (word == "Ks") {
      ReadColor(m_newMaterial->Specular);
    } else if (word == "d") {
      SetOpacity(ReadReal(NextWord()));
    } else if (word == "Tr") {
      SetOpacity(1.0 - ReadReal(NextWord()));
    }
  }

  void SetOpacity(Real opacity) {
    const auto value = static_cast<GLfloat>(std::clamp(opacity, 0.0, 1.0));
    for (auto* color :
         {&m_newMaterial->Ambient, &m_newMaterial->Diffuse, &m_newMaterial->Specular}) {
      (*color)[3] = value;
    }
    m_newMaterial->Alpha = value;
    m_newMaterial->EnableTransparency = value < 1.0f;
  }

  void ReadColor(std::array<GLfloat, 4>& color) {
    const CVector3 read = ReadVector();
    color[0] = static_cast<GLfloat>(read.GetX());
    color[1] = static_cast<GLfloat>(read.GetY());
    color[2] = static_cast<GLfloat>(read.GetZ());
  }

  void ReadFace() {
    std::array<UInt32, 3> fan{};
    CVector3 normals;
    std::size_t count = 0;
    for (std::string_view word = NextWord(); !word.empty(); word = NextWord(), ++count) {
      const UInt32 vertex = ReadCorner(word, normals);
      fan[std::min<std::size_t>(count, 2)] = vertex;
      if (count >= 2) {
        AddTriangle(fan, normals);
        fan[1] = fan[2];
      }
    }
    if (count < 3) {
      Fail("a face needs three corners");
    }
  }

  // v, v/vt, v//vn or v/vt/vn. normals: the sum of those of the face
  UInt32 ReadCorner(std::string_view word, CVector3& normals) {
    const std::size_t first = word.find('/');
    const UInt32 vertex = ReadIndex(word.substr(0, first), m_model.m_vertices.size(), "vertex");
    const std::size_t second = first == word.npos ? word.npos : word.find('/', first + 1);
    if (second != word.npos) {
      normals += m_normals[ReadIndex(word.substr(second + 1), m_normals.size(), "normal")];
    }
    return vertex;
  }

  // 1 is the first one, -1 the last one
  UInt32 ReadIndex(std::string_view word, std::size_t size, const char* what) {
    SInt64 index = 0;
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), index);
    index += index < 0 ? static_cast<SInt64>(size) + 1 : 0;
    if (failure != std::errc() || end != word.data() + word.size() || index < 1 ||
        index > static_cast<SInt64>(size)) {
      Fail("\"", word, "\" is not a ", what, " from 1 to ", size);
    }
    return static_cast<UInt32>(index - 1);
  }

  void AddTriangle(const std::array<UInt32, 3>& corners, const CVector3& outwards) {
    if (++m_numTriangles > kMaxTriangles) {
      Fail("the model has more than ", kMaxTriangles, " triangles");
    }
    const std::vector<CVector3>& vertices = m_model.m_vertices;
    CVector3 normal = vertices[corners[1]] - vertices[corners[0]];
    normal.CrossProduct(vertices[corners[2]] - vertices[corners[0]]);
    if (!(normal.SquareLength() > 0.0)) {
      return;
    }
    normal.Normalize();
    if (m_part == nullptr) {
      m_part = &m_model.m_parts.emplace_back();
      m_part->Material = m_material;
    }
    m_part->Triangles.push_back({corners, normal.DotProduct(outwards) < 0.0 ? -normal : normal});
  }

  std::string_view NextWord() {
    constexpr const char* kBlanks = " \t\r";
    m_rest.remove_prefix(std::min(m_rest.find_first_not_of(kBlanks), m_rest.size()));
    const std::string_view word = m_rest.substr(0, m_rest.find_first_of(kBlanks));
    m_rest.remove_prefix(word.size());
    return word;
  }

  // the rest of the line, which may contain blanks
  std::string ReadName() {
    const std::string_view first = NextWord();
    const std::size_t end = m_rest.find_last_not_of(" \t\r");
    std::string name(first);
    return name.append(m_rest.substr(0, end == m_rest.npos ? 0 : end + 1));
  }

  CVector3 ReadVector() {
    const Real x = ReadReal(NextWord());
    const Real y = ReadReal(NextWord());
    return CVector3(x, y, ReadReal(NextWord()));
  }

  Real ReadReal(std::string_view word) {
    Real value = 0.0;
    const char* const begin = word.data() + (word.substr(0, 1) == "+" ? 1 : 0);
    const auto [end, failure] = std::from_chars(begin, word.data() + word.size(), value);
    if (failure != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) {
      Fail("\"", word, "\" is not a number");
    }
    return value;
  }

  template <typename... PARTS>
  [[noreturn]] void Fail(const PARTS&... parts) const {
    std::ostringstream reason;
    (reason << ... << parts);
    THROW_ARGOSEXCEPTION(m_name << ":" << m_line << ": " << reason.str());
  }

  CQTOpenGLObjModel& m_model;
  std::string m_name;
  fs::path m_folder;  // of the files that the text names; empty: none are read
  std::size_t m_line = 0;
  std::string_view m_rest;  // of the line
  std::vector<CVector3> m_normals;
  std::string m_material;
  SPart* m_part = nullptr;  // null before the first triangle of a material
  SMaterial* m_newMaterial = nullptr;
  std::size_t m_numTriangles = 0;
};

CQTOpenGLObjModel::CQTOpenGLObjModel(const std::string& file) {
  const fs::path path = FindModel(file);
  CReader(*this, path.string(), fs::absolute(path).parent_path()).ReadSolid(ReadFile(path));
}

CQTOpenGLObjModel::CQTOpenGLObjModel(const std::string& materials, const std::string& solid) {
  CReader(*this, "(text of materials)", {}).ReadMaterials(materials);
  CReader(*this, "(text of a model)", {}).ReadSolid(solid);
}

CQTOpenGLObjModel::SMaterial& CQTOpenGLObjModel::GetMaterial(const std::string& name) {
  const auto found = m_materials.find(name);
  if (found == m_materials.end()) {
    std::string names;
    for (const auto& [known, material] : m_materials) {
      AppendItem(names, known);
    }
    THROW_ARGOSEXCEPTION("The model has no material \"" << name << "\"; it has: " << names);
  }
  return found->second;
}

const CQTOpenGLObjModel::SMaterial& CQTOpenGLObjModel::FindMaterial(const std::string& name) const {
  static const SMaterial kGray{.Diffuse = {{0.6f, 0.6f, 0.6f, 1.0f}}};
  const auto found = m_materials.find(name);
  return found == m_materials.end() ? kGray : found->second;
}

// By OpenGL calls, as users may put a model into a display list.
void CQTOpenGLObjModel::Draw() const {
  glPushAttrib(GL_ENABLE_BIT | GL_LIGHTING_BIT);
  for (const SPart& part : m_parts) {
    const SMaterial& material = FindMaterial(part.Material);
    std::array<GLfloat, 4> diffuse = material.Diffuse;
    if (material.EnableTransparency) {
      diffuse[3] = std::min(diffuse[3], material.Alpha);
    }
    glEnable(GL_BLEND);
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse.data());
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, material.Emission.data());
    glBegin(GL_TRIANGLES);
    for (const STriangle& triangle : part.Triangles) {
      glNormal3d(triangle.Normal.GetX(), triangle.Normal.GetY(), triangle.Normal.GetZ());
      for (const UInt32 i : triangle.Vertices) {
        glVertex3d(m_vertices[i].GetX(), m_vertices[i].GetY(), m_vertices[i].GetZ());
      }
    }
    glEnd();
  }
  glPopAttrib();
}

}  // namespace argos
