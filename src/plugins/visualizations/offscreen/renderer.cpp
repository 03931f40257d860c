#include <argos3/plugins/simulator/visualizations/offscreen/renderer.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/plugins/simulator/visualizations/offscreen/mesh.h>
#include <argos3/plugins/simulator/visualizations/offscreen/shaders.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>

namespace argos {

namespace {

constexpr GLint kShadowUnit = 0;
constexpr GLint kFloorUnit = 1;
constexpr size_t kTranslucentLevel = 2;
// diameters of the discs that stand for robots too small to be seen, in pixels of the picture
constexpr double kMarkerPixels = 5.0;  // radius in a picture that is 960 pixels high
constexpr double kMinMarkerPixels = 2.0;
constexpr double kMarkerShare = 0.05;  // greatest share of the picture that all discs cover
constexpr double kMinNearDistance = 0.002;  // m
constexpr double kNearOverFar = 2e-5;  // a 32-bit depth buffer still separates millimetres
constexpr GLfloat kDepthSlope = 1.5f;  // shadow bias, in depth steps per unit of slope
constexpr GLfloat kDepthUnits = 4.0f;

const void* Offset(size_t bytes) {
  return reinterpret_cast<const void*>(bytes);
}

Eigen::Vector3d ToVector(const std::array<float, 3>& point) {
  return {point[0], point[1], point[2]};
}

SRenderSettings Normalized(SRenderSettings settings) {
  settings.ToSun.normalize();
  return settings;
}

}  // namespace

CRenderer::CRenderer(const SRenderSettings& settings)
    : m_settings(Normalized(settings)),
      m_context(CGlContext::Create()),
      m_gl(m_context->GetFunctions()),
      m_target(m_gl, settings.Width, settings.Height, settings.Samples),
      m_shadowMap(m_gl, std::max(settings.Width, settings.Height)),
      m_meshProgram(m_gl, kMeshShader),
      m_depthProgram(m_gl, kDepthShader),
      m_contactProgram(m_gl, kContactShadowShader),
      m_glowProgram(m_gl, kGlowShader),
      m_lineProgram(m_gl, kLineShader),
      m_annotations(m_gl),
      m_meshArray(CreateMeshes()),
      m_meshInstances(m_gl, sizeof(SMeshInstance), CInstanceBuffer::EAdvance::PerInstance,
                      m_meshArray),
      m_groundInstances(m_gl, sizeof(TGroundArea)),
      m_contactInstances(m_gl, sizeof(SContactShadow)),
      m_glowInstances(m_gl, sizeof(SGlow)),
      m_lineInstances(m_gl, sizeof(SLine)),
      m_toSun(m_settings.ToSun) {
  DescribeInstances();
  m_gl.GenTextures(1, &m_floorTexture);
  m_gl.DepthFunc(GL_LEQUAL);
  m_gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  m_gl.PolygonOffset(kDepthSlope, kDepthUnits);
}

std::string CRenderer::DescribeDriver() const {
  const auto text = [this](GLenum name) {
    const GLubyte* value = m_gl.GetString(name);
    return value != nullptr ? reinterpret_cast<const char*>(value) : "unknown";
  };
  CTextOutput description;
  description << m_context->GetKind() << ", " << text(GL_RENDERER) << ", OpenGL "
              << text(GL_VERSION);
  return description.str();
}

GLuint CRenderer::CreateMeshes() {
  SMesh all;
  for (size_t kind = 0; kind < kNumMeshKinds; ++kind) {
    for (size_t level = 0; level < kNumLevels; ++level) {
      const SMesh mesh = MakeMesh(static_cast<EMeshKind>(kind), kSegmentsPerLevel[level]);
      const auto firstVertex = static_cast<std::uint32_t>(all.Vertices.size());
      m_meshes[kind][level] = {static_cast<GLsizei>(mesh.Indices.size()), all.Indices.size()};
      all.Vertices.insert(all.Vertices.end(), mesh.Vertices.begin(), mesh.Vertices.end());
      for (const std::uint32_t index : mesh.Indices) {
        all.Indices.push_back(firstVertex + index);
      }
    }
  }
  GLuint array = 0;
  m_gl.GenVertexArrays(1, &array);
  m_gl.BindVertexArray(array);
  GLuint buffers[2] = {0, 0};
  m_gl.GenBuffers(2, buffers);
  m_gl.BindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  m_gl.BufferData(GL_ARRAY_BUFFER,
                  static_cast<GLsizeiptr>(all.Vertices.size() * sizeof(SMeshVertex)),
                  all.Vertices.data(), GL_STATIC_DRAW);
  m_gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  m_gl.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                  static_cast<GLsizeiptr>(all.Indices.size() * sizeof(std::uint32_t)),
                  all.Indices.data(), GL_STATIC_DRAW);
  const size_t offsets[3] = {offsetof(SMeshVertex, Position), offsetof(SMeshVertex, Normal),
                             offsetof(SMeshVertex, Edge)};
  const GLint sizes[3] = {3, 3, 2};
  for (GLuint attribute = 0; attribute < 3; ++attribute) {
    m_gl.EnableVertexAttribArray(attribute);
    m_gl.VertexAttribPointer(attribute, sizes[attribute], GL_FLOAT, GL_FALSE, sizeof(SMeshVertex),
                             Offset(offsets[attribute]));
  }
  return array;
}

void CRenderer::DescribeInstances() {
  for (GLuint row = 0; row < 3; ++row) {
    m_meshInstances.AddFloats(3 + row, 4,
                              offsetof(SMeshInstance, ToWorld) + row * 4 * sizeof(float));
  }
  m_meshInstances.AddColor(6, offsetof(SMeshInstance, Color));
  m_meshInstances.AddFloats(7, 1, offsetof(SMeshInstance, Param));

  m_groundInstances.AddFloats(0, 4, 0);

  m_contactInstances.AddFloats(0, 2, offsetof(SContactShadow, Center));
  m_contactInstances.AddFloats(1, 2, offsetof(SContactShadow, AxisX));
  m_contactInstances.AddFloats(2, 2, offsetof(SContactShadow, HalfExtent));
  m_contactInstances.AddFloats(3, 2, offsetof(SContactShadow, CornerRadius));

  m_glowInstances.AddFloats(0, 3, offsetof(SGlow, Position));
  m_glowInstances.AddFloats(1, 1, offsetof(SGlow, Radius));
  m_glowInstances.AddColor(2, offsetof(SGlow, Color));
  m_glowInstances.AddFloats(3, 1, offsetof(SGlow, HaloScale));
  m_glowInstances.AddFloats(4, 1, offsetof(SGlow, Pixels));
  m_glowInstances.AddFloats(5, 1, offsetof(SGlow, IsSignal));

  m_lineInstances.AddFloats(0, 3, offsetof(SLine, Start));
  m_lineInstances.AddFloats(1, 3, offsetof(SLine, End));
  m_lineInstances.AddColor(2, offsetof(SLine, Color));
  m_lineInstances.AddFloats(3, 1, offsetof(SLine, Width));
}

void CRenderer::UploadFloor(const SFloorImage& floor) {
  m_gl.ActiveTexture(GL_TEXTURE0 + kFloorUnit);
  m_gl.BindTexture(GL_TEXTURE_2D, m_floorTexture);
  const bool wanted = floor.Pixels != nullptr;
  if (!wanted || (m_hasFloor && floor.Version == m_floorVersion)) {
    m_hasFloor = wanted;
    return;
  }
  GLint maxSide = 0;
  m_gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &maxSide);
  if (std::max(floor.Width, floor.Height) > maxSide) {
    THROW_ARGOSEXCEPTION("The floor's image has " << floor.Width << "x" << floor.Height
                                                  << " pixels; the OpenGL driver draws at most "
                                                  << maxSide << " along each side");
  }
  m_gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  m_gl.TexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, floor.Width, floor.Height, 0, GL_RGBA,
                  GL_UNSIGNED_BYTE, floor.Pixels->data());
  m_gl.GenerateMipmap(GL_TEXTURE_2D);
  m_gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  m_gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  const GLint wrap = floor.TileSize[0] > 0.0f ? GL_REPEAT : GL_CLAMP_TO_EDGE;
  m_gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  m_gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
  m_floorVersion = floor.Version;
  m_hasFloor = true;
}

void CRenderer::ComputeMatrices(const SScene& scene, const CCamera& camera) {
  m_groundReach = 0.5 * (scene.ArenaMax - scene.ArenaMin).norm();
  const Eigen::Vector2d reach = Eigen::Vector2d::Constant(m_groundReach);
  const Eigen::AlignedBox2d ground(scene.ArenaMin - reach, scene.ArenaMax + reach);

  Eigen::AlignedBox<double, 1> depths = m_batches.GetDepths();
  for (int corner = 0; corner < 4; ++corner) {
    const Eigen::Vector2d xy = ground.corner(static_cast<Eigen::AlignedBox2d::CornerType>(corner));
    const double depth = camera.ComputeDepth(Eigen::Vector3d(xy.x(), xy.y(), 0.0));
    depths.extend(Eigen::Matrix<double, 1, 1>(depth));
  }
  // rays, areas and lights in the air may be nearer than any solid
  for (const SLine& line : scene.Lines) {
    for (const std::array<float, 3>& end : {line.Start, line.End}) {
      depths.extend(Eigen::Matrix<double, 1, 1>(camera.ComputeDepth(ToVector(end))));
    }
  }
  for (const std::vector<SFlatVertex>* flats : {&scene.Flats, &scene.TranslucentFlats}) {
    for (const SFlatVertex& corner : *flats) {
      depths.extend(Eigen::Matrix<double, 1, 1>(camera.ComputeDepth(ToVector(corner.Position))));
    }
  }
  for (const SGlow& glow : scene.Glows) {
    const double depth = camera.ComputeDepth(ToVector(glow.Position));
    depths.extend(Eigen::Matrix<double, 1, 1>(depth - glow.Radius));
    depths.extend(Eigen::Matrix<double, 1, 1>(depth + glow.Radius));
  }
  const double farPlane = std::max(depths.max().x() * 1.01, 1.0);
  const double nearPlane =
      std::max({depths.min().x() * 0.99, kMinNearDistance, kNearOverFar * farPlane});
  const Eigen::Matrix4d view = camera.ComputeViewMatrix();
  const Eigen::Matrix4d projection = camera.ComputeProjectionMatrix(nearPlane, farPlane);
  m_near = static_cast<float>(nearPlane);
  m_eye.head<3>() =
      (camera.IsOrthographic() ? -camera.GetForward() : camera.GetPosition()).cast<float>();
  m_eye.w() = camera.IsOrthographic() ? 0.0f : 1.0f;
  m_view = view.cast<float>();
  m_projection = projection.cast<float>();
  m_viewProjection = (projection * view).cast<float>();
  m_pixelsPerUnit =
      static_cast<float>(0.5 * m_target.GetDrawnHeight() / camera.GetHalfExtents().y());
}

void CRenderer::Render(const SScene& scene, const SCameraPlacement& placement, SPicture& picture) {
  m_context->MakeCurrent();
  const CCamera camera(placement, static_cast<double>(m_settings.Width) / m_settings.Height);
  m_batches.Fill(scene, camera, m_target.GetDrawnHeight(), m_toSun);
  ComputeMatrices(scene, camera);
  UploadFloor(scene.Floor);
  DrawShadowMap();

  m_target.Bind();
  m_gl.Enable(GL_FRAMEBUFFER_SRGB);
  const SRgba& background = m_settings.Look.Background;
  m_gl.ClearColor(ToLinearLight(background.R), ToLinearLight(background.G),
                  ToLinearLight(background.B), 1.0f);
  m_gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  m_shadowMap.BindTexture(GL_TEXTURE0 + kShadowUnit);
  m_gl.Enable(GL_DEPTH_TEST);
  DrawGround(scene);
  DrawContactShadows(scene);
  DrawMeshes();
  m_annotations.DrawFlats(scene, m_view, m_projection);
  DrawLines(scene);
  DrawGlows(scene);
  m_annotations.DrawInFront(scene, camera, m_target);
  m_target.Read(picture);

  const GLenum error = m_gl.GetError();
  if (error != GL_NO_ERROR) {
    THROW_ARGOSEXCEPTION("Drawing a frame failed with OpenGL error "
                         << error << (error == GL_OUT_OF_MEMORY ? " (out of memory)" : "")
                         << "; the driver is " << DescribeDriver());
  }
}

void CRenderer::SetLighting(const CGlProgram& program) const {
  const SLook& look = m_settings.Look;
  program.Set("uToSun", Eigen::Vector3f(m_toSun.cast<float>()));
  program.Set("uSunIntensity", look.SunIntensity);
  program.Set("uSkyLight", look.SkyLight);
  program.Set("uBounceLight", look.BounceLight);
  program.Set("uAmbientIntensity", look.AmbientIntensity);
  program.Set("uWorldToShadow", m_shadowMap.GetWorldToMap());
  program.Set("uShadowTexel", m_shadowMap.GetTexelShare());
  program.Set("uShadowMap", kShadowUnit);
  program.Set("uPixelScale", static_cast<float>(m_target.GetScale()));
}

void CRenderer::DrawShadowMap() {
  m_shadowMap.Fit(MakeSunFrame(m_toSun), m_batches.GetCasterBounds());
  m_gl.DepthMask(GL_TRUE);
  m_shadowMap.Bind();
  m_gl.Enable(GL_DEPTH_TEST);
  m_gl.Enable(GL_POLYGON_OFFSET_FILL);
  m_depthProgram.Use();
  m_depthProgram.Set("uViewProjection", m_shadowMap.GetViewProjection());
  DrawBatches(m_batches.GetCasters(), m_depthProgram);
  m_gl.Disable(GL_POLYGON_OFFSET_FILL);
}

void CRenderer::DrawGround(const SScene& scene) {
  const Eigen::Vector2d reach = Eigen::Vector2d::Constant(m_groundReach);
  const Eigen::AlignedBox2d ground(scene.ArenaMin - reach, scene.ArenaMax + reach);
  m_groundCells.Fill(ground, m_batches.GetCasters(), m_toSun, 4.0 * m_shadowMap.GetTexelSize());
  const auto end = static_cast<float>(kGroundCells);
  const unsigned parts = (m_hasFloor ? GROUND_HAS_FLOOR : 0U) |
                         (scene.ShowGrid ? GROUND_HAS_GRID : 0U) |
                         (scene.ShowBoundary ? GROUND_HAS_BOUNDARY : 0U);
  DrawGroundAreas(scene, parts, {{0.0f, 0.0f, end, end}});
  // nothing else is drawn yet: parts with shadows replace those without
  m_gl.Disable(GL_DEPTH_TEST);
  DrawGroundAreas(scene, parts | GROUND_HAS_SHADOWS, m_groundCells.GetShaded());
  m_gl.Enable(GL_DEPTH_TEST);
}

void CRenderer::DrawGroundAreas(const SScene& scene, unsigned parts,
                                const std::vector<TGroundArea>& areas) {
  if (areas.empty()) {
    return;
  }
  if (m_groundPrograms.count(parts) == 0) {
    m_groundPrograms.try_emplace(parts, m_gl, MakeGroundShader(parts));
  }
  const CGlProgram& program = m_groundPrograms.at(parts);
  const SLook& look = m_settings.Look;
  const Eigen::Vector2d reach = Eigen::Vector2d::Constant(m_groundReach);
  program.Use();
  SetLighting(program);
  program.Set("uViewProjection", m_viewProjection);
  program.Set("uMin", Eigen::Vector2f((scene.ArenaMin - reach).cast<float>()));
  program.Set("uMax", Eigen::Vector2f((scene.ArenaMax + reach).cast<float>()));
  program.Set("uArenaMin", Eigen::Vector2f(scene.ArenaMin.cast<float>()));
  program.Set("uArenaMax", Eigen::Vector2f(scene.ArenaMax.cast<float>()));
  program.Set("uFadeLength", static_cast<float>(m_groundReach));
  program.Set("uBackground", look.Background);
  program.Set("uGround", look.Ground);
  program.Set("uGroundOutside", look.GroundOutside);
  program.Set("uGridLine", look.GridLine);
  program.Set("uBoundary", look.Boundary);
  program.Set("uFloorSize", Eigen::Vector2f(static_cast<float>(scene.Floor.Width),
                                            static_cast<float>(scene.Floor.Height)));
  const Eigen::Vector2f tile(scene.Floor.TileSize[0], scene.Floor.TileSize[1]);
  program.Set("uFloorExtent",
              tile.minCoeff() > 0.0f
                  ? tile
                  : Eigen::Vector2f((scene.ArenaMax - scene.ArenaMin).cast<float>()));
  program.Set("uIsFloorSmooth", scene.Floor.IsSmooth ? 1 : 0);
  program.Set("uFloor", kFloorUnit);
  program.Set("uNumCells", static_cast<float>(kGroundCells));
  m_groundInstances.Fill(areas);
  m_gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(areas.size()));
}

void CRenderer::DrawContactShadows(const SScene& scene) {
  if (scene.ContactShadows.empty()) {
    return;
  }
  // contact shadows lie in the ground and are drawn right after it: no depth test
  m_gl.Disable(GL_DEPTH_TEST);
  m_gl.Enable(GL_BLEND);
  m_contactProgram.Use();
  m_contactProgram.Set("uViewProjection", m_viewProjection);
  m_contactProgram.Set("uContactDarkening", m_settings.Look.ContactDarkening);
  m_contactInstances.Fill(scene.ContactShadows);
  m_gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4,
                           static_cast<GLsizei>(scene.ContactShadows.size()));
  m_gl.Disable(GL_BLEND);
  m_gl.Enable(GL_DEPTH_TEST);
}

void CRenderer::DrawMeshes() {
  const SLook& look = m_settings.Look;
  m_meshProgram.Use();
  SetLighting(m_meshProgram);
  m_meshProgram.Set("uViewProjection", m_viewProjection);
  m_meshProgram.Set("uEye", m_eye);
  m_meshProgram.Set("uSpecularIntensity", look.SpecularIntensity);
  m_meshProgram.Set("uEdgeDarkening", look.EdgeDarkening);
  m_meshProgram.Set("uShadowOffset", 1.5f * m_shadowMap.GetTexelSize());
  m_meshProgram.Set("uLeastAlpha", 1.0f);
  DrawBatches(m_batches.GetOpaque(), m_meshProgram);
  m_meshProgram.Set("uLeastAlpha", 0.0f);
  DrawTranslucentMeshes(m_meshProgram);
}

void CRenderer::DrawTranslucentMeshes(const CGlProgram& program) {
  m_gl.Enable(GL_BLEND);
  m_gl.Enable(GL_CULL_FACE);
  m_gl.DepthMask(GL_FALSE);
  for (const STranslucentRange& range : m_batches.GetTranslucentRanges()) {
    program.Set("uKind", static_cast<int>(range.Kind));
    // far sides of the solids first, then their near sides
    for (const GLenum hidden : {GLenum{GL_FRONT}, GLenum{GL_BACK}}) {
      m_gl.CullFace(hidden);
      DrawInstances(range.Kind, kTranslucentLevel, m_batches.GetTranslucent().data() + range.First,
                    range.Count);
    }
  }
  m_gl.DepthMask(GL_TRUE);
  m_gl.Disable(GL_CULL_FACE);
  m_gl.Disable(GL_BLEND);
}

void CRenderer::DrawBatches(const CInstanceBatches::TBatches& batches, const CGlProgram& program) {
  m_gl.Enable(GL_CULL_FACE);
  m_gl.CullFace(GL_BACK);
  for (size_t kind = 0; kind < kNumMeshKinds; ++kind) {
    program.Set("uKind", static_cast<int>(kind));
    for (size_t level = 0; level < kNumLevels; ++level) {
      const std::vector<SMeshInstance>& instances = batches[kind][level];
      if (!instances.empty()) {
        DrawInstances(static_cast<EMeshKind>(kind), level, instances.data(), instances.size());
      }
    }
  }
  m_gl.Disable(GL_CULL_FACE);
}

void CRenderer::DrawInstances(EMeshKind kind, size_t level, const SMeshInstance* instances,
                              size_t count) {
  ARGOS_ASSERT(static_cast<size_t>(kind) < m_meshes.size() &&
                   level < m_meshes[static_cast<size_t>(kind)].size(),
               "there is no mesh of kind " << static_cast<int>(kind) << " and level " << level);
  const SMeshRange& range = m_meshes[static_cast<size_t>(kind)][level];
  m_meshInstances.Fill(instances, count);
  m_gl.DrawElementsInstanced(GL_TRIANGLES, range.NumIndices, GL_UNSIGNED_INT,
                             Offset(range.FirstIndex * sizeof(std::uint32_t)),
                             static_cast<GLsizei>(count));
}

void CRenderer::DrawLines(const SScene& scene) {
  if (scene.Lines.empty()) {
    return;
  }
  m_gl.Enable(GL_BLEND);
  m_gl.DepthMask(GL_FALSE);
  m_lineProgram.Use();
  m_lineProgram.Set("uView", m_view);
  m_lineProgram.Set("uProjection", m_projection);
  m_lineProgram.Set("uNear", m_near);
  m_lineProgram.Set("uPictureSize", Eigen::Vector2f(static_cast<float>(m_target.GetDrawnWidth()),
                                                    static_cast<float>(m_target.GetDrawnHeight())));
  m_lineProgram.Set("uPixelScale", static_cast<float>(m_target.GetScale()));
  m_lineInstances.Fill(scene.Lines);
  m_gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(scene.Lines.size()));
  m_gl.DepthMask(GL_TRUE);
  m_gl.Disable(GL_BLEND);
}

void CRenderer::AddMarkers(const SScene& scene) {
  const double area = static_cast<double>(m_settings.Width) * m_settings.Height;
  const double crowded = std::sqrt(kMarkerShare * area / std::max<double>(1, scene.Markers.size()));
  const double largest = kMarkerPixels * m_settings.Height / 960.0;
  const auto pixels = static_cast<float>(std::max(std::min(crowded, largest), kMinMarkerPixels));
  for (const SMarker& marker : scene.Markers) {
    const Eigen::Vector3f position(marker.Position.data());
    const float w = (m_viewProjection * position.homogeneous()).w();
    const float diameter = 2.0f * marker.Radius * m_pixelsPerUnit / m_target.GetScale();
    if (w > 0.0f && diameter < pixels * w) {
      SGlow disc;
      disc.Position = marker.Position;
      disc.Color = m_settings.Look.Marker;
      disc.Pixels = pixels;
      m_glows.push_back(disc);
    }
  }
}

void CRenderer::DrawGlows(const SScene& scene) {
  m_glows.clear();
  AddMarkers(scene);
  m_glows.insert(m_glows.end(), scene.Glows.begin(), scene.Glows.end());
  if (m_glows.empty()) {
    return;
  }
  const SLook& look = m_settings.Look;
  const Eigen::Vector3f toSunInView = m_view.block<3, 3>(0, 0) * m_toSun.cast<float>();
  m_gl.Enable(GL_BLEND);
  m_gl.DepthMask(GL_FALSE);
  m_glowProgram.Use();
  m_glowProgram.Set("uView", m_view);
  m_glowProgram.Set("uProjection", m_projection);
  m_glowProgram.Set("uPixelsPerUnit", m_pixelsPerUnit);
  m_glowProgram.Set("uPixelScale", static_cast<float>(m_target.GetScale()));
  m_glowProgram.Set("uToSunInView", toSunInView);
  m_glowProgram.Set("uHaloStrength", look.HaloStrength);
  m_glowProgram.Set("uHaloOpacity", look.HaloOpacity);
  m_glowProgram.Set("uSignalPixels",
                    kSignalPixels * std::max(m_settings.Height / 960.0f, 2.0f / kSignalPixels));
  m_glowInstances.Fill(m_glows);
  m_gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(m_glows.size()));
  m_gl.DepthMask(GL_TRUE);
  m_gl.Disable(GL_BLEND);
}

}  // namespace argos
