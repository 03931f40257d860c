#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_READ_SETTINGS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_READ_SETTINGS_H

#include <argos3/core/utility/configuration/argos_configuration.h>

namespace argos {

struct SRigidSettings;

/**
 * Reads the parameters of contacts, solver and sleep from the element of an engine; other settings
 * keep their values.
 * @throws CARGoSException if a value is out of its range.
 */
void ReadRigidSettings(TConfigurationNode& tree, SRigidSettings& settings);

}  // namespace argos

#endif
