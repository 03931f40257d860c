#ifndef ARGOS3_PLUGINS_MEDIA_CLEAR_MEDIUM_H
#define ARGOS3_PLUGINS_MEDIA_CLEAR_MEDIUM_H

#include <vector>

namespace argos {

/**
 * Calls ClearMedium() of the entities of a list, which may remove them from it; afterwards the list
 * is empty. Needs no memory.
 */
template <typename ENTITY>
void ClearMediumOfAll(std::vector<ENTITY*>& entities) {
  while (!entities.empty()) {
    ENTITY* const last = entities.back();
    last->ClearMedium();
    if (!entities.empty() && entities.back() == last) {
      entities.pop_back();
    }
  }
}

}  // namespace argos

#endif
