#ifndef ARGOS3_PLUGINS_ENTITIES_PASSIVE_BODY_MANUAL_H
#define ARGOS3_PLUGINS_ENTITIES_PASSIVE_BODY_MANUAL_H

#include <string>

namespace argos {

/**
 * Of the manual of a box or a cylinder: the attributes that both have, and their optional XML.
 *
 * Called while the library loads, so it uses no other static objects.
 * @param name       "box".
 * @param start      start tag of one with an LED, which is at @p ledOffset, m.
 */
std::string PassiveBodyManual(const std::string& name, const std::string& start,
                              const std::string& ledOffset);

}  // namespace argos

#endif
