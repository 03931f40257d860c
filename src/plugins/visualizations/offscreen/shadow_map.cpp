#include <argos3/plugins/simulator/visualizations/offscreen/shadow_map.h>

#include <argos3/core/utility/configuration/argos_exception.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace argos {

namespace {

constexpr int kMinMapSide = 512;  // texels
constexpr int kMaxMapSide = 2048;
// smaller texels would only sharpen the shadows, whose borders are about three texels wide
constexpr double kMinTexel = 0.0018;  // m
constexpr double kBorderTexels = 4.0;  // the filter reads a few texels around a point
constexpr double kMinExtent = 0.05;  // m

}  // namespace

CShadowMap::CShadowMap(const SGlFunctions& gl, int pictureSide)
    : m_gl(gl), m_side(std::clamp(3 * pictureSide / 2, kMinMapSide, kMaxMapSide)) {
  gl.GenTextures(1, &m_texture);
  gl.BindTexture(GL_TEXTURE_2D, m_texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, m_side, m_side, 0, GL_DEPTH_COMPONENT,
                GL_FLOAT, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  const std::array<GLfloat, 4> farthest = {1.0f, 1.0f, 1.0f, 1.0f};
  gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, farthest.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  gl.GenFramebuffers(1, &m_framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, m_texture, 0);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    THROW_ARGOSEXCEPTION("The OpenGL driver cannot make a shadow map of "
                         << m_side << "x" << m_side << " texels (status " << status << ")");
  }
}

void CShadowMap::Fit(const Eigen::Matrix3d& sunFrame, const Eigen::AlignedBox3d& bounds) {
  Eigen::AlignedBox3d box = bounds;
  if (box.isEmpty()) {
    box.extend(Eigen::Vector3d::Zero());
  }
  // the ground below receives shadows beyond the casters' far side: depths past it are clamped
  const Eigen::Vector2d size =
      box.sizes().head<2>().cwiseMax(kMinExtent) * (1.0 + 2.0 * kBorderTexels / m_side);
  const double depth = std::max(box.sizes().z(), kMinExtent);
  const double wantedSide = std::ceil(size.maxCoeff() / kMinTexel);
  m_usedSide = static_cast<int>(std::min<double>(wantedSide, m_side));
  m_texelSize = static_cast<float>(size.maxCoeff() / m_usedSide);

  Eigen::Matrix4d toClip = Eigen::Matrix4d::Identity();
  toClip(0, 0) = 2.0 / size.x();
  toClip(1, 1) = 2.0 / size.y();
  toClip(2, 2) = -2.0 / depth;
  toClip.block<3, 1>(0, 3) = -toClip.diagonal().head<3>().cwiseProduct(box.center());
  Eigen::Matrix4d rotation = Eigen::Matrix4d::Identity();
  rotation.block<3, 3>(0, 0) = sunFrame;
  const Eigen::Matrix4d viewProjection = toClip * rotation;
  // a small arena uses only the lower left corner of the texture
  const double half = 0.5 * m_usedSide / m_side;
  Eigen::Matrix4d toUnit = Eigen::Vector4d(half, half, 0.5, 1.0).asDiagonal();
  toUnit.col(3) = Eigen::Vector4d(half, half, 0.5, 1.0);
  m_viewProjection = viewProjection.cast<float>();
  m_worldToMap = (toUnit * viewProjection).cast<float>();
}

void CShadowMap::Bind() const {
  m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
  m_gl.Viewport(0, 0, m_usedSide, m_usedSide);
  m_gl.Clear(GL_DEPTH_BUFFER_BIT);
}

void CShadowMap::BindTexture(GLenum unit) const {
  m_gl.ActiveTexture(unit);
  m_gl.BindTexture(GL_TEXTURE_2D, m_texture);
}

float CShadowMap::GetTexelShare() const {
  return 1.0f / static_cast<float>(m_side);
}

}  // namespace argos
