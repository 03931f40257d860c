#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_FRAME_CHOICE_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_FRAME_CHOICE_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/plugins/simulator/visualizations/scene/scene.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace argos {

/** The ticks of a run that have frames. */
struct SFrameChoice {
  std::uint32_t Every = 1; /**< ticks from frame to frame, > 0 */
  /** First and last tick of each part of the run that has frames; none: the whole run. */
  std::vector<std::pair<std::uint32_t, std::uint32_t>> Ticks;
  bool KeepLastFrame =
      true; /**< draw the final state even if its tick is not a multiple of Every */

  /** @param isFirst  the run has no frame yet. @return true if a tick during the run has a frame.
   */
  bool IsWanted(std::uint32_t tick, bool isFirst) const;
  /** @return true if the final state has a frame, whatever its tick. */
  bool IsLastWanted() const { return KeepLastFrame && Ticks.empty(); }
};

/** What frames show besides entities. */
struct SFrameContents {
  SFloorImage Ground; /**< texture of the ground where the arena has no floor */
  bool ShowGrid = true;
  bool ShowBoundary = true;
  bool ShowRays = true;
};

/*
 * Attributes that views which draw frames have in common. The functions throw CARGoSException with
 * file and line if a value does not parse or is out of range.
 */

/** Reads `every` and `ticks`. */
void ReadFrameChoice(TConfigurationNode& node, SFrameChoice& choice);

/** Reads `show_grid`, `show_boundary`, `show_rays` and the attributes of ReadGroundTexture(). */
void ReadFrameContents(TConfigurationNode& node, SFrameContents& contents);

/** Reads a whole number, at least 1; absent: @p value stays. */
void ReadPositive(TConfigurationNode& node, const std::string& attribute, UInt32& value);

/** Reads `"WxH"`, pixels, each from 16 to 16384. */
void ReadSize(TConfigurationNode& node, const std::string& attribute, int& frameWidth,
              int& frameHeight);

/** Reads `size`, or `width` and `height`; absent: the values stay. */
void ReadFrameSize(TConfigurationNode& node, int& frameWidth, int& frameHeight);

}  // namespace argos

#endif
