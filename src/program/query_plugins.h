#ifndef ARGOS3_PROGRAM_QUERY_PLUGINS_H
#define ARGOS3_PROGRAM_QUERY_PLUGINS_H

#include <string>

namespace argos {

/** The answer to a question about plug-ins and elements of experiment files. */
struct SPluginAnswer {
  std::string Text;
  bool IsFound = false;
};

/**
 * Describes registered plug-ins, for `argos3 -q`.
 * @param query  "actuators", "sensors", "physics_engines", "media", "visualizations", "overlays",
 *   "entities", "robot_types", "fields", "built_in_metrics", "controllers", "loop_functions" or
 *   "elements", or the word of a CPluginKind: a list of that kind; "all": all lists; otherwise a
 *   label, a tag or the class of a control interface: all facts about these plug-ins; or a part of
 *   labels (case-sensitive), and the name of an element or attribute of experiment files. Devices
 * are created on each robot to find which they fit.
 * @param asJson  the same facts as JSON, of lists those of all their plug-ins.
 */
SPluginAnswer AnswerQuery(const std::string& query, bool asJson = false);

/** The text of AnswerQuery(). */
std::string DescribePlugins(const std::string& query);

/**
 * Prints the answer on LOG, without colours, and flushes it.
 * @return true if something was found.
 */
bool QueryPlugins(const std::string& query, bool asJson = false);

/** Prints a text on LOG, without colours, and flushes it. */
void PrintPlain(const std::string& text);

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/plugins/plugin_kind.h>
#endif

#endif
