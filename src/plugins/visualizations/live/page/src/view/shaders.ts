// The shaders, those of the off-screen view with poses from textures. Colours are linear light until
// the last line of a fragment shader; alpha is premultiplied.

const kCommon = /* glsl */ `
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;
precision highp sampler2DShadow;
vec3 FromSrgb(vec3 c) {
  return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}
vec3 ToSrgb(vec3 c) {
  // sums of roots, which are cheaper than powers and off by less than a grey level
  c = clamp(c, 0.0, 1.0);
  vec3 root = sqrt(c);
  vec3 root4 = sqrt(root);
  return max(0.662002687 * root + 0.68412206 * root4 - 0.323583601 * sqrt(root4) - 0.022541147 * c, 0.0);
}
vec3 Turn(vec4 q, vec3 v) {
  vec3 t = 2.0 * cross(q.xyz, v);
  return v + q.w * t + cross(q.xyz, t);
}
`;

// poses: two texels each, position and quaternion; blended from the last state to this one
const kPoses = /* glsl */ `
uniform sampler2D uFrom;
uniform sampler2D uTo;
uniform usampler2D uWords;
uniform float uBlend;
const uint kNone = 0xffffffffu;
void ReadPose(uint number, out vec3 position, out vec4 turn) {
  if (number == kNone) {
    position = vec3(0.0);
    turn = vec4(0.0, 0.0, 0.0, 1.0);
    return;
  }
  ivec2 place = ivec2(int(number & 511u) * 2, int(number >> 9));
  position = texelFetch(uTo, place, 0).xyz;
  turn = texelFetch(uTo, place + ivec2(1, 0), 0);
  if (uBlend < 1.0) {
    vec4 before = texelFetch(uFrom, place + ivec2(1, 0), 0);
    position = mix(texelFetch(uFrom, place, 0).xyz, position, uBlend);
    turn = normalize(mix(dot(before, turn) < 0.0 ? -before : before, turn, uBlend));
  }
}
uint ReadWord(uint number) {
  if (number == kNone) {
    return 0u;
  }
  return texelFetch(uWords, ivec2(int(number & 1023u), int(number >> 10)), 0).r;
}
vec4 ColorOfWord(uint word) {
  return vec4(float(word & 255u), float((word >> 8) & 255u), float((word >> 16) & 255u),
              float(word >> 24)) / 255.0;
}
// robots in quarantine keep differences of brightness, but no colour
vec4 Paled(vec4 color, uint flags) {
  if ((flags & 1u) == 0u) {
    return color;
  }
  return vec4(vec3(160.0 / 255.0 + (color.r + color.g + color.b) / 12.0), color.a);
}
`;

const kShadow = /* glsl */ `
uniform mat4 uWorldToShadow;
uniform float uShadowTexel;
uniform sampler2DShadow uShadowMap;
float SunShare(vec3 coordinates) {
  if (any(lessThan(coordinates.xy, vec2(0.0))) || any(greaterThan(coordinates.xy, vec2(1.0)))) {
    return 1.0;
  }
  float depth = min(coordinates.z, 0.9999);
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    vec2 offset = vec2(i & 1, i >> 1) * 1.5 - 0.75;
    sum += texture(uShadowMap, vec3(coordinates.xy + offset * uShadowTexel, depth));
  }
  return 0.25 * sum;
}
`;

export const kSolidVertex = /* glsl */ `${kCommon}${kPoses}
in vec3 position;
in vec3 normal;
in vec2 edge;
in uvec2 inPlace;
in vec3 inOffset;
in vec4 inTurn;
in vec3 inSize;
in vec4 inColor;
in vec2 inShape;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform float uPixelsPerUnit;
out vec3 vPosition;
out vec3 vNormal;
out vec2 vEdge;
flat out vec4 vColor;
void main() {
  vec3 local = position;
  vec3 up = normal;
  float param = inShape.x;
#if KIND == 1
  local.xy *= mix(1.0, param, local.z);
  if (abs(up.z) < 0.5) {
    up.z = 0.5 * (1.0 - param);
  }
#elif KIND == 3
  local = local * (1.0 - param) + 0.5 * param * up;
#endif
  vec3 origin;
  vec4 turn;
  ReadPose(inPlace.x, origin, turn);
  vPosition = origin + Turn(turn, inOffset + Turn(inTurn, local * inSize));
  vNormal = Turn(turn, Turn(inTurn, up / max(inSize, vec3(1e-9))));
  vEdge = edge;
  vec4 color = Paled(inColor, ReadWord(inPlace.y));
  vColor = vec4(FromSrgb(color.rgb), color.a);
  gl_Position = projectionMatrix * (viewMatrix * vec4(vPosition, 1.0));
  // details that would cover a few pixels are left out
  if (inShape.y > 0.0 && length(inSize) * uPixelsPerUnit < 3.5 * gl_Position.w) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  }
}
`;

/** All far entities in one mesh: vertices know their entity. */
export const kMergedVertex = /* glsl */ `${kCommon}${kPoses}
in vec3 position;
in vec3 normal;
in uvec3 inPlace;
in vec4 inColor;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform usampler2D uIsNear;
out vec3 vPosition;
out vec3 vNormal;
out vec2 vEdge;
flat out vec4 vColor;
void main() {
  uint number = inPlace.z;
  if (texelFetch(uIsNear, ivec2(int(number & 1023u), int(number >> 10)), 0).r != 0u) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  vec3 origin;
  vec4 turn;
  ReadPose(inPlace.x, origin, turn);
  vPosition = origin + Turn(turn, position);
  vNormal = Turn(turn, normal);
  vEdge = vec2(0.5);
  vec4 color = Paled(inColor, ReadWord(inPlace.y));
  vColor = vec4(FromSrgb(color.rgb), color.a);
  gl_Position = projectionMatrix * (viewMatrix * vec4(vPosition, 1.0));
}
`;

/** Of merged meshes where the processor draws: light comes with the vertices. */
export const kPlainFragment = /* glsl */ `${kCommon}
in vec3 vPosition;
in vec3 vNormal;
in vec2 vEdge;
flat in vec4 vColor;
uniform vec3 uToSun;
uniform float uSunIntensity;
uniform vec3 uSkyLight;
uniform vec3 uBounceLight;
uniform float uAmbientIntensity;
out vec4 outColor;
void main() {
  vec3 up = normalize(vNormal);
  vec3 light = mix(uBounceLight, uSkyLight, 0.5 + 0.5 * up.z) * uAmbientIntensity +
               uSunIntensity * max(dot(up, uToSun), 0.0);
  outColor = vec4(ToSrgb(vColor.rgb * light), 1.0);
}
`;

export const kSolidFragment = /* glsl */ `${kCommon}
in vec3 vPosition;
in vec3 vNormal;
in vec2 vEdge;
flat in vec4 vColor;
uniform vec4 uEye;
uniform vec3 uToSun;
uniform float uSunIntensity;
uniform vec3 uSkyLight;
uniform vec3 uBounceLight;
uniform float uAmbientIntensity;
uniform float uSpecularIntensity;
uniform float uEdgeDarkening;
uniform float uPixelScale;
#ifdef HAS_SHADOWS
uniform float uShadowOffset;
${kShadow}
#endif
out vec4 outColor;
float Square(float x) {
  return x * x;
}
void main() {
  vec3 up = normalize(vNormal);
  vec3 toEye = normalize(uEye.xyz - uEye.w * vPosition);
  float cosSun = dot(up, uToSun);
  float sun = 0.0;
  if (cosSun > 0.0) {
    sun = smoothstep(0.0, 0.15, cosSun);
#ifdef HAS_SHADOWS
    vec4 inShadow = uWorldToShadow * vec4(vPosition + up * uShadowOffset, 1.0);
    sun *= SunShare(inShadow.xyz);
#endif
  }
  vec3 ambient = mix(uBounceLight, uSkyLight, 0.5 + 0.5 * up.z) * uAmbientIntensity;
  vec3 light = ambient + vec3(uSunIntensity * max(cosSun, 0.0) * sun);
  vec3 halfway = normalize(toEye + uToSun);
  float grazing = 1.0 - max(dot(toEye, halfway), 0.0);
  float fresnel = 0.3 + 0.7 * Square(Square(grazing)) * grazing;
  float gloss = Square(Square(Square(Square(max(dot(up, halfway), 0.0)))));
  float highlight = gloss * gloss * gloss * sun * fresnel;
  float rim = Square(Square(1.0 - max(dot(up, toEye), 0.0))) * 0.12;
  vec2 width = max(fwidth(vEdge), vec2(1e-6));
  vec2 toEdge = min(vEdge, 1.0 - vEdge) / width / uPixelScale;
  vec2 extent = 1.0 / width / uPixelScale;
  vec2 lines = (1.0 - smoothstep(0.5, 1.4, toEdge)) * smoothstep(4.0, 16.0, extent);
  float edge = max(lines.x, lines.y) * uEdgeDarkening;
  vec3 color = vColor.rgb * light * (1.0 - edge);
  color += vec3(uSpecularIntensity * (highlight + rim * (0.5 + 0.5 * up.z)));
  outColor = vec4(ToSrgb(color) * vColor.a, vColor.a);
}
`;

export const kDepthFragment = /* glsl */ `
precision highp float;
out vec4 outColor;
void main() {
  outColor = vec4(1.0);
}
`;

/** Robots that would be smaller than a few pixels: discs of the colour of markers, in sRGB. */
export const kPointVertex = /* glsl */ `${kCommon}${kPoses}
in vec3 position;
in uvec2 inPlace;
in float inRadius;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform float uPixelsPerUnit;
uniform float uPixelScale;
uniform vec3 uMarker;
flat out vec4 vColor;
void main() {
  vec3 origin;
  vec4 turn;
  ReadPose(inPlace.x, origin, turn);
  gl_Position = projectionMatrix * (viewMatrix * vec4(origin + position, 1.0));
  gl_PointSize = max(2.0 * inRadius * uPixelsPerUnit / gl_Position.w, 3.0 * uPixelScale);
  vColor = Paled(vec4(uMarker, 1.0), ReadWord(inPlace.y));
}
`;

export const kPointFragment = /* glsl */ `${kCommon}
flat in vec4 vColor;
out vec4 outColor;
void main() {
  vec2 offset = 2.0 * gl_PointCoord - 1.0;
  if (dot(offset, offset) > 1.0) {
    discard;
  }
  outColor = vec4(vColor.rgb, 1.0);
}
`;

// see point_picture.ts
export const kPointPictureVertex = /* glsl */ `${kCommon}
in vec3 position;
void main() {
  gl_Position = vec4(2.0 * position.xy - 1.0, 0.0, 1.0);
}
`;

export const kPointPictureFragment = /* glsl */ `${kCommon}${kPoses}
uniform usampler2D uPicture;
uniform float uStep;
uniform mat4 projectionMatrix;
uniform vec3 uMarker;
out vec4 outColor;
void main() {
  uint pixel = texelFetch(uPicture, ivec2(gl_FragCoord.xy), 0).r;
  if (pixel == 0u) {
    discard;
  }
  vec4 place = projectionMatrix * vec4(0.0, 0.0, -uStep * float(pixel >> 1), 1.0);
  gl_FragDepth = 0.5 * place.z / place.w + 0.5;
  outColor = Paled(vec4(uMarker, 1.0), pixel);
}
`;

// Corners are numbered from 0 to 3 along each axis: the ground's side, two in the arena, the other side.
export const kGroundVertex = /* glsl */ `${kCommon}
in vec3 position;
uniform vec2 uArenaMin;
uniform vec2 uArenaMax;
uniform float uFadeLength;
uniform float uGridSpacing;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
out vec2 vPosition;
out vec2 vCell;
void main() {
  vec2 inset = 0.02 * (uArenaMax - uArenaMin); // more than the boundary's width
  vec2 low = mix(uArenaMin - uFadeLength, uArenaMin + inset, step(0.5, position.xy));
  vec2 high = mix(uArenaMax - inset, uArenaMax + uFadeLength, step(2.5, position.xy));
  vPosition = mix(low, high, step(1.5, position.xy));
  vCell = vPosition / uGridSpacing;
  gl_Position = projectionMatrix * (viewMatrix * vec4(vPosition, 0.0, 1.0));
}
`;

export const kGroundFragment = /* glsl */ `${kCommon}
in vec2 vPosition;
uniform vec2 uArenaMin;
uniform vec2 uArenaMax;
uniform float uFadeLength;
uniform vec3 uBackground;
uniform vec3 uGround;
uniform vec3 uGroundOutside;
uniform vec3 uGridLine;
uniform vec3 uBoundary;
uniform float uGridStrength;
uniform float uPixelScale;
uniform vec3 uToSun;
uniform float uSunIntensity;
uniform vec3 uSkyLight;
uniform float uAmbientIntensity;
#ifdef HAS_FLOOR
uniform vec2 uFloorSize;
uniform sampler2D uFloor;
vec3 FloorColor(vec2 share) {
  vec2 place = share * uFloorSize;
  vec2 footprint = max(fwidth(place), vec2(1e-6));
  vec2 seam = floor(place + 0.5);
  vec2 sharp = seam + clamp((place - seam) / footprint, -0.5, 0.5);
  vec2 coordinates = mix(sharp, place, step(1.0, footprint)) / uFloorSize;
  return FromSrgb(textureGrad(uFloor, coordinates, dFdx(share), dFdy(share)).rgb);
}
#endif
#ifdef HAS_SHADOWS
${kShadow}
#endif
out vec4 outColor;
float GridCoverage(vec2 pixel, float spacing) {
  vec2 phase = vPosition / spacing;
  vec2 toLine = abs(fract(phase - 0.5) - 0.5) * spacing / pixel;
  vec2 apart = spacing / pixel;
  vec2 strength = smoothstep(8.0, 90.0, apart) * 0.62;
  vec2 lines = (1.0 - smoothstep(0.15, 1.05, toLine)) * strength;
  return max(lines.x, lines.y);
}
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
  vec3 base = FloorColor((vPosition - uArenaMin) / (uArenaMax - uArenaMin));
  float gridVisibility = 0.6;
#else
  vec3 base = uGround;
  float gridVisibility = 1.0;
#endif
  base = mix(uGroundOutside, base, inArena);
  float grid = max(max(GridCoverage(pixel, 0.1), GridCoverage(pixel, 1.0)), GridCoverage(pixel, 10.0));
  base = mix(base, Contrasting(uGridLine, base), uGridStrength * grid * mix(0.55, gridVisibility, inArena));
  vec2 toSide = min(abs(vPosition - uArenaMin), abs(vPosition - uArenaMax)) / pixel;
  vec2 along = step(beyond.yx, pixel.yx);
  vec2 lines = (1.0 - smoothstep(0.5, 1.5, toSide)) * along;
  base = mix(base, Contrasting(uBoundary, base), max(lines.x, lines.y));
  vec3 color = base;
#ifdef HAS_SHADOWS
  vec4 inShadow = uWorldToShadow * vec4(vPosition, 0.0, 1.0);
  float sun = SunShare(inShadow.xyz);
  vec3 lit = uSunIntensity * uToSun.z + uSkyLight * uAmbientIntensity;
  color *= (uSunIntensity * uToSun.z * sun + uSkyLight * uAmbientIntensity) / lit;
#endif
  outColor = vec4(ToSrgb(mix(color, uBackground, smoothstep(0.0, 1.0, outside / uFadeLength))), 1.0);
}
`;

/**
 * The same where the processor draws: colours are sRGB, one grid, no shadows. IS_INSIDE: neither boundary nor fading; pixels
 * take 0.6 of the time.
 */
export const kPlainGroundFragment = /* glsl */ `${kCommon}
in vec2 vPosition;
in vec2 vCell;
uniform vec2 uArenaMin;
uniform vec2 uArenaMax;
uniform float uFadeLength;
uniform vec3 uBackground;
uniform vec3 uGround;
uniform vec3 uGroundOutside;
uniform vec3 uGridLine;
uniform vec3 uBoundary;
uniform float uGridStrength;
uniform float uGridSpacing;
#ifdef HAS_FLOOR
uniform sampler2D uFloor;
#endif
out vec4 outColor;
void main() {
#ifdef HAS_FLOOR
  vec3 color = texture(uFloor, (vPosition - uArenaMin) / (uArenaMax - uArenaMin)).rgb;
#else
  vec3 color = uGround;
#endif
#ifndef IS_INSIDE
  vec2 inward = min(vPosition - uArenaMin, uArenaMax - vPosition);
  color = min(inward.x, inward.y) > 0.0 ? color : uGroundOutside;
#endif
  vec2 perCell = 1.0 / max(fwidth(vCell), vec2(1e-7)); // pixels
  vec2 toLine = abs(vCell - round(vCell)) * perCell;
  vec2 lines = clamp(1.1 - toLine, 0.0, 1.0) * min(0.011 * perCell, 0.6);
  color = mix(color, uGridLine, max(lines.x, lines.y) * uGridStrength);
#ifndef IS_INSIDE
  vec2 perMeter = perCell / uGridSpacing;
  vec2 border = clamp(1.6 - abs(inward) * perMeter, 0.0, 1.0) * step(-1.0, inward.yx * perMeter.yx);
  color = mix(color, uBoundary, max(border.x, border.y));
  float outside = length(min(inward, vec2(0.0)));
  color = mix(color, uBackground, smoothstep(0.0, 1.0, outside / uFadeLength));
#endif
  outColor = vec4(color, 1.0);
}
`;

export const kContactVertex = /* glsl */ `${kCommon}${kPoses}
in vec3 position;
in uvec2 inPlace;
in vec3 inOffset;
in vec4 inTurn;
in vec2 inHalfExtent;
in vec2 inShape;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
out vec2 vOffset;
flat out vec2 vHalfExtent;
flat out vec2 vShape;
void main() {
  vec3 origin;
  vec4 turn;
  ReadPose(inPlace.x, origin, turn);
  vec3 center = origin + Turn(turn, inOffset);
  vec3 axis = Turn(turn, Turn(inTurn, vec3(1.0, 0.0, 0.0)));
  vec3 up = Turn(turn, vec3(0.0, 0.0, 1.0));
  vOffset = (position.xy * 2.0 - 1.0) * (inHalfExtent + inShape.y);
  vHalfExtent = inHalfExtent;
  vShape = inShape;
  vec2 world = center.xy + axis.xy * vOffset.x + vec2(-axis.y, axis.x) * vOffset.y;
  gl_Position = projectionMatrix * (viewMatrix * vec4(world, 0.0, 1.0));
  if (up.z < 0.999 || abs(center.z) > 0.045) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  }
}
`;

export const kContactFragment = /* glsl */ `${kCommon}
in vec2 vOffset;
flat in vec2 vHalfExtent;
flat in vec2 vShape;
uniform float uContactDarkening;
out vec4 outColor;
void main() {
  vec2 toCorner = abs(vOffset) - vHalfExtent + vShape.x;
  float far = length(max(toCorner, 0.0)) + min(max(toCorner.x, toCorner.y), 0.0) - vShape.x;
  float share = 1.0 - clamp(far / max(vShape.y, 1e-6), 0.0, 1.0);
  outColor = vec4(0.0, 0.0, 0.0, uContactDarkening * share * share);
}
`;

/** Rings on the ground around what is selected. */
export const kRingVertex = /* glsl */ `${kCommon}${kPoses}
in vec3 position;
in uvec2 inPlace;
in float inRadius;
in vec4 inColor;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform float uPixelsPerUnit;
uniform float uPixelScale;
out vec2 vOffset;
flat out vec4 vColor;
flat out float vPixels;
void main() {
  vec3 origin;
  vec4 turn;
  ReadPose(inPlace.x, origin, turn);
  vec4 center = projectionMatrix * (viewMatrix * vec4(origin, 1.0));
  float least = 9.0 * uPixelScale * center.w / uPixelsPerUnit;
  float radius = max(inRadius, least);
  vPixels = radius * uPixelsPerUnit / center.w;
  vOffset = (position.xy * 2.0 - 1.0) * 1.15;
  vec3 place = origin + vec3(vOffset * radius, 0.002 + max(0.0, -origin.z));
  gl_Position = projectionMatrix * (viewMatrix * vec4(place, 1.0));
  vColor = inColor;
}
`;

export const kRingFragment = /* glsl */ `${kCommon}
in vec2 vOffset;
flat in vec4 vColor;
flat in float vPixels;
uniform float uPixelScale;
out vec4 outColor;
void main() {
  float far = abs(length(vOffset) - 1.0) / max(fwidth(length(vOffset)), 1e-6);
  float alpha = clamp(1.5 * uPixelScale + 0.5 - far, 0.0, 1.0);
  alpha = max(alpha, length(vOffset) < 1.0 ? 0.16 : 0.0) * vColor.a;
  outColor = vec4(vColor.rgb * alpha, alpha);
}
`;

export const kGlowVertex = /* glsl */ `${kCommon}${kPoses}
in vec3 position;
in uvec2 inPlace;
in vec3 inOffset;
in vec4 inColor;
in vec3 inShape;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform float uPixelsPerUnit;
uniform float uSignalPixels;
uniform float uPixelScale;
out vec2 vOffset;
flat out vec4 vColor;
flat out float vHalo;
flat out float vPixels;
flat out int vIsLit;
void main() {
  // inShape: radius in m, diameter in pixels instead, kind (0 plain, 1 LED, 2 lamp, 3 signal of all)
  vec4 color = inColor;
  float haloScale = 0.0;
  bool isSignal = false;
  bool isHidden = false;
  if (inShape.z > 0.5) {
    uint word = ReadWord(inPlace.y);
    bool isLit = (word & 0xffffffu) != 0u;
    if (inShape.z > 1.5 && inShape.z < 2.5) {
      uint high = ReadWord(inPlace.y + 2u);
      isLit = high >> 31 == 0u && (high | ReadWord(inPlace.y + 1u)) != 0u;
    }
    isHidden = !isLit && inShape.z > 2.5;
    color = isLit ? vec4(ColorOfWord(word).rgb, 1.0) : vec4(46.0, 48.0, 54.0, 255.0) / 255.0;
    haloScale = isLit ? (inShape.z > 1.5 && inShape.z < 2.5 ? 4.5 : 3.6) : 0.0;
    isSignal = isLit;
  }
  vec3 origin;
  vec4 turn;
  ReadPose(inPlace.x, origin, turn);
  vec4 center = viewMatrix * vec4(origin + Turn(turn, inOffset), 1.0);
  float depth = max(-center.z, 1e-4);
  float w = max((projectionMatrix * center).w, 1e-4);
  float truePixels = inShape.y > 0.0 ? 0.5 * inShape.y * uPixelScale : inShape.x * uPixelsPerUnit / w;
  float least = isSignal ? 0.5 * uSignalPixels : 1.2;
  float pixels = max(truePixels, least * uPixelScale);
  float radius = pixels * w / uPixelsPerUnit;
  float haloPixels = isSignal ? pixels : truePixels;
  vHalo = haloScale > 0.0 ? max(haloScale * haloPixels / pixels, 1.001) : 0.0;
  float reach = max(vHalo, 1.0) + 0.7 / pixels;
  vOffset = (position.xy * 2.0 - 1.0) * reach;
  float cover = isSignal ? 1.0 : min(truePixels / pixels, 1.0);
  vColor = vec4(FromSrgb(color.rgb), color.a * cover);
  vPixels = pixels;
  vIsLit = inShape.y > 0.0 ? 0 : 1;
  gl_Position = projectionMatrix * (center + vec4(vOffset * radius, 0.0, 0.0));
  float nearest = inShape.y > 0.0 ? 0.997 * depth : max(depth - 1.3 * inShape.x, 0.5 * depth);
  vec4 front = projectionMatrix * vec4(0.0, 0.0, -nearest, 1.0);
  gl_Position.z = front.z / front.w * gl_Position.w;
  // dark LEDs of a pixel hardly show
  if (isHidden || (!isSignal && inShape.z > 0.5 && truePixels < 0.8 * uPixelScale)) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  }
}
`;

export const kGlowFragment = /* glsl */ `${kCommon}
in vec2 vOffset;
flat in vec4 vColor;
flat in float vHalo;
flat in float vPixels;
flat in int vIsLit;
uniform vec3 uToSunInView;
uniform float uHaloStrength;
uniform float uHaloOpacity;
out vec4 outColor;
void main() {
  float far = length(vOffset);
  float disc = clamp((1.0 - far) * vPixels + 0.5, 0.0, 1.0);
  vec3 color = vColor.rgb;
  float halo = 0.0;
  if (vHalo > 0.0) {
    color = mix(color, vec3(1.0), 0.45 * pow(max(1.0 - far, 0.0), 1.5));
    float share = clamp((far - 1.0) / max(vHalo - 1.0, 1e-3), 0.0, 1.0);
    halo = uHaloStrength * pow(1.0 - share, 2.5) * (1.0 - disc) * vColor.a;
  } else if (vIsLit != 0) {
    vec3 up = vec3(vOffset, sqrt(max(1.0 - far * far, 0.0)));
    color *= 0.45 + 0.75 * max(dot(up, uToSunInView), 0.0);
  }
  float alpha = vColor.a * disc + halo * uHaloOpacity;
  outColor = vec4(ToSrgb(color) * vColor.a * disc + ToSrgb(vColor.rgb) * halo, alpha);
}
`;

export const kLineVertex = /* glsl */ `${kCommon}${kPoses}
in vec3 position;
in uvec2 inPlace;
in vec3 inStart;
in vec3 inEnd;
in vec4 inColor;
in float inWidth;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform float uNear;
uniform vec2 uPictureSize;
uniform float uPixelScale;
flat out vec4 vColor;
flat out float vHalfWidth;
out float vAcross;
void main() {
  vec3 origin;
  vec4 turn;
  ReadPose(inPlace.x, origin, turn);
  vec3 start = (viewMatrix * vec4(origin + Turn(turn, inStart), 1.0)).xyz;
  vec3 end = (viewMatrix * vec4(origin + Turn(turn, inEnd), 1.0)).xyz;
  if (start.z > -uNear && end.z < -uNear) {
    start = mix(start, end, (start.z + uNear) / (start.z - end.z));
  } else if (end.z > -uNear && start.z < -uNear) {
    end = mix(end, start, (end.z + uNear) / (end.z - start.z));
  }
  vec4 clipStart = projectionMatrix * vec4(start, 1.0);
  vec4 clipEnd = projectionMatrix * vec4(end, 1.0);
  vec2 direction = (clipEnd.xy / clipEnd.w - clipStart.xy / clipStart.w) * uPictureSize;
  float pixels = length(direction);
  direction = pixels > 1e-4 ? direction / pixels : vec2(1.0, 0.0);
  vec2 across = vec2(-direction.y, direction.x);
  float side = position.x * 2.0 - 1.0;
  bool isStart = position.y < 0.5;
  vec4 clip = isStart ? clipStart : clipEnd;
  vHalfWidth = 0.5 * inWidth * uPixelScale;
  vAcross = side * (vHalfWidth + 0.5);
  clip.xy += across * vAcross * 2.0 / uPictureSize * clip.w;
  vec4 nearer = projectionMatrix * vec4(0.997 * (isStart ? start : end), 1.0);
  clip.z = nearer.z / nearer.w * clip.w;
  gl_Position = clip;
  vColor = inColor;
}
`;

export const kLineFragment = /* glsl */ `${kCommon}
flat in vec4 vColor;
flat in float vHalfWidth;
in float vAcross;
out vec4 outColor;
void main() {
  float alpha = vColor.a * clamp(vHalfWidth + 0.5 - abs(vAcross), 0.0, 1.0);
  outColor = vec4(vColor.rgb * alpha, alpha);
}
`;

export const kFlatVertex = /* glsl */ `${kCommon}
in vec3 position;
in vec4 inColor;
in float inNearer;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
out vec4 vColor;
void main() {
  vec4 inCamera = viewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * inCamera;
  vec4 nearer = projectionMatrix * vec4((1.0 - inNearer) * inCamera.xyz, 1.0);
  gl_Position.z = nearer.z / nearer.w * gl_Position.w;
  vColor = inColor;
}
`;

export const kFlatFragment = /* glsl */ `${kCommon}
in vec4 vColor;
out vec4 outColor;
void main() {
  outColor = vec4(vColor.rgb * vColor.a, vColor.a);
}
`;
