#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_CAMERA_PLAN_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_CAMERA_PLAN_H

#include <argos3/plugins/simulator/visualizations/scene/camera_framing.h>
#include <argos3/plugins/simulator/visualizations/scene/camera_timeline.h>
#include <argos3/plugins/simulator/visualizations/scene/drawn_extents.h>

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>

namespace argos {

class CSpace;

/** What `<camera>` says. */
struct SCameraSettings {
  explicit SCameraSettings(const CCameraTimeline& timeline) : Timeline(timeline) {}

  enum class EFit : std::uint8_t {
    Arena, /**< the ground of the arena, and everything in it */
    Contents /**< bodies, and lights above the arena */
  };

  CCameraTimeline Timeline;
  /** Placement 0 is this view of what Fit says; absent: the timeline's own placement 0. */
  std::optional<SView> View;
  EFit Fit = EFit::Arena;
  double Margin = 0.04; /**< share of the picture that View leaves free */
  /** Id of the root entity that placements are relative to; empty: the world. */
  std::string Followed;
  double Reach = 1.0; /**< m around the followed entity that View shows */
};

/**
 * The camera of each frame of a run: placements and key frames, views that fit what they show, and
 * entities to follow.
 *
 * What a view shows only grows, so that the picture stands still while robots move inside of it.
 */
class CCameraPlan {
 public:
  /** @param aspectRatio  width of the picture over its height, > 0. */
  CCameraPlan(const SCameraSettings& settings, double aspectRatio);

  /**
   * The camera for the present state of a space. Warns once if it is inside of an entity, and if
   * the followed entity does not exist any more: the camera then stays where it is.
   */
  SCameraPlacement ComputeAt(CSpace& space, std::uint32_t tick);
  /** The next call shows another run. */
  void Reset();

 private:
  void UpdateFollowed(CSpace& space);
  void UpdateView(CSpace& space);
  void WarnIfInside(CSpace& space, const SCameraPlacement& placement);

  SCameraSettings m_settings;
  double m_aspectRatio;
  std::optional<CCameraFraming> m_framing;
  CDrawnExtents m_extents;
  Eigen::Vector3d m_followed = Eigen::Vector3d::Zero();  // position, world frame, m
  bool m_hasLostFollowed = false;
  bool m_hasWarnedOfInside = false;
  std::optional<Eigen::Vector3d> m_checked;  // last position of the eye that was checked
};

/** Position of a root entity in the world, m; absent if it has none, as the floor. */
std::optional<Eigen::Vector3d> FindPosition(CSpace& space, const std::string& id);

}  // namespace argos

#endif
