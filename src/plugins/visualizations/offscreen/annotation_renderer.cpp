#include <argos3/plugins/simulator/visualizations/offscreen/annotation_renderer.h>

#include <argos3/plugins/simulator/visualizations/offscreen/render_target.h>
#include <argos3/plugins/simulator/visualizations/offscreen/shaders.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace argos {

namespace {

constexpr GLint kAtlasUnit = 2;  // the renderer uses those before it

}  // namespace

CAnnotationRenderer::SResources::SResources(const SGlFunctions& gl)
    : FlatProgram(gl, kFlatShader),
      TextProgram(gl, kTextShader),
      Flats(gl, sizeof(SFlatVertex), CInstanceBuffer::EAdvance::PerVertex),
      Glyphs(gl, sizeof(SGlyphInstance)) {
  Glyphs.AddFloats(0, 4, offsetof(SGlyphInstance, Area));
  Glyphs.AddFloats(1, 2, offsetof(SGlyphInstance, Texel));
  Glyphs.AddColor(2, offsetof(SGlyphInstance, Color));
  Flats.AddFloats(0, 3, offsetof(SFlatVertex, Position));
  Flats.AddColor(1, offsetof(SFlatVertex, Color));
  Flats.AddFloats(2, 1, offsetof(SFlatVertex, Nearer));
  gl.GenTextures(1, &AtlasTexture);
}

CAnnotationRenderer::SResources& CAnnotationRenderer::GetResources() {
  if (!m_resources.has_value()) {
    m_resources.emplace(m_gl);
  }
  return *m_resources;
}

void CAnnotationRenderer::DrawFlats(const SScene& scene, const Eigen::Matrix4f& view,
                                    const Eigen::Matrix4f& projection) {
  if (scene.Flats.empty() && scene.TranslucentFlats.empty()) {
    return;
  }
  const CGlProgram& program = GetResources().FlatProgram;
  program.Use();
  program.Set("uView", view);
  program.Set("uProjection", projection);
  DrawTriangles(scene.Flats);
  m_gl.Enable(GL_BLEND);
  m_gl.DepthMask(GL_FALSE);
  DrawTriangles(scene.TranslucentFlats);
  m_gl.DepthMask(GL_TRUE);
  m_gl.Disable(GL_BLEND);
}

void CAnnotationRenderer::DrawTriangles(const std::vector<SFlatVertex>& corners) {
  if (!corners.empty()) {
    GetResources().Flats.Fill(corners);
    m_gl.DrawArraysInstanced(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()), 1);
  }
}

void CAnnotationRenderer::DrawInFront(const SScene& scene, const CCamera& camera,
                                      const CRenderTarget& target) {
  if (scene.Labels.empty() && scene.OverlayFlats.empty() && scene.OverlayLabels.empty()) {
    return;
  }
  m_gl.Disable(GL_DEPTH_TEST);
  m_gl.Enable(GL_BLEND);
  m_atlas.BeginPicture();
  PlaceLabels(scene, camera, target);
  DrawLabels(m_placed, target);
  if (!scene.OverlayFlats.empty()) {
    // pixels to OpenGL's clip space
    Eigen::Matrix4f toClip = Eigen::Matrix4f::Identity();
    toClip(0, 0) = 2.0f * target.GetScale() / target.GetDrawnWidth();
    toClip(1, 1) = -2.0f * target.GetScale() / target.GetDrawnHeight();
    toClip(0, 3) = -1.0f;
    toClip(1, 3) = 1.0f;
    toClip(2, 2) = 0.0f;
    const CGlProgram& program = GetResources().FlatProgram;
    program.Use();
    program.Set("uView", Eigen::Matrix4f(Eigen::Matrix4f::Identity()));
    program.Set("uProjection", toClip);
    DrawTriangles(scene.OverlayFlats);
  }
  DrawLabels(scene.OverlayLabels, target);
  m_gl.Disable(GL_BLEND);
  m_gl.Enable(GL_DEPTH_TEST);
}

void CAnnotationRenderer::PlaceLabels(const SScene& scene, const CCamera& camera,
                                      const CRenderTarget& target) {
  std::vector<std::pair<double, const SLabel*>> byDepth;
  for (const SLabel& label : scene.Labels) {
    const Eigen::Vector3d position(label.Position[0], label.Position[1], label.Position[2]);
    const double depth = camera.ComputeDepth(position);
    if (depth > 0.0) {
      byDepth.emplace_back(depth, &label);
    }
  }
  std::stable_sort(byDepth.begin(), byDepth.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  m_placed.clear();
  const double scale = target.GetScale();
  for (const auto& [depth, label] : byDepth) {
    const Eigen::Vector3d position(label->Position[0], label->Position[1], label->Position[2]);
    const Eigen::Vector2d share = camera.Project(position);
    SLabel placed = *label;
    placed.Position = {static_cast<float>(share.x() * target.GetDrawnWidth() / scale),
                       static_cast<float>(share.y() * target.GetDrawnHeight() / scale), 0.0f};
    m_placed.push_back(std::move(placed));
  }
}

void CAnnotationRenderer::DrawLabels(const std::vector<SLabel>& labels,
                                     const CRenderTarget& target) {
  const double scale = target.GetScale();
  m_glyphs.clear();
  for (const SLabel& label : labels) {
    m_atlas.Append(label, scale * label.Position[0], scale * label.Position[1], scale, m_glyphs);
  }
  if (m_glyphs.empty()) {
    return;
  }
  UploadAtlas();
  const CGlProgram& program = GetResources().TextProgram;
  program.Use();
  program.Set("uPictureSize", Eigen::Vector2f(static_cast<float>(target.GetDrawnWidth()),
                                              static_cast<float>(target.GetDrawnHeight())));
  program.Set("uAtlas", kAtlasUnit);
  GetResources().Glyphs.Fill(m_glyphs);
  m_gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(m_glyphs.size()));
}

void CAnnotationRenderer::UploadAtlas() {
  SResources& resources = GetResources();
  m_gl.ActiveTexture(GL_TEXTURE0 + kAtlasUnit);
  m_gl.BindTexture(GL_TEXTURE_2D, resources.AtlasTexture);
  if (resources.AtlasVersion == m_atlas.GetVersion()) {
    return;
  }
  resources.AtlasVersion = m_atlas.GetVersion();
  m_gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  m_gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, m_atlas.GetWidth(), m_atlas.GetHeight(), 0, GL_RED,
                  GL_UNSIGNED_BYTE, m_atlas.GetPixels().data());
  m_gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  m_gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace argos
