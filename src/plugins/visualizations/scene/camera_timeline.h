#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_CAMERA_TIMELINE_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_CAMERA_TIMELINE_H

#include <argos3/plugins/simulator/visualizations/scene/camera.h>

#include <cstdint>
#include <vector>

namespace argos {

/** From tick Step on, the camera is at a placement. */
struct SKeyframe {
  std::size_t Placement = 0; /**< slot, 0 to 11 */
  std::uint32_t Step = 0; /**< tick */
  bool Interpolate = false; /**< glide towards the next keyframe instead of standing still */
};

/**
 * The placements of a camera, and the ticks at which it takes them.
 *
 * A keyframe holds until the next one. Between a keyframe that interpolates and its successor the
 * camera glides. With a loop the timeline repeats itself with that period, and the successor of
 * the last keyframe is the first one.
 */
class CCameraTimeline {
 public:
  explicit CCameraTimeline(const std::array<SCameraPlacement, kNumPlacements>& placements)
      : m_placements(placements) {}

  const SCameraPlacement& GetPlacement(std::size_t slot) const { return m_placements[slot]; }
  void SetPlacement(std::size_t slot, const SCameraPlacement& placement);
  /** True after SetPlacement() of that slot. */
  bool IsSet(std::size_t slot) const { return m_isSet[slot]; }

  /** @param loop  period in ticks; 0 = the timeline runs once. */
  void SetLoop(std::uint32_t loop) { m_loop = loop; }

  /**
   * Appends a keyframe. Call SetLoop() before.
   * @throws CARGoSException if the slot is beyond 11, the step is before that of the keyframe added
   *         last, or after the loop.
   */
  void AddKeyframe(const SKeyframe& keyframe);

  /**
   * Makes the camera glide from the keyframe added last to the next one.
   * @throws CARGoSException if there is no keyframe yet, or it was called already.
   */
  void InterpolateFromLastKeyframe();

  /** @throws CARGoSException if the camera glides between a perspective and an orthographic view.
   */
  void CheckGlides() const;

  /** The camera at a tick; slot 0 before the first keyframe of a timeline that runs once. */
  SCameraPlacement ComputeAt(std::uint32_t tick) const;

 private:
  std::array<SCameraPlacement, kNumPlacements> m_placements;
  std::array<bool, kNumPlacements> m_isSet{};
  std::vector<SKeyframe> m_keyframes;  // steps do not decrease
  std::uint32_t m_loop = 0;
};

}  // namespace argos

#endif
