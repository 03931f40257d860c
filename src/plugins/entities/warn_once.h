#ifndef ARGOS3_PLUGINS_ENTITIES_WARN_ONCE_H
#define ARGOS3_PLUGINS_ENTITIES_WARN_ONCE_H

#include <string>

namespace argos {

/**
 * Logs a warning on LOGERR, but not a second time in the current space: one line for what many
 * robots share. Not while robots act or sense in parallel.
 */
void WarnOnce(const std::string& text);

}  // namespace argos

#endif
