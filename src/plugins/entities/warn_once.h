#ifndef ARGOS3_PLUGINS_ENTITIES_WARN_ONCE_H
#define ARGOS3_PLUGINS_ENTITIES_WARN_ONCE_H

#include <string>

namespace argos {

/**
 * Logs a warning on LOGERR once per space: one line for a problem that many robots share. Must not
 * be called while robots act or sense in parallel.
 */
void WarnOnce(const std::string& text);

}  // namespace argos

#endif
