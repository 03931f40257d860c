#include <argos3/plugins/simulator/visualizations/offscreen/gl_program.h>

#include <argos3/core/utility/configuration/argos_exception.h>

#include <array>
#include <cmath>
#include <string>

namespace argos {

namespace {

// The messages of the driver about a shader or a program. @param getLog  the function for its kind.
template <typename GETLOG>
std::string ReadLog(const GETLOG& getLog, GLuint object) {
  constexpr GLsizei kMaxBytes = 2048;
  std::array<char, kMaxBytes> message{};
  getLog(object, kMaxBytes, nullptr, message.data());
  return message.data();
}

}  // namespace

float ToLinearLight(std::uint8_t value) {
  const float share = static_cast<float>(value) / 255.0f;
  return share <= 0.04045f ? share / 12.92f : std::pow((share + 0.055f) / 1.055f, 2.4f);
}

CGlProgram::CGlProgram(const SGlFunctions& gl, const SShaderSource& source)
    : m_gl(gl), m_program(gl.CreateProgram()) {
  for (const GLenum stage : {GLenum{GL_VERTEX_SHADER}, GLenum{GL_FRAGMENT_SHADER}}) {
    const GLuint shader = Compile(stage, source);
    m_gl.AttachShader(m_program, shader);
    m_gl.DeleteShader(shader);
  }
  m_gl.LinkProgram(m_program);
  GLint linked = GL_FALSE;
  m_gl.GetProgramiv(m_program, GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) {
    THROW_ARGOSEXCEPTION("The OpenGL driver cannot link the shaders \""
                         << source.Name << "\": " << ReadLog(m_gl.GetProgramInfoLog, m_program));
  }
}

GLuint CGlProgram::Compile(GLenum stage, const SShaderSource& source) const {
  const GLuint shader = m_gl.CreateShader(stage);
  const std::array<const char*, 4> texts = {
      kShaderVersion, source.Defines.c_str(), kShaderPreamble,
      stage == GL_VERTEX_SHADER ? source.Vertex : source.Fragment};
  m_gl.ShaderSource(shader, static_cast<GLsizei>(texts.size()), texts.data(), nullptr);
  m_gl.CompileShader(shader);
  GLint compiled = GL_FALSE;
  m_gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled != GL_TRUE) {
    THROW_ARGOSEXCEPTION("The OpenGL driver cannot compile the "
                         << (stage == GL_VERTEX_SHADER ? "vertex" : "fragment") << " shader \""
                         << source.Name << "\": " << ReadLog(m_gl.GetShaderInfoLog, shader));
  }
  return shader;
}

void CGlProgram::Set(const char* name, int value) const {
  m_gl.Uniform1i(Locate(name), value);
}

void CGlProgram::Set(const char* name, float value) const {
  m_gl.Uniform1f(Locate(name), value);
}

void CGlProgram::Set(const char* name, const Eigen::Vector2f& value) const {
  m_gl.Uniform2f(Locate(name), value.x(), value.y());
}

void CGlProgram::Set(const char* name, const Eigen::Vector3f& value) const {
  m_gl.Uniform3f(Locate(name), value.x(), value.y(), value.z());
}

void CGlProgram::Set(const char* name, const Eigen::Vector4f& value) const {
  m_gl.Uniform4f(Locate(name), value.x(), value.y(), value.z(), value.w());
}

void CGlProgram::Set(const char* name, const Eigen::Matrix4f& value) const {
  m_gl.UniformMatrix4fv(Locate(name), 1, GL_FALSE, value.data());
}

void CGlProgram::Set(const char* name, const SRgba& color) const {
  m_gl.Uniform4f(Locate(name), ToLinearLight(color.R), ToLinearLight(color.G),
                 ToLinearLight(color.B), static_cast<float>(color.A) / 255.0f);
}

}  // namespace argos
