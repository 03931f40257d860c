#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_READ_SETTINGS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_READ_SETTINGS_H

#include <argos3/core/utility/configuration/argos_configuration.h>

namespace argos {

struct SRigidSettings;

/**
 * Reads what the element of an engine says of contacts, solver and sleep; the rest stays.
 * @throws CARGoSException if a value is out of its range.
 */
void ReadRigidSettings(TConfigurationNode& tree, SRigidSettings& settings);

}  // namespace argos

#endif
