#ifndef ARGOS3_CORE_SIMULATOR_QUERY_PLUGINS_H
#define ARGOS3_CORE_SIMULATOR_QUERY_PLUGINS_H

#include <string>

namespace argos {

/**
 * Describes registered plug-ins, for `argos3 -q`.
 * @param query  "actuators", "sensors", "physics_engines", "media", "visualizations", "entities",
 *               "controllers" or "loop_functions": a list of that kind; "all": all the lists;
 *               anything else: the documentation of every plug-in whose label contains it, case
 *               counting.
 */
std::string DescribePlugins(const std::string& query);

/** Prints DescribePlugins() on LOG, without colours, and flushes it. */
void QueryPlugins(const std::string& query);

}  // namespace argos

#endif
