#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_MEDIUM_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_MEDIUM_H

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <string>

namespace argos {

/*
 * How devices find the medium that they use, for the sources of plug-ins.
 *
 * kind: what the medium is for, as in "an LED medium", for messages.
 */

/**
 * The medium that the required attribute `medium` of a device names.
 * @throws CARGoSException if there is none of that id, or it is not a MEDIUM.
 */
template <typename MEDIUM>
MEDIUM& GetDeviceMedium(CSimulator& simulator, TConfigurationNode& device,
                        const std::string& kind) {
  std::string id;
  GetNodeAttribute(device, "medium", id);
  simulator.ThrowIfBroken(id);
  try {
    return simulator.GetMedium<MEDIUM>(id);
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(OwnerOf(device) << ": attribute \"medium\" must be the id of a "
                                                << kind << " medium, got \"" << id << "\"",
                                error);
  }
}

/**
 * The only MEDIUM there is, null if there is none.
 * @throws CARGoSException that asks for the attribute `medium` if there are several.
 */
template <typename MEDIUM>
MEDIUM* FindOnlyMedium(CSimulator& simulator, const TConfigurationNode& device) {
  MEDIUM* found = nullptr;
  for (CMedium* medium : simulator.GetMedia()) {
    auto* const candidate = dynamic_cast<MEDIUM*>(medium);
    if (candidate == nullptr) {
      continue;
    }
    if (found != nullptr) {
      THROW_ARGOSEXCEPTION(OwnerOf(device) << ": there are several media for it, \""
                                           << found->GetId() << "\" and \"" << candidate->GetId()
                                           << "\" among them; say which one with the attribute "
                                           << "\"medium\"");
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
