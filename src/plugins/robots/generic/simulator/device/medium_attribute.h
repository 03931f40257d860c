#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_MEDIUM_ATTRIBUTE_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_MEDIUM_ATTRIBUTE_H

#include <argos3/core/simulator/simulator.h>
#include <argos3/plugins/simulator/entities/read_medium.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <string>

namespace argos {

/**
 * The only MEDIUM there is, for devices that need not name one; null if there is none.
 * @throws CARGoSException that asks for the attribute `medium` if there are several.
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
                           << ": there are several media for it, \"" << found->GetId()
                           << "\" and \"" << candidate->GetId()
                           << "\" among them; say which one with the attribute \"medium\"");
    }
    found = candidate;
  }
  return found;
}

/** Has the controller of @p device a device @p tag in its @p section, "sensors" or "actuators"? */
inline bool HasDeviceBeside(const TConfigurationNode& device, const std::string& section,
                            const std::string& tag) {
  const TConfigurationNode* const own = device.Parent(false);
  TConfigurationNode* const controller = own != nullptr ? own->Parent(false) : nullptr;
  return controller != nullptr && NodeExists(*controller, section) &&
         NodeExists(GetNode(*controller, section), tag);
}

}  // namespace argos

#endif
