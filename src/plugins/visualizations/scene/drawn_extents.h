#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_DRAWN_EXTENTS_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_DRAWN_EXTENTS_H

#include <argos3/plugins/simulator/visualizations/scene/scene_parts.h>

#include <Eigen/Geometry>

#include <unordered_map>

namespace argos {

struct SAppearance;

/** The boxes around what is drawn of entities, which may reach beyond their bodies. */
class CDrawnExtents {
 public:
  /**
   * @param body    of an entity that has this appearance.
   * @param origin  pose of the body.
   * @return box in the body's frame, m; empty if nothing is drawn. Parts at anchors that move on
   * the body are where they were at the first call with this appearance.
   */
  const Eigen::AlignedBox3d& Get(const SAppearance& appearance, CEmbodiedEntity* body,
                                 const SPose& origin);

 private:
  std::unordered_map<const SAppearance*, Eigen::AlignedBox3d> m_boxes;
};

}  // namespace argos

#endif
