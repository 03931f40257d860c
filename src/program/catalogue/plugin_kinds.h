#ifndef ARGOS3_PROGRAM_CATALOGUE_PLUGIN_KINDS_H
#define ARGOS3_PROGRAM_CATALOGUE_PLUGIN_KINDS_H

#include <argos3/core/utility/plugins/plugin_kind.h>

#include <string>
#include <vector>

namespace argos {

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
