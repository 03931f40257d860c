#ifndef ARGOS3_CORE_UTILITY_ERRORS_LINE_MARKS_H
#define ARGOS3_CORE_UTILITY_ERRORS_LINE_MARKS_H

#include <argos3/core/config.h>  // checks the language level

#include <string>

namespace argos {

/**
 * Puts "[FATAL] " before each line that begins with no mark of its own ([FATAL], [WARNING], ...);
 * empty lines are left out.
 */
std::string MarkLines(const std::string& text);

}  // namespace argos

#endif
