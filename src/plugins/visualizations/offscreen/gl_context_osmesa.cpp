#include <argos3/plugins/simulator/visualizations/offscreen/gl_context.h>

#include <argos3/core/utility/configuration/argos_exception.h>

#include <GL/osmesa.h>

#include <array>

namespace argos {

namespace {

constexpr int kBufferSide =
    16;  // pixels; OSMesa requires a buffer; frames are drawn into framebuffer objects

class COSMesaContext : public CGlContext {
 public:
  COSMesaContext() {
    const std::array<int, 13> attributes = {OSMESA_FORMAT,
                                            OSMESA_RGBA,
                                            OSMESA_DEPTH_BITS,
                                            0,
                                            OSMESA_PROFILE,
                                            OSMESA_CORE_PROFILE,
                                            OSMESA_CONTEXT_MAJOR_VERSION,
                                            3,
                                            OSMESA_CONTEXT_MINOR_VERSION,
                                            3,
                                            0,
                                            0,
                                            0};
    m_context = OSMesaCreateContextAttribs(attributes.data(), nullptr);
    if (m_context == nullptr) {
      THROW_ARGOSEXCEPTION(
          "OSMesaCreateContextAttribs made no OpenGL 3.3 core context; install Mesa's off-screen "
          "renderer 12 to 25.0 (Debian: apt-get install libosmesa6), or build with "
          "-DARGOS_GL_CONTEXT=egl");
    }
    MakeCurrent();
    m_functions.Load([](const char* name) { return OSMesaGetProcAddress(name); });
  }

  ~COSMesaContext() override { OSMesaDestroyContext(m_context); }

  void MakeCurrent() override {
    if (OSMesaGetCurrentContext() == m_context) {
      return;
    }
    if (OSMesaMakeCurrent(m_context, m_buffer.data(), GL_UNSIGNED_BYTE, kBufferSide, kBufferSide) !=
        GL_TRUE) {
      THROW_ARGOSEXCEPTION("OSMesaMakeCurrent refused the off-screen OpenGL context");
    }
  }

  std::string GetKind() const override { return "OSMesa"; }

 private:
  OSMesaContext m_context = nullptr;
  std::array<unsigned char, 4 * kBufferSide * kBufferSide> m_buffer{};
};

}  // namespace

std::unique_ptr<CGlContext> CGlContext::Create() {
  return std::make_unique<COSMesaContext>();
}

}  // namespace argos
