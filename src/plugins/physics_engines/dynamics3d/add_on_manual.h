#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_ADD_ON_MANUAL_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_ADD_ON_MANUAL_H

#include <string>

namespace argos {

/**
 * Of the manual of an add-on: required and optional XML. Begins with a blank line.
 * @param required, optional  its XML element.
 */
inline std::string AddOnXML(const std::string& required, const std::string& optional) {
  const auto inEngine = [](const std::string& heading, const std::string& addOn) {
    return "\n" + heading + "\n\n  <dynamics3d id=\"dyn3d\">\n    " + addOn + "\n  </dynamics3d>\n";
  };
  return inEngine("REQUIRED XML", required) + inEngine("OPTIONAL XML", optional);
}

}  // namespace argos

#endif
