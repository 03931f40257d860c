#include <argos3/plugins/simulator/visualizations/offscreen/gl_context.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/text/classic_locale.h>

// keeps the X11 headers, and their macros, out
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <sstream>

namespace argos {

namespace {

constexpr const char* kRemedy =
    "; install Mesa's EGL library and software renderer (Debian: apt-get install libegl-mesa0 "
    "libgl1-mesa-dri), or build with -DARGOS_GL_CONTEXT=osmesa";

[[noreturn]] void ThrowEglError(const char* what) {
  CTextOutput text;
  text << what << " failed with EGL error 0x" << std::hex << eglGetError() << kRemedy;
  THROW_ARGOSEXCEPTION(text.str());
}

EGLDisplay OpenDisplay() {
  const auto getPlatformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (getPlatformDisplay == nullptr) {
    ThrowEglError("eglGetProcAddress(eglGetPlatformDisplayEXT)");
  }
  EGLDisplay display =
      getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY) {
    ThrowEglError("eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA)");
  }
  if (eglInitialize(display, nullptr, nullptr) != EGL_TRUE) {
    ThrowEglError("eglInitialize");
  }
  return display;
}

// the display is one per process and platform and is never terminated: other contexts may share it
class CEglContext : public CGlContext {
 public:
  CEglContext() : m_display(OpenDisplay()) {
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) {
      ThrowEglError("eglBindAPI(EGL_OPENGL_API)");
    }
    const std::array<EGLint, 7> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                              3,
                                              EGL_CONTEXT_MINOR_VERSION,
                                              3,
                                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                              EGL_NONE};
    m_context = eglCreateContext(m_display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
    if (m_context == EGL_NO_CONTEXT) {
      ThrowEglError("eglCreateContext(OpenGL 3.3 core)");
    }
    MakeCurrent();
    m_functions.Load([](const char* name) { return eglGetProcAddress(name); });
  }

  ~CEglContext() override {
    if (eglGetCurrentContext() == m_context) {
      eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(m_display, m_context);
  }

  void MakeCurrent() override {
    if (eglGetCurrentContext() == m_context) {
      return;
    }
    // the bound interface is a property of the thread
    eglBindAPI(EGL_OPENGL_API);
    if (eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context) != EGL_TRUE) {
      ThrowEglError("eglMakeCurrent");
    }
  }

  std::string GetKind() const override { return "EGL surfaceless"; }

 private:
  EGLDisplay m_display;
  EGLContext m_context = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<CGlContext> CGlContext::Create() {
  return std::make_unique<CEglContext>();
}

}  // namespace argos
