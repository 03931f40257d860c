#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_GL_PROGRAM_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_GL_PROGRAM_H

#include <argos3/plugins/simulator/visualizations/offscreen/gl_functions.h>
#include <argos3/plugins/simulator/visualizations/scene/scene.h>
#include <argos3/plugins/simulator/visualizations/offscreen/shaders.h>

#include <Eigen/Core>

namespace argos {

/**
 * A vertex and a fragment shader, linked. Lives as long as the context.
 *
 * The setters act on the program in use: call Use() first. They ignore names that the shaders do
 * not use, because compilers remove unused uniforms.
 */
class CGlProgram {
 public:
  /** @throws CARGoSException with the compiler's message. */
  CGlProgram(const SGlFunctions& gl, const SShaderSource& source);

  void Use() const { m_gl.UseProgram(m_program); }

  void Set(const char* name, int value) const;
  void Set(const char* name, float value) const;
  void Set(const char* name, const Eigen::Vector2f& value) const;
  void Set(const char* name, const Eigen::Vector3f& value) const;
  void Set(const char* name, const Eigen::Vector4f& value) const;
  void Set(const char* name, const Eigen::Matrix4f& value) const;
  /** The colour in linear light, alpha unchanged. */
  void Set(const char* name, const SRgba& color) const;

 private:
  GLuint Compile(GLenum stage, const SShaderSource& source) const;
  GLint Locate(const char* name) const { return m_gl.GetUniformLocation(m_program, name); }

  const SGlFunctions& m_gl;
  GLuint m_program;
};

/** Turns a value of an image file, 0 to 255, to linear light, 0 to 1. Source: IEC 61966-2-1. */
float ToLinearLight(std::uint8_t value);

}  // namespace argos

#endif
