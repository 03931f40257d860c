#ifndef ARGOS3_PLUGINS_OUTPUTS_TABLES_RUN_HEADER_H
#define ARGOS3_PLUGINS_OUTPUTS_TABLES_RUN_HEADER_H

#include <string>
#include <utility>
#include <vector>

namespace argos {

class CSimulator;

/** Version and release of the program, such as "3.0.0-1". */
std::string GetVersionText();

/**
 * What the head of a table says about the run: experiment file, overrides, seed, ticks per second.
 */
std::vector<std::pair<std::string, std::string>> DescribeRun(CSimulator& simulator);

/**
 * What plots draw beside robots: the arena, and the outlines, seen from above, of bodies that do
 * not move by themselves, where they are now. "polygon" has corners x,y; "circle" x,y,radius; m.
 */
std::vector<std::pair<std::string, std::string>> DescribeArena(CSimulator& simulator);

}  // namespace argos

#endif
