#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_SHADERS_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_SHADERS_H

namespace argos {

/** The two texts of a shader program, without the preamble. */
struct SShaderSource {
  const char* Name;
  const char* Vertex;
  const char* Fragment;
  const char* Defines = ""; /**< inserted before the functions that shaders share */
};

/** First line of every shader: the language version. */
extern const char* const kShaderVersion;
/** Functions that several shaders use. */
extern const char* const kShaderPreamble;

extern const SShaderSource kMeshShader; /**< lit solids, instanced */
extern const SShaderSource kDepthShader; /**< solids seen from the sun */
extern const SShaderSource kGroundShader; /**< floor, grid, boundary, with shadows */
extern const SShaderSource kLitGroundShader; /**< the same without shadows */
extern const SShaderSource kContactShadowShader; /**< SContactShadow, instanced */
extern const SShaderSource kGlowShader; /**< SGlow, instanced */
extern const SShaderSource kLineShader; /**< SLine, instanced */
extern const SShaderSource kFlatShader; /**< triangles of SFlatVertex */
extern const SShaderSource kTextShader; /**< SGlyphInstance, instanced */

}  // namespace argos

#endif
