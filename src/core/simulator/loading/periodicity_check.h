#ifndef ARGOS3_CORE_SIMULATOR_LOADING_PERIODICITY_CHECK_H
#define ARGOS3_CORE_SIMULATOR_LOADING_PERIODICITY_CHECK_H

#include <argos3/core/utility/configuration/argos_configuration.h>

namespace argos {

class CLoadErrors;
struct SSimulationContext;

/**
 * Reports the parts of an experiment that would treat the joined sides of its arena as an end of
 * the world.
 * @param root  of the experiment file.
 */
void CheckPeriodicity(const SSimulationContext& context, TConfigurationNode& root,
                      CLoadErrors& errors);

}  // namespace argos

#endif
