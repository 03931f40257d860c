#ifndef ARGOS3_CORE_SIMULATOR_CONTEXT_LIBRARY_ATTRIBUTE_H
#define ARGOS3_CORE_SIMULATOR_CONTEXT_LIBRARY_ATTRIBUTE_H

#include <argos3/core/utility/configuration/argos_configuration.h>

namespace argos {

/**
 * Loads the library that the attribute `library` of an element names, if it has one.
 * @throws CARGoSException as CDynamicLoading::LoadLibrary(), with the element.
 */
void LoadLibraryOf(TConfigurationNode& node);

}  // namespace argos

#endif
