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
  std::string Name; /**< name of one of them: "sensor" */
  std::string Section; /**< section of experiment files that contains them; empty: none */
  std::string Header;
  std::vector<SPluginText> Plugins; /**< in order of labels; "undefined" texts are empty */
  std::string Of = ""; /**< label of the owning plug-in; empty: the core */

  bool IsOfDevices() const { return Word == "sensors" || Word == "actuators"; }
};

/** A plug-in, and the kind to which it belongs. */
struct SMatch {
  const SPluginKind* Kind;
  const SPluginText* Plugin;
};

/** All kinds with all registered plug-ins, in the order in which they are shown. */
std::vector<SPluginKind> ListPluginKinds();

/** The plug-ins of all kinds, which must exist as long as the result is used. */
std::vector<SMatch> AllOf(const std::vector<SPluginKind>& kinds);

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
