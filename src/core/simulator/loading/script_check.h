#ifndef ARGOS3_CORE_SIMULATOR_LOADING_SCRIPT_CHECK_H
#define ARGOS3_CORE_SIMULATOR_LOADING_SCRIPT_CHECK_H

namespace argos {

class CLoadErrors;
class CSpace;

/**
 * Adds an error for each function that a run would call and that the Lua script of a robot lacks,
 * which otherwise only the first tick finds.
 */
void CheckScripts(CSpace& space, CLoadErrors& errors);

}  // namespace argos

#endif
