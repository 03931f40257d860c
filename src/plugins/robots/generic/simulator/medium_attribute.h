#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_MEDIUM_ATTRIBUTE_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_MEDIUM_ATTRIBUTE_H

#include <argos3/core/simulator/load_errors.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <string>

namespace argos {

/**
 * The medium that the required attribute `medium` of a device's element names; for the sources of
 * devices.
 * @param kind  what it must be, for the message: "an LED medium".
 * @throws CARGoSException if the attribute is missing, or names no medium of that kind.
 */
template <class MEDIUM>
MEDIUM& ReadMedium(TConfigurationNode& device, CSimulator& simulator, const std::string& kind) {
  std::string id;
  GetNodeAttribute(device, "medium", id);
  try {
    return simulator.GetMedium<MEDIUM>(id);
  } catch (const CAlreadyReported&) {
    throw;
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(OwnerOf(device) << ": attribute \"medium\" must be the id of "
                                                << kind << ", got \"" << id << "\"",
                                error);
  }
}

}  // namespace argos

#endif
