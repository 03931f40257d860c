#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_BASE_CONFIGURABLE_RESOURCE_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_BASE_CONFIGURABLE_RESOURCE_H

#include <argos3/core/utility/configuration/argos_configuration.h>

namespace argos {

/** Base of the classes whose objects are configured by an element of the experiment file. */
class CBaseConfigurableResource {
 public:
  virtual ~CBaseConfigurableResource();

  /**
   * Configures the object. Called once.
   * @param tree  the XML element of the object.
   * @throws CARGoSException if the element is invalid.
   */
  virtual void Init(TConfigurationNode& tree) = 0;

  /** Restores the state directly after Init(). */
  virtual void Reset() = 0;

  /** Undoes Init(). Called once, before the destructor. */
  virtual void Destroy() = 0;
};

}  // namespace argos

#endif
