#ifndef ARGOS3_CORE_UTILITY_PLUGINS_PLUGIN_KIND_H
#define ARGOS3_CORE_UTILITY_PLUGINS_PLUGIN_KIND_H

#include <argos3/core/utility/plugins/factory.h>

#include <map>
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

  /** A kind that was added. */
  struct SKind {
    std::string Of; /**< label of the plug-in that owns these plug-ins */
    std::string Header; /**< heading of the list: "ADD-ONS OF ..." */
    TList* List;
  };

  /**
   * @param word    query: "dynamics3d_add_ons".
   * @param of, header, list  see SKind.
   */
  CPluginKind(const std::string& word, const std::string& of, const std::string& header,
              TList* list);

  /** All kinds that were added, by word. A copy, because lists take locks that come before the
   * mutex of this. */
  static std::map<std::string, SKind> GetAll();
};

/**
 * Describes an element of experiment files that is no plug-in, such as <distribute>, to queries and
 * schemas. For objects at namespace level of the library that reads the element.
 */
class CElementText {
 public:
  /**
   * @param tag     of the element.
   * @param author  as of a plug-in.
   * @param brief   one sentence.
   * @param manual  as the long description of a plug-in: examples in XML, and a table of attributes
   *   ("name  text", "tag@name  text" for elements inside it).
   */
  CElementText(const std::string& tag, const std::string& author, const std::string& brief,
               const std::string& manual);

  /** All that were added, by tag. */
  static std::vector<SPluginText> GetAll();
};

}  // namespace argos

#endif
