#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_BASE_CONFIGURABLE_RESOURCE_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_BASE_CONFIGURABLE_RESOURCE_H

#include <argos3/core/utility/configuration/argos_configuration.h>

namespace argos {

/** What everything has in common that is made from a part of the experiment file. */
class CBaseConfigurableResource {
 public:
  virtual ~CBaseConfigurableResource();

  /**
   * Makes the object ready for use. Called once.
   * @param tree  the part of the experiment file that describes it.
   * @throws CARGoSException if that part is wrong.
   */
  virtual void Init(TConfigurationNode& tree) = 0;

  /** Restores the state just after Init(). */
  virtual void Reset() = 0;

  /** Undoes Init(). Called once, before the destructor. */
  virtual void Destroy() = 0;
};

}  // namespace argos

#endif
