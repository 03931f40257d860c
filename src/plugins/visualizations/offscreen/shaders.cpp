#include <argos3/plugins/simulator/visualizations/offscreen/shaders.h>

#include <utility>

namespace argos {

// All colours in the shaders are linear light; the framebuffer encodes them as sRGB when it stores
// them. Inputs that come from image files are decoded with FromSrgb() or by the texture unit.
const char* const kShaderVersion = "#version 330 core\n";

const char* const kShaderPreamble = R"glsl(
vec3 FromSrgb(vec3 c) {
  return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}

// Share of the sun that reaches a point: percentage-closer filtering, 2 x 2 bilinear lookups 1.5
// texels apart, which together cover 3.5 x 3.5 texels.
// Reeves, Salesin, Cook, Rendering Antialiased Shadows with Depth Maps (SIGGRAPH 1987).
float SunShare(sampler2DShadow map, vec3 coordinates, float texel) {
  if (any(lessThan(coordinates.xy, vec2(0.0))) || any(greaterThan(coordinates.xy, vec2(1.0)))) {
    return 1.0;
  }
  // points behind all casters have them all in front; an empty texel is at depth 1
  float depth = min(coordinates.z, 0.9999);
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    vec2 offset = vec2(i & 1, i >> 1) * 1.5 - 0.75;
    sum += texture(map, vec3(coordinates.xy + offset * texel, depth));
  }
  return 0.25 * sum;
}
)glsl";

namespace {

// the parameter of cylinders and rings, see EMeshKind; kinds are numbered as there
constexpr const char* kMeshVertexText = R"glsl(
layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec2 inEdge;
layout(location = 3) in vec4 inRow0;
layout(location = 4) in vec4 inRow1;
layout(location = 5) in vec4 inRow2;
layout(location = 6) in vec4 inColor;
layout(location = 7) in float inParam;

uniform mat4 uViewProjection;
uniform int uKind;

out vec3 vPosition;
out vec3 vNormal;
out vec2 vEdge;
flat out vec4 vColor;

void main() {
  vec3 position = inPosition;
  vec3 normal = inNormal;
  if (uKind == 1) {
    position.xy *= mix(1.0, inParam, position.z);
    if (abs(normal.z) < 0.5) {
      normal.z = 0.5 * (1.0 - inParam);
    }
  } else if (uKind == 3) {
    position = position * (1.0 - inParam) + 0.5 * inParam * normal;
  }
  vPosition = vec3(dot(inRow0, vec4(position, 1.0)), dot(inRow1, vec4(position, 1.0)),
                   dot(inRow2, vec4(position, 1.0)));
  // normals scale inversely to the solid, along its own axes
  vec3 scale2 = inRow0.xyz * inRow0.xyz + inRow1.xyz * inRow1.xyz + inRow2.xyz * inRow2.xyz;
  normal /= max(scale2, vec3(1e-20));
  vNormal = vec3(dot(inRow0.xyz, normal), dot(inRow1.xyz, normal), dot(inRow2.xyz, normal));
  vEdge = inEdge;
  vColor = vec4(FromSrgb(inColor.rgb), inColor.a);
  gl_Position = uViewProjection * vec4(vPosition, 1.0);
}
)glsl";

constexpr const char* kMeshFragmentText = R"glsl(
in vec3 vPosition;
in vec3 vNormal;
in vec2 vEdge;
flat in vec4 vColor;

uniform vec4 uEye;  // w = 1: the eye; w = 0: the direction to it
uniform vec3 uToSun;
uniform float uSunIntensity;
uniform vec4 uSkyLight;
uniform vec4 uBounceLight;
uniform float uAmbientIntensity;
uniform float uSpecularIntensity;
uniform float uEdgeDarkening;
uniform float uLeastAlpha;  // 1 while opaque solids are drawn
uniform float uPixelScale;
uniform mat4 uWorldToShadow;
uniform float uShadowTexel;
uniform float uShadowOffset;
uniform sampler2DShadow uShadowMap;

layout(location = 0) out vec4 outColor;

float Square(float x) {
  return x * x;
}

void main() {
  vec3 normal = normalize(vNormal);
  vec3 toEye = normalize(uEye.xyz - uEye.w * vPosition);
  float cosSun = dot(normal, uToSun);
  float sun = 0.0;
  if (cosSun > 0.0) {
    // moving the point off the surface by about a texel keeps a face from shadowing itself
    vec4 inShadow = uWorldToShadow * vec4(vPosition + normal * uShadowOffset, 1.0);
    sun = SunShare(uShadowMap, inShadow.xyz, uShadowTexel) * smoothstep(0.0, 0.15, cosSun);
  }
  vec3 ambient =
      mix(uBounceLight.rgb, uSkyLight.rgb, 0.5 + 0.5 * normal.z) * uAmbientIntensity;
  vec3 light = ambient + vec3(uSunIntensity * max(cosSun, 0.0) * sun);

  // Blinn-Phong highlight with Schlick's Fresnel factor
  vec3 halfway = normalize(toEye + uToSun);
  float grazing = 1.0 - max(dot(toEye, halfway), 0.0);
  float fresnel = 0.3 + 0.7 * Square(Square(grazing)) * grazing;
  float gloss = Square(Square(Square(Square(max(dot(normal, halfway), 0.0)))));
  float highlight = gloss * gloss * gloss * sun * fresnel;  // to the power of 48
  float rim = Square(Square(1.0 - max(dot(normal, toEye), 0.0))) * 0.12;

  vec2 toEdge = min(vEdge, 1.0 - vEdge) / max(fwidth(vEdge), vec2(1e-6)) / uPixelScale;
  // an edge line is drawn only where the face is large enough to bear it
  vec2 extent = 1.0 / max(fwidth(vEdge), vec2(1e-6)) / uPixelScale;
  vec2 lines = (1.0 - smoothstep(0.5, 1.4, toEdge)) * smoothstep(4.0, 16.0, extent);
  float edge = max(lines.x, lines.y) * uEdgeDarkening;

  vec3 color = vColor.rgb * light * (1.0 - edge);
  color += vec3(uSpecularIntensity * (highlight + rim * (0.5 + 0.5 * normal.z)));
  float alpha = max(vColor.a, uLeastAlpha);
  outColor = vec4(color * alpha, alpha);
}
)glsl";

constexpr const char* kDepthFragmentText = R"glsl(
void main() {}
)glsl";

constexpr const char* kGroundVertexText = R"glsl(
layout(location = 0) in vec4 inArea;

uniform mat4 uViewProjection;
uniform vec2 uMin;
uniform vec2 uMax;
uniform float uNumCells;

out vec2 vPosition;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vPosition = mix(uMin, uMax, mix(inArea.xy, inArea.zw, corner) / uNumCells);
  gl_Position = uViewProjection * vec4(vPosition, 0.0, 1.0);
}
)glsl";

constexpr const char* kGroundFragmentText = R"glsl(
in vec2 vPosition;

uniform vec2 uArenaMin;
uniform vec2 uArenaMax;
uniform float uFadeLength;
uniform vec4 uBackground;
uniform vec4 uGround;
uniform vec4 uGroundOutside;
uniform vec4 uGridLine;
uniform vec4 uBoundary;
uniform vec2 uFloorSize;
uniform vec2 uFloorExtent;
uniform int uIsFloorSmooth;
uniform sampler2D uFloor;
uniform vec3 uToSun;
uniform float uSunIntensity;
uniform vec4 uSkyLight;
uniform float uAmbientIntensity;
uniform float uPixelScale;
uniform mat4 uWorldToShadow;
uniform float uShadowTexel;
uniform sampler2DShadow uShadowMap;

layout(location = 0) out vec4 outColor;

// coverage of a pixel by lines a given distance apart; they fade out as they crowd together
float GridCoverage(vec2 pixel, float spacing) {
  vec2 phase = vPosition / spacing;
  vec2 toLine = abs(fract(phase - 0.5) - 0.5) * spacing / pixel;
  vec2 apart = spacing / pixel;
  vec2 strength = smoothstep(8.0, 90.0, apart) * 0.62;
  vec2 lines = (1.0 - smoothstep(0.15, 1.05, toLine)) * strength;
  return max(lines.x, lines.y);
}

// pixels of an image file stay sharp squares, but their borders are antialiased
vec3 FloorColor(vec2 share) {
  vec2 position = share * uFloorSize;
  vec2 footprint = max(fwidth(position), vec2(1e-6));
  vec2 seam = floor(position + 0.5);
  vec2 sharp = seam + clamp((position - seam) / footprint, -0.5, 0.5);
  vec2 coordinates =
      (uIsFloorSmooth != 0 ? position : mix(sharp, position, step(1.0, footprint))) / uFloorSize;
  return textureGrad(uFloor, coordinates, dFdx(share), dFdy(share)).rgb;
}

// a line's colour, or its counterpart where the ground is as dark or as light as the line
vec3 Contrasting(vec3 line, vec3 ground) {
  const vec3 kLuminance = vec3(0.2126, 0.7152, 0.0722);
  float own = dot(line, kLuminance);
  float other = dot(ground, kLuminance);
  float ratio = (max(own, other) + 0.05) / (min(own, other) + 0.05);
  vec3 counterpart = other > 0.18 ? line * 0.35 : mix(line, vec3(0.6), 0.8);
  return mix(counterpart, line, smoothstep(1.3, 1.9, ratio));
}

void main() {
  vec2 pixel = max(fwidth(vPosition), vec2(1e-7)) * uPixelScale;
  vec2 beyond = max(max(uArenaMin - vPosition, vPosition - uArenaMax), vec2(0.0));
  float outside = length(beyond);
  vec2 inward = min(vPosition - uArenaMin, uArenaMax - vPosition) / pixel;
  float inArena = clamp(min(inward.x, inward.y) + 0.5, 0.0, 1.0);

#ifdef HAS_FLOOR
  vec3 base = FloorColor((vPosition - uArenaMin) / uFloorExtent);
  float gridVisibility = 0.6;
#else
  vec3 base = uGround.rgb;
  float gridVisibility = 1.0;
#endif
  base = mix(uGroundOutside.rgb, base, inArena);
#ifdef HAS_GRID
  float grid = max(max(GridCoverage(pixel, 0.1), GridCoverage(pixel, 1.0)),
                   GridCoverage(pixel, 10.0));
  float visibility = mix(0.55, gridVisibility, inArena);
  base = mix(base, Contrasting(uGridLine.rgb, base), grid * visibility);
#endif
#ifdef HAS_BOUNDARY
  vec2 toSide = min(abs(vPosition - uArenaMin), abs(vPosition - uArenaMax)) / pixel;
  vec2 along = step(beyond.yx, pixel.yx);
  vec2 lines = (1.0 - smoothstep(0.5, 1.5, toSide)) * along;
  base = mix(base, Contrasting(uBoundary.rgb, base), max(lines.x, lines.y));
#endif

  // full light leaves the ground's colours as they were chosen
  vec3 color = base;
#ifdef HAS_SHADOWS
  vec4 inShadow = uWorldToShadow * vec4(vPosition, 0.0, 1.0);
  float sun = SunShare(uShadowMap, inShadow.xyz, uShadowTexel);
  vec3 lit = uSunIntensity * uToSun.z + uSkyLight.rgb * uAmbientIntensity;
  vec3 light = uSunIntensity * uToSun.z * sun + uSkyLight.rgb * uAmbientIntensity;
  color *= light / lit;
#endif
  float fade = smoothstep(0.0, 1.0, outside / uFadeLength);
  outColor = vec4(mix(color, uBackground.rgb, fade), 1.0);
}
)glsl";

constexpr const char* kContactShadowVertexText = R"glsl(
layout(location = 0) in vec2 inCenter;
layout(location = 1) in vec2 inAxisX;
layout(location = 2) in vec2 inHalfExtent;
layout(location = 3) in vec2 inShape;

uniform mat4 uViewProjection;

out vec2 vOffset;
flat out vec2 vHalfExtent;
flat out vec2 vShape;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vOffset = corner * (inHalfExtent + inShape.y);
  vHalfExtent = inHalfExtent;
  vShape = inShape;
  vec2 world = inCenter + inAxisX * vOffset.x + vec2(-inAxisX.y, inAxisX.x) * vOffset.y;
  gl_Position = uViewProjection * vec4(world, 0.0, 1.0);
}
)glsl";

constexpr const char* kContactShadowFragmentText = R"glsl(
in vec2 vOffset;
flat in vec2 vHalfExtent;
flat in vec2 vShape;

uniform float uContactDarkening;

layout(location = 0) out vec4 outColor;

void main() {
  vec2 toCorner = abs(vOffset) - vHalfExtent + vShape.x;
  float distance = length(max(toCorner, 0.0)) + min(max(toCorner.x, toCorner.y), 0.0) - vShape.x;
  float share = 1.0 - clamp(distance / max(vShape.y, 1e-6), 0.0, 1.0);
  outColor = vec4(0.0, 0.0, 0.0, uContactDarkening * share * share);
}
)glsl";

constexpr const char* kGlowVertexText = R"glsl(
layout(location = 0) in vec3 inPosition;
layout(location = 1) in float inRadius;
layout(location = 2) in vec4 inColor;
layout(location = 3) in float inHaloScale;
layout(location = 4) in float inPixels;
layout(location = 5) in float inIsSignal;

uniform mat4 uView;
uniform mat4 uProjection;
uniform float uPixelsPerUnit;  // pixels per m at w = 1 in clip space
uniform float uSignalPixels;
uniform float uPixelScale;

out vec2 vOffset;
flat out vec4 vColor;
flat out float vHalo;
flat out float vPixels;
flat out int vIsLit;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec4 center = uView * vec4(inPosition, 1.0);
  float depth = max(-center.z, 1e-4);
  // w is the depth in perspective, and 1 in orthographic projection
  float w = max((uProjection * center).w, 1e-4);
  float truePixels = inPixels > 0.0 ? 0.5 * inPixels * uPixelScale
                                    : inRadius * uPixelsPerUnit / w;
  float least = inIsSignal > 0.0 ? 0.5 * uSignalPixels : 1.2;
  float pixels = max(truePixels, least * uPixelScale);
  float radius = pixels * w / uPixelsPerUnit;
  float haloPixels = inIsSignal > 0.0 ? pixels : truePixels;
  vHalo = inHaloScale > 0.0 ? max(inHaloScale * haloPixels / pixels, 1.001) : 0.0;
  float reach = max(vHalo, 1.0) + 0.7 / pixels;
  vOffset = corner * reach;
  // discs smaller than a pixel fade, but less than their area says: a swarm's colours stay visible
  float cover = inIsSignal > 0.0 ? 1.0 : min(truePixels / pixels, 1.0);
  vColor = vec4(FromSrgb(inColor.rgb), inColor.a * cover);
  vPixels = pixels;
  vIsLit = inPixels > 0.0 ? 0 : 1;
  gl_Position = uProjection * (center + vec4(vOffset * radius, 0.0, 0.0));
  // the disc stands for a ball: its depth is that of the ball's nearest point
  float nearest = inPixels > 0.0 ? 0.997 * depth : max(depth - 1.3 * inRadius, 0.5 * depth);
  vec4 front = uProjection * vec4(0.0, 0.0, -nearest, 1.0);
  gl_Position.z = front.z / front.w * gl_Position.w;
}
)glsl";

constexpr const char* kGlowFragmentText = R"glsl(
in vec2 vOffset;
flat in vec4 vColor;
flat in float vHalo;
flat in float vPixels;
flat in int vIsLit;

uniform vec3 uToSunInView;
uniform float uHaloStrength;
uniform float uHaloOpacity;

layout(location = 0) out vec4 outColor;

void main() {
  float distance = length(vOffset);
  float disc = clamp((1.0 - distance) * vPixels + 0.5, 0.0, 1.0);
  vec3 color = vColor.rgb;
  float halo = 0.0;
  if (vHalo > 0.0) {
    // lit: brightest in the middle, where its wall is seen head-on
    color = mix(color, vec3(1.0), 0.45 * pow(max(1.0 - distance, 0.0), 1.5));
    float share = clamp((distance - 1.0) / max(vHalo - 1.0, 1e-3), 0.0, 1.0);
    halo = uHaloStrength * pow(1.0 - share, 2.5) * (1.0 - disc) * vColor.a;
  } else if (vIsLit != 0) {
    vec3 normal = vec3(vOffset, sqrt(max(1.0 - distance * distance, 0.0)));
    color *= 0.45 + 0.75 * max(dot(normal, uToSunInView), 0.0);
  }
  float alpha = vColor.a * disc + halo * uHaloOpacity;
  outColor = vec4(color * vColor.a * disc + vColor.rgb * halo, alpha);
}
)glsl";

constexpr const char* kLineVertexText = R"glsl(
layout(location = 0) in vec3 inStart;
layout(location = 1) in vec3 inEnd;
layout(location = 2) in vec4 inColor;
layout(location = 3) in float inWidth;

uniform mat4 uView;
uniform mat4 uProjection;
uniform float uNear;
uniform vec2 uPictureSize;
uniform float uPixelScale;

flat out vec4 vColor;
flat out float vHalfWidth;
out float vAcross;

void main() {
  vec3 start = (uView * vec4(inStart, 1.0)).xyz;
  vec3 end = (uView * vec4(inEnd, 1.0)).xyz;
  // the part behind the eye has no place on the picture
  if (start.z > -uNear && end.z < -uNear) {
    start = mix(start, end, (start.z + uNear) / (start.z - end.z));
  } else if (end.z > -uNear && start.z < -uNear) {
    end = mix(end, start, (end.z + uNear) / (end.z - start.z));
  }
  vec4 clipStart = uProjection * vec4(start, 1.0);
  vec4 clipEnd = uProjection * vec4(end, 1.0);
  vec2 direction =
      (clipEnd.xy / clipEnd.w - clipStart.xy / clipStart.w) * uPictureSize;
  float pixels = length(direction);
  direction = pixels > 1e-4 ? direction / pixels : vec2(1.0, 0.0);
  vec2 across = vec2(-direction.y, direction.x);
  float side = float(gl_VertexID & 1) * 2.0 - 1.0;
  vec4 clip = (gl_VertexID >> 1) == 0 ? clipStart : clipEnd;
  vHalfWidth = 0.5 * inWidth * uPixelScale;
  vAcross = side * (vHalfWidth + 0.5);
  clip.xy += across * vAcross * 2.0 / uPictureSize * clip.w;
  // a line that lies on a surface is in front of it
  vec4 nearer = uProjection * vec4(0.997 * ((gl_VertexID >> 1) == 0 ? start : end), 1.0);
  clip.z = nearer.z / nearer.w * clip.w;
  gl_Position = clip;
  vColor = vec4(FromSrgb(inColor.rgb), inColor.a);
}
)glsl";

constexpr const char* kLineFragmentText = R"glsl(
flat in vec4 vColor;
flat in float vHalfWidth;
in float vAcross;

layout(location = 0) out vec4 outColor;

void main() {
  float alpha = vColor.a * clamp(vHalfWidth + 0.5 - abs(vAcross), 0.0, 1.0);
  outColor = vec4(vColor.rgb * alpha, alpha);
}
)glsl";

constexpr const char* kFlatVertexText = R"glsl(
layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec4 inColor;
layout(location = 2) in float inNearer;

uniform mat4 uView;
uniform mat4 uProjection;

out vec4 vColor;

void main() {
  vec4 inCamera = uView * vec4(inPosition, 1.0);
  gl_Position = uProjection * inCamera;
  vec4 nearer = uProjection * vec4((1.0 - inNearer) * inCamera.xyz, 1.0);
  gl_Position.z = nearer.z / nearer.w * gl_Position.w;
  vColor = vec4(FromSrgb(inColor.rgb), inColor.a);
}
)glsl";

constexpr const char* kFlatFragmentText = R"glsl(
in vec4 vColor;

layout(location = 0) out vec4 outColor;

void main() {
  outColor = vec4(vColor.rgb * vColor.a, vColor.a);
}
)glsl";

constexpr const char* kTextVertexText = R"glsl(
layout(location = 0) in vec4 inArea;
layout(location = 1) in vec2 inTexel;
layout(location = 2) in vec4 inColor;

uniform vec2 uPictureSize;

out vec2 vTexel;
flat out vec4 vColor;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vec2 position = (inArea.xy + corner * inArea.zw) / uPictureSize;
  vTexel = inTexel + corner * inArea.zw;
  vColor = vec4(FromSrgb(inColor.rgb), inColor.a);
  gl_Position = vec4(2.0 * position.x - 1.0, 1.0 - 2.0 * position.y, 0.0, 1.0);
}
)glsl";

constexpr const char* kTextFragmentText = R"glsl(
in vec2 vTexel;
flat in vec4 vColor;

uniform sampler2D uAtlas;

layout(location = 0) out vec4 outColor;

void main() {
  float alpha = vColor.a * texelFetch(uAtlas, ivec2(vTexel), 0).r;
  outColor = vec4(vColor.rgb * alpha, alpha);
}
)glsl";

}  // namespace

const SShaderSource kMeshShader = {"mesh", kMeshVertexText, kMeshFragmentText};
const SShaderSource kDepthShader = {"depth", kMeshVertexText, kDepthFragmentText};
const SShaderSource kContactShadowShader = {"contact shadow", kContactShadowVertexText,
                                            kContactShadowFragmentText};
const SShaderSource kGlowShader = {"glow", kGlowVertexText, kGlowFragmentText};
const SShaderSource kLineShader = {"line", kLineVertexText, kLineFragmentText};
const SShaderSource kFlatShader = {"flat", kFlatVertexText, kFlatFragmentText};
const SShaderSource kTextShader = {"text", kTextVertexText, kTextFragmentText};

SShaderSource MakeGroundShader(unsigned parts) {
  SShaderSource source = {"ground", kGroundVertexText, kGroundFragmentText};
  const std::pair<EGroundParts, const char*> names[] = {{GROUND_HAS_FLOOR, "HAS_FLOOR"},
                                                        {GROUND_HAS_GRID, "HAS_GRID"},
                                                        {GROUND_HAS_BOUNDARY, "HAS_BOUNDARY"},
                                                        {GROUND_HAS_SHADOWS, "HAS_SHADOWS"}};
  for (const auto& [part, name] : names) {
    if ((parts & part) != 0) {
      source.Defines += std::string("#define ") + name + '\n';
    }
  }
  return source;
}

}  // namespace argos
