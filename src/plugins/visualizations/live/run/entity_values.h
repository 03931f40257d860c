#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_ENTITY_VALUES_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_ENTITY_VALUES_H

#include <argos3/plugins/simulator/visualizations/live/link/live_messages.h>

namespace argos {

class CEntity;

/**
 * The values of an entity as a tree: its type and components, and each field that tables could have
 * of it (pose, readings of each sensor, LEDs, variables of Lua, ...), by field and column; the unit
 * of a column is behind its name.
 * @param maxBytes  about the size as text, beyond which fields are left out.
 */
TJson ReadValues(CEntity& root, size_t maxBytes);

/** The values of one field of an entity, as in ReadValues(); null if it does not have the field. */
TJson ReadField(CEntity& root, const std::string& field);

}  // namespace argos

#endif
