#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_ANNOTATION_RENDERER_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_ANNOTATION_RENDERER_H

#include <argos3/plugins/simulator/visualizations/scene/camera.h>
#include <argos3/plugins/simulator/visualizations/offscreen/gl_program.h>
#include <argos3/plugins/simulator/visualizations/offscreen/glyph_atlas.h>
#include <argos3/plugins/simulator/visualizations/offscreen/instance_buffer.h>
#include <argos3/plugins/simulator/visualizations/scene/scene.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace argos {

class CRenderTarget;

/**
 * Draws the parts of a scene that no light changes: flat areas, text, and what lies over the
 * picture. Part of the renderer, in its context; makes its buffers when they are first used.
 */
class CAnnotationRenderer {
 public:
  explicit CAnnotationRenderer(const SGlFunctions& gl) : m_gl(gl) {}

  /** Flat areas in the world, with depth test; opaque ones hide what is drawn behind them later. */
  void DrawFlats(const SScene& scene, const Eigen::Matrix4f& view,
                 const Eigen::Matrix4f& projection);
  /**
   * Texts, then what lies over the picture.
   * @throws CARGoSException as CGlyphAtlas::Append().
   */
  void DrawInFront(const SScene& scene, const CCamera& camera, const CRenderTarget& target);

 private:
  struct SResources {
    explicit SResources(const SGlFunctions& gl);

    CGlProgram FlatProgram;
    CGlProgram TextProgram;
    CInstanceBuffer Flats;
    CInstanceBuffer Glyphs;
    GLuint AtlasTexture = 0;
    std::uint64_t AtlasVersion = 0;
  };

  SResources& GetResources();
  void DrawTriangles(const std::vector<SFlatVertex>& corners);
  void DrawLabels(const std::vector<SLabel>& labels, const CRenderTarget& target);
  void PlaceLabels(const SScene& scene, const CCamera& camera, const CRenderTarget& target);
  void UploadAtlas();

  const SGlFunctions& m_gl;
  std::optional<SResources> m_resources;  // empty: nothing was drawn yet
  CGlyphAtlas m_atlas;
  // data of the picture being drawn
  std::vector<SLabel> m_placed;  // texts in the world, in pixels, far to near
  std::vector<SGlyphInstance> m_glyphs;
};

}  // namespace argos

#endif
