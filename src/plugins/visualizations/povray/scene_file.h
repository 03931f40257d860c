#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_POVRAY_SCENE_FILE_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_POVRAY_SCENE_FILE_H

#include <argos3/plugins/simulator/visualizations/scene/camera.h>
#include <argos3/plugins/simulator/visualizations/scene/look.h>
#include <argos3/plugins/simulator/visualizations/scene/scene.h>

#include <cstdint>
#include <span>
#include <string>

namespace argos {

/** Time spent on light: see the attribute `quality` of `<povray>`. */
enum class EPovrayQuality : std::uint8_t { Draft, Good, Best };

/** What all scene files of a view have in common. */
struct SPovraySettings {
  int Width = 1280; /**< pixels */
  int Height = 960; /**< pixels */
  EPovrayQuality Quality = EPovrayQuality::Good;
  bool IsDark = false; /**< the look; see Look */
  SLook Look = SLook::FromName("light");
  std::uint32_t MostLights = 8; /**< light sources for LEDs, and for lamps, at most */
};

/** The text of a scene file while it is written. */
struct SSceneText {
  const SPovraySettings& Settings;
  const SScene& Scene;
  const CCamera& Camera;
  std::string Text;
  std::size_t NumSkipped = 0; /**< things left out: a number of theirs is not finite */

  /** Size of a pixel at a distance along the line of sight, m. */
  double ComputePixelSize(double depth) const;
  double ComputePixelSizeAt(const std::array<float, 3>& point) const;
};

/** What a scene file needs besides the scene and the settings. */
struct SSceneExtras {
  /** Object of each model, see CPovrayModel::SPart; indexed by SModelInstance::Model. */
  std::span<const std::string> Models;
  /** File of the floor's image, relative to the scene file; empty: the floor has none. */
  std::string FloorFile;
};

/**
 * A scene in POV-Ray's scene description language: a file that needs no other one except the
 * floor's image.
 *
 * Coordinates are the world's. POV-Ray calls its own left-handed, but traces rays along the
 * vectors of the camera; with those of CCamera pictures are not mirrored.
 * @param numSkipped  set to the number of things that were left out, because they have numbers that
 *                    are not finite.
 */
std::string MakeSceneFile(const SScene& scene, const SCameraPlacement& placement,
                          const SPovraySettings& settings, const SSceneExtras& extras,
                          std::size_t& numSkipped);

/*
 * Parts of a scene file.
 */

/** Version, settings of the renderer, and the macros that all texts use. */
std::string MakePrologue(const SPovraySettings& settings);
void AddGround(const std::string& floorFile, SSceneText& file);
void AddSolids(const SSceneExtras& extras, SSceneText& file);
/** Sky, main light, lamps and LEDs. */
void AddLights(SSceneText& file);
/** Lines, areas and texts, which no light changes; what lies over the picture. */
void AddAnnotations(SSceneText& file);

/** A PPM file with the floor's image; the first row is at the highest y. */
std::string MakeFloorFile(const SFloorImage& floor);

}  // namespace argos

#endif
