#ifndef ARGOS3_CORE_SIMULATOR_CATALOGUE_PLUGIN_KINDS_H
#define ARGOS3_CORE_SIMULATOR_CATALOGUE_PLUGIN_KINDS_H

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
  std::string Library = ""; /**< the file that contains it */
};

/** All registered plug-ins with this base class, by label. */
template <typename TYPE>
std::vector<SPluginText> ListPlugins() {
  std::vector<SPluginText> plugins;
  for (const auto& [label, info] : CFactory<TYPE>::GetTypes()) {
    plugins.push_back({label, info.Author, info.Version, info.BriefDescription,
                       info.LongDescription, info.Status, info.Library});
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

/** The plug-ins of one kind. */
struct SPluginKind {
  std::string Word; /**< argument of -q: "sensors" */
  std::string Name; /**< of one of them: "sensor" */
  std::string Header;
  std::vector<SPluginText> Plugins; /**< by label */
  std::string Of = ""; /**< label of the owning plug-in; empty: the core */
};

/** All kinds with all registered plug-ins, in the order in which they are shown. */
std::vector<SPluginKind> ListPluginKinds();

}  // namespace argos

#endif
