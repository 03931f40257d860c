#include <argos3/plugins/simulator/visualizations/offscreen/render_target.h>

#include <argos3/core/utility/configuration/argos_exception.h>

#include <algorithm>
#include <cstring>

namespace argos {

CRenderTarget::CRenderTarget(const SGlFunctions& gl, int width, int height, int samples)
    : m_gl(gl), m_width(width), m_height(height) {
  GLint maxSamples = 1;
  gl.GetIntegerv(GL_MAX_SAMPLES, &maxSamples);
  if (samples > maxSamples) {
    m_scale = 2;
    samples = std::min((samples + 3) / 4, std::max(maxSamples, 1));
  }
  GLint maxSide = 0;
  gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &maxSide);
  if (std::max(GetDrawnWidth(), GetDrawnHeight()) > maxSide) {
    THROW_ARGOSEXCEPTION("A picture of " << width << "x" << height << " pixels is larger than the "
                                         << maxSide / m_scale << " pixels that the OpenGL driver "
                                         << "can draw along each side at these samples");
  }
  m_multisampled = MakeFramebuffer(GetDrawnWidth(), GetDrawnHeight(), samples, true);
  m_resolved = MakeFramebuffer(GetDrawnWidth(), GetDrawnHeight(), 0, false);
  m_reduced = m_scale == 1 ? m_resolved : MakeFramebuffer(width, height, 0, false);
}

GLuint CRenderTarget::MakeFramebuffer(int width, int height, int samples, bool withDepth) const {
  const GLsizei count = samples > 1 ? samples : 0;
  GLuint framebuffer = 0;
  m_gl.GenFramebuffers(1, &framebuffer);
  m_gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  GLuint buffers[2] = {0, 0};
  m_gl.GenRenderbuffers(withDepth ? 2 : 1, buffers);
  m_gl.BindRenderbuffer(GL_RENDERBUFFER, buffers[0]);
  m_gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, count, GL_SRGB8_ALPHA8, width, height);
  m_gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[0]);
  if (withDepth) {
    m_gl.BindRenderbuffer(GL_RENDERBUFFER, buffers[1]);
    m_gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, count, GL_DEPTH_COMPONENT32F, width,
                                        height);
    m_gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, buffers[1]);
  }
  const GLenum status = m_gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    THROW_ARGOSEXCEPTION("The OpenGL driver cannot make a framebuffer of "
                         << width << "x" << height << " pixels with " << std::max(samples, 1)
                         << " samples (status " << status
                         << "); try a smaller size or fewer samples");
  }
  return framebuffer;
}

void CRenderTarget::Bind() const {
  m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_multisampled);
  m_gl.Viewport(0, 0, GetDrawnWidth(), GetDrawnHeight());
}

void CRenderTarget::Read(SPicture& picture) {
  m_gl.BindFramebuffer(GL_READ_FRAMEBUFFER, m_multisampled);
  m_gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, m_resolved);
  m_gl.BlitFramebuffer(0, 0, GetDrawnWidth(), GetDrawnHeight(), 0, 0, GetDrawnWidth(),
                       GetDrawnHeight(), GL_COLOR_BUFFER_BIT, GL_NEAREST);
  if (m_scale != 1) {
    m_gl.BindFramebuffer(GL_READ_FRAMEBUFFER, m_resolved);
    m_gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, m_reduced);
    m_gl.BlitFramebuffer(0, 0, GetDrawnWidth(), GetDrawnHeight(), 0, 0, m_width, m_height,
                         GL_COLOR_BUFFER_BIT, GL_LINEAR);
  }
  const std::size_t rowSize = 4 * static_cast<std::size_t>(m_width);
  m_rows.resize(rowSize * static_cast<std::size_t>(m_height));
  picture.Width = m_width;
  picture.Height = m_height;
  picture.Pixels.resize(m_rows.size());
  m_gl.BindFramebuffer(GL_READ_FRAMEBUFFER, m_reduced);
  m_gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  m_gl.ReadPixels(0, 0, m_width, m_height, GL_RGBA, GL_UNSIGNED_BYTE, m_rows.data());
  for (std::size_t row = 0; row < static_cast<std::size_t>(m_height); ++row) {
    std::memcpy(picture.Pixels.data() + row * rowSize,
                m_rows.data() + (static_cast<std::size_t>(m_height) - 1 - row) * rowSize, rowSize);
  }
}

}  // namespace argos
