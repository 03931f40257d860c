#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_GL_CONTEXT_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_GL_CONTEXT_H

#include <argos3/core/utility/non_copyable.h>
#include <argos3/plugins/simulator/visualizations/offscreen/gl_functions.h>

#include <memory>
#include <string>

namespace argos {

/**
 * An OpenGL core context, version 3.3 or later, that needs no display, window or GPU.
 *
 * The build compiles exactly one implementation, as its option ARGOS_GL_CONTEXT says:
 * gl_context_osmesa.cpp or gl_context_egl.cpp. Mesa dropped OSMesa in its release 25.1; EGL's
 * surfaceless platform replaces it there.
 *
 * A context has no usable default framebuffer: draw into framebuffer objects. Objects created in a
 * context live exactly as long as it does.
 */
class CGlContext : private CNonCopyable {
 public:
  virtual ~CGlContext() = default;

  /**
   * Makes a context and makes it current on the calling thread.
   * @throws CARGoSException naming the step that failed and what to install.
   */
  static std::unique_ptr<CGlContext> Create();

  /**
   * Makes this context the calling thread's current one; a thread that draws calls it first.
   * @throws CARGoSException if the library refuses, e.g. because another thread holds it.
   */
  virtual void MakeCurrent() = 0;

  /** How the context was made: "OSMesa" or "EGL surfaceless". */
  virtual std::string GetKind() const = 0;

  const SGlFunctions& GetFunctions() const { return m_functions; }

 protected:
  CGlContext() = default;

  SGlFunctions m_functions;
};

}  // namespace argos

#endif
