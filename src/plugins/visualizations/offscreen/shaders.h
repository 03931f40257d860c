#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_SHADERS_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_SHADERS_H

#include <string>

namespace argos {

/** The two texts of a shader program, without the preamble. */
struct SShaderSource {
  const char* Name;
  const char* Vertex;
  const char* Fragment;
  std::string Defines = ""; /**< inserted before the functions that shaders share */
};

/** What a part of the ground shows; software OpenGL pays for all that a shader contains. */
enum EGroundParts : unsigned {
  GROUND_HAS_FLOOR = 1,
  GROUND_HAS_GRID = 2,
  GROUND_HAS_BOUNDARY = 4,
  GROUND_HAS_SHADOWS = 8
};

/** The shader that draws these and nothing else. @param parts  bits of EGroundParts. */
SShaderSource MakeGroundShader(unsigned parts);

/** First line of every shader: the language version. */
extern const char* const kShaderVersion;
/** Functions that several shaders use. */
extern const char* const kShaderPreamble;

extern const SShaderSource kMeshShader; /**< lit solids, instanced */
extern const SShaderSource kDepthShader; /**< solids seen from the sun */
extern const SShaderSource kContactShadowShader; /**< SContactShadow, instanced */
extern const SShaderSource kGlowShader; /**< SGlow, instanced */
extern const SShaderSource kLineShader; /**< SLine, instanced */
extern const SShaderSource kFlatShader; /**< triangles of SFlatVertex */
extern const SShaderSource kTextShader; /**< SGlyphInstance, instanced */

}  // namespace argos

#endif
