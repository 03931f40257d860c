#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OVERLAYS_ROBOTS_IN_VIEW_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OVERLAYS_ROBOTS_IN_VIEW_H

#include <argos3/core/simulator/geometry/body_pose.h>
#include <argos3/core/simulator/geometry/bounding_box.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/datatypes/color.h>

#include <string>
#include <vector>

namespace argos {

class CComposableEntity;
class CSpace;

/** The robots to which an overlay applies: all, or those of the types in the attribute `of`. */
class CRobotsInView {
 public:
  struct SRobot {
    CComposableEntity* Root;
    SBodyPose Pose; /**< pose of its origin, rounded as all that views draw */
    SBoundingBox Box; /**< encloses its body as described, at the origin and not turned, m */
  };

  /** @throws CARGoSException if a type is not that of an entity, listing the nearest ones. */
  void Init(TConfigurationNode& node);
  /** Robots in the order of their addition to the space; valid until the next call. */
  const std::vector<SRobot>& List(CSpace& space);

 private:
  std::vector<std::string> m_types;  // empty: all
  std::vector<SRobot> m_robots;
};

/**
 * A colour from a palette that people with colour-blindness can tell apart.
 *
 * Source: M. Okabe, K. Ito, Color Universal Design (2008).
 */
CColor GetPaletteColor(size_t index);

}  // namespace argos

#endif
