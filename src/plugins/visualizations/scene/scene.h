#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_SCENE_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_SCENE_H

#include <argos3/core/simulator/visualization/appearance.h>
#include <argos3/core/simulator/visualization/drawing.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace argos {

/** A colour as stored in an image file: sRGB, 0 to 255, alpha 255 is opaque. */
struct SRgba {
  std::uint8_t R = 0;
  std::uint8_t G = 0;
  std::uint8_t B = 0;
  std::uint8_t A = 255;
};

/** The solids that the renderer draws, each of unit size in its own frame. */
enum class EMeshKind : std::uint8_t {
  Box, /**< x, y in [-0.5, 0.5], z in [0, 1] */
  Cylinder, /**< radius 0.5 around z, z in [0, 1]; Param = radius of the top over that of the base
             */
  Sphere, /**< radius 0.5 around the origin */
  Ring, /**< torus around z; Param = radius of the tube over the outer radius, which is 0.5 */
  Count
};

constexpr std::size_t kNumMeshKinds = static_cast<std::size_t>(EMeshKind::Count);

/**
 * One solid of the scene.
 *
 * The layout is that of the vertex buffer the graphics pipeline reads.
 */
struct SMeshInstance {
  /** Rows of the 3 x 4 matrix from the mesh's frame to the world frame, m; may scale unevenly. */
  std::array<std::array<float, 4>, 3> ToWorld;
  SRgba Color; /**< alpha < 255: translucent, drawn after the opaque ones, far to near */
  float Param = 1.0f; /**< see EMeshKind */
  /** 1: a small part of something larger, left out where it would cover only a few pixels. */
  float IsDetail = 0.0f;
  EMaterial Material = EMaterial::Plastic;
};

/** The finer model that a renderer has for the solids of an entity on one of its anchors. */
struct SModelInstance {
  std::size_t Model = 0; /**< number that the renderer gave */
  /** Rows of the 3 x 4 matrix from the anchor's frame to the world frame, m. */
  std::array<std::array<float, 4>, 3> ToWorld;
};

/** A luminous point: a disc that always faces the camera, with a soft halo around it. */
struct SGlow {
  std::array<float, 3> Position; /**< centre, world frame, m */
  float Radius =
      0.0f; /**< radius of the disc, m; it is never drawn smaller than a pixel and a half */
  SRgba Color;
  float HaloScale = 0.0f; /**< radius of the halo over that of the disc; 0 = no halo */
  /** > 0: diameter on the picture, pixels, instead of Radius; the disc is then of even colour. */
  float Pixels = 0.0f;
  /** 1: a signal, which stays readable from afar: never drawn smaller than kSignalPixels. */
  float IsSignal = 0.0f;
  bool IsLamp = false; /**< lights its surroundings */
};

/** Least diameter of a signal in a picture 960 pixels high; in others in proportion, but >= 2. */
constexpr float kSignalPixels = 4.4f;

/** A robot, which is drawn as a disc of even colour where it would be smaller than a few pixels. */
struct SMarker {
  std::array<float, 3> Position; /**< world frame, m */
  float Radius = 0.0f; /**< radius of the robot, m */
};

/** A straight line, of even width on the picture. */
struct SLine {
  std::array<float, 3> Start; /**< world frame, m */
  std::array<float, 3> End; /**< world frame, m */
  SRgba Color;
  float Width = 1.5f; /**< pixels */
};

/** A corner of a triangle of even colour, which no light changes and which casts no shadow. */
struct SFlatVertex {
  std::array<float, 3> Position; /**< world frame, m; over the picture: x, y in pixels */
  SRgba Color;
  /** Share of its distance by which it counts as nearer: what lies in one plane covers in order. */
  float Nearer = 0.0f;
};

/** A text that faces the camera, in front of everything, with a contour of contrasting shade. */
struct SLabel {
  std::array<float, 3> Position; /**< world frame, m; over the picture: x, y in pixels */
  SRgba Color;
  std::string Text; /**< UTF-8; line feeds separate lines */
  STextStyle Style;
};

/** Soft darkening of the ground under a solid, which blocks the skylight. */
struct SContactShadow {
  std::array<float, 2> Center; /**< point on the ground, world frame, m */
  std::array<float, 2> AxisX; /**< unit vector along the first half extent */
  std::array<float, 2> HalfExtent; /**< half the sides of the footprint, m */
  float CornerRadius = 0.0f; /**< m; a footprint whose radius equals its half extents is a disc */
  float Blur = 0.0f; /**< reach of the darkening, m */
};

/** The image on the floor, shared by the scenes that show it. Row 0 is at the lowest y. */
struct SFloorImage {
  int Width = 0; /**< pixels; 0 = no image */
  int Height = 0; /**< pixels */
  /** R, G, B, A per pixel, sRGB (Height, Width, 4); null = no image. */
  std::shared_ptr<const std::vector<std::uint8_t>> Pixels;
  bool IsSmooth = false; /**< blend between pixels instead of showing them as squares */
  std::uint64_t Version = 0; /**< changes when the pixels change */
  /** Sides of one image, which is repeated from the arena's lower left corner, m; 0: it covers the
   * arena. */
  std::array<float, 2> TileSize = {0.0f, 0.0f};
};

/** Everything on one picture but the camera. Plain arrays, to be refilled for every frame. */
struct SScene {
  Eigen::Vector2d ArenaMin = Eigen::Vector2d(-1.0, -1.0); /**< world frame, m */
  Eigen::Vector2d ArenaMax = Eigen::Vector2d(1.0, 1.0); /**< world frame, m */
  bool ShowGrid = true;
  bool ShowBoundary = true;
  SFloorImage Floor;

  std::array<std::vector<SMeshInstance>, kNumMeshKinds> Meshes; /**< index: EMeshKind */
  std::vector<SModelInstance> Models; /**< replace meshes if the renderer has models */
  std::vector<SGlow> Glows;
  std::vector<SMarker> Markers;
  std::vector<SLine> Lines;
  std::vector<SContactShadow> ContactShadows;
  std::vector<SFlatVertex> Flats; /**< opaque ones; three per triangle */
  std::vector<SFlatVertex> TranslucentFlats; /**< drawn in order */
  std::vector<SLabel> Labels;
  /** Over the picture, in pixels from its upper left corner, drawn in order; texts last. */
  std::vector<SFlatVertex> OverlayFlats;
  std::vector<SLabel> OverlayLabels;

  /** Removes the contents of the arena; keeps the memory, the floor and the settings. */
  void ClearContents();

  std::vector<SMeshInstance>& OfKind(EMeshKind kind) {
    return Meshes[static_cast<std::size_t>(kind)];
  }
};

}  // namespace argos

#endif
