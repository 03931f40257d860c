#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_RENDERER_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_RENDERER_H

#include <argos3/plugins/simulator/visualizations/offscreen/annotation_renderer.h>
#include <argos3/plugins/simulator/visualizations/scene/camera.h>
#include <argos3/plugins/simulator/visualizations/offscreen/gl_context.h>
#include <argos3/plugins/simulator/visualizations/offscreen/gl_program.h>
#include <argos3/plugins/simulator/visualizations/offscreen/ground_cells.h>
#include <argos3/plugins/simulator/visualizations/offscreen/instance_batches.h>
#include <argos3/plugins/simulator/visualizations/offscreen/instance_buffer.h>
#include <argos3/plugins/simulator/visualizations/scene/look.h>
#include <argos3/plugins/simulator/visualizations/offscreen/picture.h>
#include <argos3/plugins/simulator/visualizations/offscreen/render_target.h>
#include <argos3/plugins/simulator/visualizations/scene/scene.h>
#include <argos3/plugins/simulator/visualizations/offscreen/shadow_map.h>

#include <Eigen/Core>

#include <map>
#include <memory>

namespace argos {

/** Settings shared by all pictures of a renderer. */
struct SRenderSettings {
  int Width = 1280; /**< pixels, > 0 */
  int Height = 960; /**< pixels, > 0 */
  int Samples =
      4; /**< number per pixel: 1, 2, 4, 8 or 16; a number above the driver's limit is emulated */
  SLook Look = SLook::FromName("light");
  /** Direction to the sun, world frame, any length, above the horizon. */
  Eigen::Vector3d ToSun = Eigen::Vector3d(-0.42, -0.38, 0.95);
};

/**
 * Draws scenes into pictures, without a display.
 *
 * It depends on solids, lines and lights, but on no robot, entity or simulator. Each frame is a
 * pass for the shadow map, one for the ground and its decals, one for the solids (one draw call per
 * mesh and level of detail), one for translucent solids, and those for flat areas, lines, lights
 * and text. Buffers are reused for the next frame.
 *
 * One renderer belongs to one thread at a time.
 */
class CRenderer {
 public:
  /** @throws CARGoSException if no OpenGL context can be made, or the picture is too large. */
  explicit CRenderer(const SRenderSettings& settings);

  /**
   * Draws a scene.
   * @param picture  receives the result; its memory is reused.
   * @throws CARGoSException if the driver reports an error, e.g. that it ran out of memory.
   */
  void Render(const SScene& scene, const SCameraPlacement& placement, SPicture& picture);

  const SRenderSettings& GetSettings() const { return m_settings; }
  /** Describes context, driver and OpenGL version for the log. */
  std::string DescribeDriver() const;

 private:
  // place of a mesh's levels of detail in the shared buffers
  struct SMeshRange {
    GLsizei NumIndices = 0;
    size_t FirstIndex = 0;
  };

  /** Returns the vertex array. */
  GLuint CreateMeshes();
  void DescribeInstances();
  void UploadFloor(const SFloorImage& floor);

  void DrawShadowMap();
  void DrawGround(const SScene& scene);
  // parts: bits of EGroundParts
  void DrawGroundAreas(const SScene& scene, unsigned parts, const std::vector<TGroundArea>& areas);
  void DrawContactShadows(const SScene& scene);
  void DrawMeshes();
  void DrawTranslucentMeshes(const CGlProgram& program);
  void DrawLines(const SScene& scene);
  void AddMarkers(const SScene& scene);
  void DrawGlows(const SScene& scene);
  void DrawBatches(const CInstanceBatches::TBatches& batches, const CGlProgram& program);
  void DrawInstances(EMeshKind kind, size_t level, const SMeshInstance* instances, size_t count);
  void SetLighting(const CGlProgram& program) const;
  void ComputeMatrices(const SScene& scene, const CCamera& camera);

  SRenderSettings m_settings;
  std::unique_ptr<CGlContext> m_context;
  const SGlFunctions& m_gl;
  CRenderTarget m_target;
  CShadowMap m_shadowMap;
  CGlProgram m_meshProgram;
  CGlProgram m_depthProgram;
  std::map<unsigned, CGlProgram> m_groundPrograms;  // keys are bits of EGroundParts
  CGlProgram m_contactProgram;
  CGlProgram m_glowProgram;
  CGlProgram m_lineProgram;
  CInstanceBatches m_batches;
  CGroundCells m_groundCells;

  CAnnotationRenderer m_annotations;

  std::array<std::array<SMeshRange, kNumLevels>, kNumMeshKinds> m_meshes;
  GLuint m_meshArray;
  CInstanceBuffer m_meshInstances;
  CInstanceBuffer m_groundInstances;
  CInstanceBuffer m_contactInstances;
  CInstanceBuffer m_glowInstances;
  CInstanceBuffer m_lineInstances;
  std::vector<SGlow> m_glows;  // the scene's, and the discs of robots too small to be seen
  GLuint m_floorTexture = 0;
  std::uint64_t m_floorVersion = 0;
  bool m_hasFloor = false;

  // data of the frame being drawn; float is enough once the matrices are multiplied in double
  Eigen::Vector3d m_toSun;
  Eigen::Vector4f m_eye;  // w = 1: the eye; w = 0: direction to it, orthographic
  Eigen::Matrix4f m_view;
  Eigen::Matrix4f m_projection;
  Eigen::Matrix4f m_viewProjection;
  float m_near = 0.1f;
  float m_pixelsPerUnit = 1.0f;  // drawn pixels per m at w = 1 in clip space
  double m_groundReach = 1.0;  // width of the ground around the arena, m
};

}  // namespace argos

#endif
