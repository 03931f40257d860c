#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_SHADOW_MAP_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_SHADOW_MAP_H

#include <argos3/plugins/simulator/visualizations/offscreen/gl_functions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace argos {

/**
 * The scene's depth as seen from the sun, which is infinitely far away.
 *
 * Source: Williams, Casting Curved Shadows on Curved Surfaces (SIGGRAPH 1978).
 */
class CShadowMap {
 public:
  /** @param pictureSide  the longer one, pixels: texels need not be much smaller than pixels. */
  CShadowMap(const SGlFunctions& gl, int pictureSide);

  /**
   * Aims the map at the shadow casters.
   * @param sunFrame  see MakeSunFrame().
   * @param bounds    box around the casters in that frame, m; may be empty.
   */
  void Fit(const Eigen::Matrix3d& sunFrame, const Eigen::AlignedBox3d& bounds);

  /** Directs drawing here, and empties the map. */
  void Bind() const;
  /** Makes the map readable through a texture unit. */
  void BindTexture(GLenum unit) const;

  /** World frame to the sun's clip space, for drawing the map. */
  const Eigen::Matrix4f& GetViewProjection() const { return m_viewProjection; }
  /** World frame to texture coordinates and depth, all in [0, 1] inside the map. */
  const Eigen::Matrix4f& GetWorldToMap() const { return m_worldToMap; }
  /** Side of a texel as a share of the map's side. */
  float GetTexelShare() const;
  /** Side of a texel, m. */
  float GetTexelSize() const { return m_texelSize; }

 private:
  const SGlFunctions& m_gl;
  GLuint m_framebuffer = 0;
  GLuint m_texture = 0;
  int m_side;  // texels
  int m_usedSide = 1;  // texels
  float m_texelSize = 1.0f;
  Eigen::Matrix4f m_viewProjection = Eigen::Matrix4f::Identity();
  Eigen::Matrix4f m_worldToMap = Eigen::Matrix4f::Identity();
};

}  // namespace argos

#endif
