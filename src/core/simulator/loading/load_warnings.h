#ifndef ARGOS3_CORE_SIMULATOR_LOADING_LOAD_WARNINGS_H
#define ARGOS3_CORE_SIMULATOR_LOADING_LOAD_WARNINGS_H

#include <string>
#include <vector>

namespace argos {

class CConfigurationDocument;
struct SSimulationContext;

/**
 * Returns what is suspicious in an experiment that was loaded without errors, one line each: a root
 * element of another name, empty ids, devices that are given twice, bodies outside of the arena,
 * and content that nothing has read. ARGoS 3 accepts all of it silently, so files may contain it.
 * @param mayAddRobots  code may add robots in the run: what FindUnusedControllers() gives is left
 *   out.
 */
std::vector<std::string> FindLoadWarnings(CConfigurationDocument& document,
                                          const SSimulationContext& context, bool mayAddRobots);

/**
 * One line for each controller that no robot has had, if it has contents: robots that are added in
 * the run may use them, so it is known at its end.
 */
std::vector<std::string> FindUnusedControllers(const CConfigurationDocument& document,
                                               const SSimulationContext& context);

/**
 * Writes the lines to LOGERR as warnings: the first ones, and the number of the others; all of them
 * in a CLoadingCheck.
 */
void PrintWarnings(const std::vector<std::string>& lines);

}  // namespace argos

#endif
