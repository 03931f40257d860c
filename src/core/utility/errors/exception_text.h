#ifndef ARGOS3_CORE_UTILITY_ERRORS_EXCEPTION_TEXT_H
#define ARGOS3_CORE_UTILITY_ERRORS_EXCEPTION_TEXT_H

#include <argos3/core/config.h>  // checks the language level

#include <string>

namespace argos {

/**
 * The text of the exception that is being handled: its what(), or the name of its type if it is not
 * a std::exception. To be called in a catch block.
 */
std::string DescribeCurrentException();

/**
 * Throws a CARGoSException with @p what, to which the text of the exception that is being handled
 * is added, whatever its type. To be called in a catch block.
 */
[[noreturn]] void ThrowWithCause(const std::string& what);

}  // namespace argos

#endif
