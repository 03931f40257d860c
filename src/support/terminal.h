#ifndef ARGOS3_SUPPORT_TERMINAL_H
#define ARGOS3_SUPPORT_TERMINAL_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <cstddef>
#include <string>

namespace argos {

/** @return true if a file descriptor is a terminal on which a line can be erased. */
bool IsTerminal(int file);

/** Columns of the terminal that standard error goes to; 80 if they are unknown. */
size_t GetTerminalWidth();

/** "7:05" or "1:07:05"; of more than @p maxHours: "more than ... h". @param seconds  or NaN. */
std::string DescribeDuration(Real seconds, UInt32 maxHours);

}  // namespace argos

#endif
