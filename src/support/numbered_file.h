#ifndef ARGOS3_SUPPORT_NUMBERED_FILE_H
#define ARGOS3_SUPPORT_NUMBERED_FILE_H

#include <string>

namespace argos {

/**
 * The name of a file that is written once per run of a simulation: of the first run `out/run.rec`
 * itself, then `out/run.2.rec`, `out/run.3.rec`, ...
 * @param run  counted from 1.
 */
std::string NumberFile(const std::string& file, int run);

}  // namespace argos

#endif
