#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_RENDER_TARGET_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_RENDER_TARGET_H

#include <argos3/plugins/simulator/visualizations/offscreen/gl_functions.h>
#include <argos3/plugins/simulator/visualizations/offscreen/picture.h>

namespace argos {

/**
 * The target of the renderer: a multisampled sRGB framebuffer, and the buffers that average it to a
 * picture. All averaging is done in linear light.
 *
 * If the driver has fewer samples than requested, the picture is drawn at twice its size as well.
 */
class CRenderTarget {
 public:
  /**
   * @param width, height  of the picture, pixels.
   * @param samples        per pixel: 1, 2, 4, 8 or 16.
   * @throws CARGoSException if the driver cannot make it, e.g. because it is too large.
   */
  CRenderTarget(const SGlFunctions& gl, int width, int height, int samples);

  /** Directs drawing here. */
  void Bind() const;
  /** Averages the samples and copies the result to memory, rows from top to bottom. */
  void Read(SPicture& picture);

  /** Size of the framebuffer, pixels: the picture's size times GetScale(). */
  int GetDrawnWidth() const { return m_scale * m_width; }
  int GetDrawnHeight() const { return m_scale * m_height; }
  int GetScale() const { return m_scale; }

 private:
  GLuint MakeFramebuffer(int width, int height, int samples, bool withDepth) const;

  const SGlFunctions& m_gl;
  int m_width;
  int m_height;
  int m_scale = 1;
  GLuint m_multisampled = 0;
  GLuint m_resolved = 0;  // one sample per drawn pixel
  GLuint m_reduced = 0;  // has the picture's size; the same as m_resolved if the scale is 1
  std::vector<std::uint8_t> m_rows;  // bottom to top, as OpenGL reads them
};

}  // namespace argos

#endif
