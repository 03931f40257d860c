#include <argos3/plugins/simulator/visualizations/offscreen/instance_buffer.h>

namespace argos {

CInstanceBuffer::CInstanceBuffer(const SGlFunctions& gl, std::size_t stride, EAdvance advance,
                                 GLuint array)
    : m_gl(gl), m_stride(static_cast<GLsizei>(stride)), m_advance(advance), m_array(array) {
  if (m_array == 0) {
    m_gl.GenVertexArrays(1, &m_array);
  }
  m_gl.GenBuffers(1, &m_buffer);
}

void CInstanceBuffer::Bind() const {
  m_gl.BindVertexArray(m_array);
  m_gl.BindBuffer(GL_ARRAY_BUFFER, m_buffer);
}

void CInstanceBuffer::AddFloats(GLuint attribute, GLint count, std::size_t offset) const {
  AddAttribute(attribute, count, GL_FLOAT, offset);
}

void CInstanceBuffer::AddColor(GLuint attribute, std::size_t offset) const {
  AddAttribute(attribute, 4, GL_UNSIGNED_BYTE, offset);
}

void CInstanceBuffer::AddAttribute(GLuint attribute, GLint count, GLenum type,
                                   std::size_t offset) const {
  Bind();
  m_gl.EnableVertexAttribArray(attribute);
  const GLboolean isNormalized = type == GL_UNSIGNED_BYTE ? GL_TRUE : GL_FALSE;
  m_gl.VertexAttribPointer(attribute, count, type, isNormalized, m_stride,
                           reinterpret_cast<const void*>(offset));
  m_gl.VertexAttribDivisor(attribute, m_advance == EAdvance::PerInstance ? 1 : 0);
}

void CInstanceBuffer::FillBytes(const void* data, std::size_t size) const {
  Bind();
  m_gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(size), data, GL_STREAM_DRAW);
}

}  // namespace argos
