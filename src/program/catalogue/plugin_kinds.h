#ifndef ARGOS3_PROGRAM_CATALOGUE_PLUGIN_KINDS_H
#define ARGOS3_PROGRAM_CATALOGUE_PLUGIN_KINDS_H

#include <argos3/core/utility/configuration/element_name.h>
#include <argos3/core/utility/plugins/plugin_kind.h>

#include <string>
#include <vector>

namespace argos {

/** The plug-ins of one kind. */
struct SPluginKind {
  std::string Word; /**< argument of -q: "sensors" */
  std::string Name; /**< of one of them: "sensor" */
  std::string Section; /**< of experiment files that contains them; empty: none does */
  std::string Header;
  std::vector<SPluginText> Plugins; /**< by label; what they leave out ("undefined") is empty */
  std::string Of = ""; /**< label of the owning plug-in; empty: the core */

  bool IsOfDevices() const { return Word == "sensors" || Word == "actuators"; }
};

/** All kinds with all registered plug-ins, in the order in which they are shown. */
std::vector<SPluginKind> ListPluginKinds();

/** "leds" of "leds (default)"; other labels as they are. */
inline std::string TagOf(const std::string& label) {
  return SElementName::FromLabel(label).Tag;
}

/** @return true for the plug-ins that come with the program. */
bool IsOwn(const SPluginText& plugin);

/** How CMake links a library of the program: "ARGoS::genericrobot"; "" for others. */
std::string LinkTargetOf(const std::string& library);

}  // namespace argos

#endif
