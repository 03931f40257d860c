#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_MEDIUM_ATTRIBUTE_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_MEDIUM_ATTRIBUTE_H

#include <argos3/core/simulator/simulator.h>
#include <argos3/plugins/simulator/entities/read_medium.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <string>

namespace argos {

/**
 * Finds the medium for a device without the attribute `medium`.
 * @return the only MEDIUM of the experiment; null if there is none.
 * @throws CARGoSException if there are several.
 */
template <class MEDIUM>
MEDIUM* FindOnlyMedium(const TConfigurationNode& device, CSimulator& simulator) {
  MEDIUM* found = nullptr;
  for (CMedium* medium : simulator.GetMedia()) {
    auto* const candidate = dynamic_cast<MEDIUM*>(medium);
    if (candidate == nullptr) {
      continue;
    }
    if (found != nullptr) {
      THROW_ARGOSEXCEPTION(OwnerOf(device)
                           << ": several media fit, such as \"" << found->GetId() << "\" and \""
                           << candidate->GetId() << "\"; name one in the attribute \"medium\"");
    }
    found = candidate;
  }
  return found;
}

/**
 * @return true if the controller of @p device has a device @p tag in its @p section, "sensors" or
 * "actuators".
 */
inline bool HasDeviceBeside(const TConfigurationNode& device, const std::string& section,
                            const std::string& tag) {
  const TConfigurationNode* const own = device.Parent(false);
  TConfigurationNode* const controller = own != nullptr ? own->Parent(false) : nullptr;
  return controller != nullptr && NodeExists(*controller, section) &&
         NodeExists(GetNode(*controller, section), tag);
}

}  // namespace argos

#endif
