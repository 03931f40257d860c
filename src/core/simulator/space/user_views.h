#ifndef ARGOS3_CORE_SIMULATOR_SPACE_USER_VIEWS_H
#define ARGOS3_CORE_SIMULATOR_SPACE_USER_VIEWS_H

#include <argos3/core/simulator/space/space.h>

#include <set>
#include <string>

namespace argos {

/**
 * The lists and maps of entities that users may ask a space for.
 *
 * Not kept for nothing: they exist from the first question on, and hold what was asked for. Who
 * asks for the entities of one type gets no component made of another type; who asks for a list of
 * everything gets all that robots make only on demand. The tick never looks at them.
 */
struct CSpace::SUserViews {
  CEntity::TVector All;  // in order of index
  CEntity::TMap PerId;  // by qualified id
  TMapPerTypePerId PerType;  // by type, then by qualified id
  CEntity::TVector Pending;  // added to the space, not yet to the views
  std::set<std::string> RootTypes;  // types of root entities: always listed
  std::set<std::string> CompleteTypes;  // those of which every component exists and is listed
  bool Complete = false;  // the same of all types
  bool AllIsStale = false;  // All holds entities that are gone

  void Erase(CEntity& entity);
};

/** Types of entities that were removed before there were views. */
struct SGoneTypes : CSpaceExtension {
  std::set<std::string> Types;
};

}  // namespace argos

#endif
