#ifndef ARGOS3_PLUGINS_ENTITIES_READ_MEDIUM_H
#define ARGOS3_PLUGINS_ENTITIES_READ_MEDIUM_H

#include <argos3/core/simulator/context/load_errors.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <string>

namespace argos {

/**
 * Returns the medium given by a required attribute of an element; for the sources of entities and
 * devices.
 * @tparam MEDIUM  a medium, or an interface of a kind of media.
 * @param kind  expected kind, for the message: "an LED medium".
 * @throws CARGoSException if the attribute is missing, or is not the id of such a medium.
 */
template <class MEDIUM>
MEDIUM& ReadMedium(TConfigurationNode& node, CSimulator& simulator, const std::string& kind,
                   const std::string& attribute = "medium") {
  std::string id;
  GetNodeAttribute(node, attribute, id);
  try {
    return simulator.GetMedium<MEDIUM>(id);
  } catch (const CAlreadyReported&) {
    throw;
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(OwnerOf(node)
                                    << ": attribute \"" << attribute << "\" must be the id of "
                                    << kind << ", got \"" << id << "\"",
                                error);
  }
}

}  // namespace argos

#endif
