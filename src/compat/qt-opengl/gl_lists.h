#ifndef ARGOS3_COMPAT_QT_OPENGL_GL_LISTS_H
#define ARGOS3_COMPAT_QT_OPENGL_GL_LISTS_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/gl_calls.h>

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace argos {

/** A call of OpenGL that has a meaning here, as it is done or kept in a display list. */
struct SGlCommand {
  enum class EKind : UInt8 {
    Begin, /**< Number: what is drawn, such as GL_QUADS */
    End,
    Vertex,
    Normal,
    Color, /**< red, green, blue, alpha, each from 0 to 1; so are the next two */
    Diffuse,
    Emission,
    Switch, /**< Number: GL_LIGHTING or GL_BLEND; the first value: 0 = off */
    LineWidth, /**< pixels */
    PointSize, /**< pixels */
    PushAttributes,
    PopAttributes,
    MatrixMode,
    PushMatrix,
    PopMatrix,
    Translate,
    Rotate, /**< the axis, then the angle in degrees */
    Scale,
    Column, /**< of a matrix, Number: 0 to 2; the last one applies it */
    Call /**< Number: of the list */
  };

  EKind Kind = EKind::End;
  GLuint Number = 0;
  std::array<GLdouble, 4> Values{};
};
typedef std::vector<SGlCommand> TGlList;

/**
 * The display lists of the process. Users keep their numbers in objects that are static, so they
 * are valid on all threads, in all simulations; a list does not change after it was set.
 */
class CGlLists {
 public:
  static CGlLists& Get();

  /** @return the first of @p count new numbers; 0: there are none. */
  GLuint Reserve(GLsizei count);
  /** Replaces the list of this number. @return false: there is no room for it. */
  bool Set(GLuint number, TGlList list);
  /** Null if there is none. */
  std::shared_ptr<const TGlList> Find(GLuint number) const;
  void Delete(GLuint first, GLsizei count);

 private:
  void Remove(std::map<GLuint, std::shared_ptr<const TGlList>>::iterator place);

  mutable std::mutex m_mutex;
  std::map<GLuint, std::shared_ptr<const TGlList>> m_lists;
  GLuint m_next = 1;
  std::size_t m_size = 0;  // commands of all lists
};

}  // namespace argos

#endif
