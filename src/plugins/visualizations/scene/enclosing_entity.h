#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_ENCLOSING_ENTITY_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_ENCLOSING_ENTITY_H

#include <Eigen/Core>

namespace argos {

class CEntity;
class CSpace;

/** The first root entity that has a drawn, opaque solid around a point of the world; null if none.
 */
const CEntity* FindEnclosingEntity(CSpace& space, const Eigen::Vector3d& point);

}  // namespace argos

#endif
