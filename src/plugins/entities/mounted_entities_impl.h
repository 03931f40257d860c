#ifndef ARGOS3_PLUGINS_ENTITIES_MOUNTED_ENTITIES_IMPL_H
#define ARGOS3_PLUGINS_ENTITIES_MOUNTED_ENTITIES_IMPL_H

#include <argos3/core/simulator/context/current.h>
#include <argos3/plugins/simulator/entities/mounted_entities.h>
#include <argos3/plugins/simulator/entities/read_medium.h>

namespace argos {

template <class ENTITY>
void CMountedEntities<ENTITY>::InitInMedium(TConfigurationNode& tree, const std::string& kind,
                                            const std::string& tag,
                                            const std::string& defaultAnchor) {
  CComposableEntity::Init(tree);
  SetMedium(ReadMedium<typename ENTITY::CRegistry>(tree, CurrentSimulator(), kind));
  InitInstances(tree, tag, defaultAnchor);
  Enable();
}

}  // namespace argos

#endif
