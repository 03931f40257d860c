#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_ELEMENT_NAME_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_ELEMENT_NAME_H

#include <compare>
#include <string>

namespace argos {

/** The name of an element: its tag and, of devices, their implementation. */
struct SElementName {
  std::string Tag;
  std::string Implementation = ""; /**< empty: there is none */

  /** @param label  of a plug-in: "leds (default)", or the tag alone. */
  static SElementName FromLabel(const std::string& label) {
    const std::size_t bracket = label.find(" (");
    if (bracket == std::string::npos) {
      return {label};
    }
    return {label.substr(0, bracket), label.substr(bracket + 2, label.size() - bracket - 3)};
  }

  /** As FromLabel() reads it. */
  std::string ToLabel() const {
    return Implementation.empty() ? Tag : Tag + " (" + Implementation + ")";
  }

  // NOLINTNEXTLINE(modernize-use-nullptr): it takes what the compiler writes for a 0
  auto operator<=>(const SElementName&) const = default;
};

}  // namespace argos

#endif
