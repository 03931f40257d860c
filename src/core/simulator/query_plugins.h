#ifndef ARGOS3_CORE_SIMULATOR_QUERY_PLUGINS_H
#define ARGOS3_CORE_SIMULATOR_QUERY_PLUGINS_H

#include <argos3/core/utility/plugins/factory.h>

#include <string>
#include <vector>

namespace argos {

/** What is known of a plug-in, for people. */
struct SPluginText {
  std::string Label;
  std::string Author;
  std::string Version;
  std::string Brief;
  std::string Long;
  std::string Status;
};

/** Of all plug-ins with this base class that are registered now, by label. */
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
 * Plug-ins of plug-ins: makes queries find a kind that the core does not know, such as the add-ons
 * of an engine. For objects at namespace level of the library that has the base class.
 */
class CPluginKind {
 public:
  using TList = std::vector<SPluginText>();

  /**
   * @param word    as the user asks for it: "dynamics3d_add_ons".
   * @param of      label of the plug-in whose plug-ins these are.
   * @param header  above the list: "ADD-ONS OF ...".
   */
  CPluginKind(const std::string& word, const std::string& of, const std::string& header,
              TList* list);
};

/**
 * Describes registered plug-ins, for `argos3 -q`.
 * @param query  "actuators", "sensors", "physics_engines", "media", "visualizations", "entities",
 *               "controllers" or "loop_functions", or the word of a CPluginKind: a list of that
 *               kind; "all": all the lists; anything else: the documentation of every plug-in whose
 *               label contains it, case counting. Its own plug-ins are listed below it.
 */
std::string DescribePlugins(const std::string& query);

/** Prints DescribePlugins() on LOG, without colours, and flushes it. */
void QueryPlugins(const std::string& query);

}  // namespace argos

#endif
