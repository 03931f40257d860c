#ifndef ARGOS3_CORE_SIMULATOR_PROGRAM_QUERY_PLUGINS_H
#define ARGOS3_CORE_SIMULATOR_PROGRAM_QUERY_PLUGINS_H

#include <argos3/core/utility/plugins/factory.h>

#include <string>
#include <vector>

namespace argos {

/** Description of a plug-in, for display. */
struct SPluginText {
  std::string Label;
  std::string Author;
  std::string Version;
  std::string Brief;
  std::string Long;
  std::string Status;
};

/** All registered plug-ins with this base class, by label. */
template <typename TYPE>
std::vector<SPluginText> ListPlugins() {
  std::vector<SPluginText> plugins;
  for (const auto& [label, info] : CFactory<TYPE>::GetTypes()) {
    plugins.push_back({label, info.Author, info.Version, info.BriefDescription,
                       info.LongDescription, info.Status});
  }
  return plugins;
}

/**
 * Adds a kind of plug-ins to queries that the core does not know, such as the add-ons of an engine.
 * For objects at namespace level of the library that contains the base class.
 */
class CPluginKind {
 public:
  using TList = std::vector<SPluginText>();

  /**
   * @param word    query: "dynamics3d_add_ons".
   * @param of      label of the plug-in that owns these plug-ins.
   * @param header  heading of the list: "ADD-ONS OF ...".
   */
  CPluginKind(const std::string& word, const std::string& of, const std::string& header,
              TList* list);
};

/**
 * Describes registered plug-ins, for `argos3 -q`.
 * @param query  "actuators", "sensors", "physics_engines", "media", "visualizations", "entities",
 * "robot_types", "fields", "built_in_metrics", "controllers" or "loop_functions", or the word of a
 * CPluginKind: a list of that kind; "all": all lists; otherwise: the documentation of every plug-in
 * whose label contains the query (case-sensitive), followed by its own plug-ins.
 */
std::string DescribePlugins(const std::string& query);

/** Prints DescribePlugins() on LOG, without colours, and flushes it. */
void QueryPlugins(const std::string& query);

}  // namespace argos

#endif
