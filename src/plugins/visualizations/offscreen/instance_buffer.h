#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_INSTANCE_BUFFER_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_INSTANCE_BUFFER_H

#include <argos3/plugins/simulator/visualizations/offscreen/gl_functions.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace argos {

/** A vertex array and a buffer of structs that is refilled for every frame. Lives as long as the
 * context. */
class CInstanceBuffer {
 public:
  enum class EAdvance : std::uint8_t { PerVertex, PerInstance };

  /**
   * Makes the buffer.
   * @param stride  size of a struct, bytes.
   * @param array   an existing vertex array to which its attributes belong; 0 = a new one.
   */
  CInstanceBuffer(const SGlFunctions& gl, std::size_t stride,
                  EAdvance advance = EAdvance::PerInstance, GLuint array = 0);

  /** An attribute of floats. @param offset  in the struct, bytes. */
  void AddFloats(GLuint attribute, GLint count, std::size_t offset) const;
  /** An attribute of four bytes, each from 0 to 1 in the shader. */
  void AddColor(GLuint attribute, std::size_t offset) const;

  /** Binds the vertex array, and replaces the contents of the buffer. */
  template <typename STRUCT>
  void Fill(const STRUCT* data, std::size_t count) const {
    FillBytes(data, count * sizeof(STRUCT));
  }
  template <typename STRUCT>
  void Fill(const std::vector<STRUCT>& data) const {
    Fill(data.data(), data.size());
  }

 private:
  void AddAttribute(GLuint attribute, GLint count, GLenum type, std::size_t offset) const;
  void FillBytes(const void* data, std::size_t size) const;
  void Bind() const;

  const SGlFunctions& m_gl;
  GLsizei m_stride;
  EAdvance m_advance;
  GLuint m_array;
  GLuint m_buffer = 0;
};

}  // namespace argos

#endif
