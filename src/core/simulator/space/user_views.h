#ifndef ARGOS3_CORE_SIMULATOR_SPACE_USER_VIEWS_H
#define ARGOS3_CORE_SIMULATOR_SPACE_USER_VIEWS_H

#include <argos3/core/simulator/space/space.h>

namespace argos {

/**
 * The lists and maps of all entities, components included, that users may ask a space for.
 *
 * Not kept for nothing: they exist from the first question on. The tick never looks at them.
 */
struct CSpace::SUserViews {
  CEntity::TVector All;  // in order of index
  CEntity::TMap PerId;  // by qualified id
  TMapPerTypePerId PerType;  // by type, then by qualified id
  CEntity::TVector Pending;  // added to the space, not yet to the views
  bool AllIsStale = false;  // All holds entities that are gone

  void Erase(CEntity& entity);
};

}  // namespace argos

#endif
