#ifndef ARGOS3_CORE_UTILITY_MATH_TEXT_INPUT_H
#define ARGOS3_CORE_UTILITY_MATH_TEXT_INPUT_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <istream>
#include <string>

namespace argos {

/**
 * Returns the line from the given position on in quotes, or "The text" if the stream cannot seek.
 */
std::string QuoteInput(std::istream& is, std::streampos start);

/**
 * Reads exactly count numbers separated by commas, with blanks allowed around each.
 *
 * After SetLooseParsing() fields that are no numbers are 0 and further fields are ignored.
 *
 * Reading stops directly after the last number, so several lists may follow one another, separated
 * by blanks.
 *
 * @param buffer  the numbers, (count); changed only on success.
 * @param what    name of the value for the error message: "a 3D vector (x,y,z)".
 * @throws CARGoSException if a field is not a number, or there are too few or too many of them.
 */
void ReadNumbers(std::istream& is, Real* buffer, UInt32 count, const std::string& what);

}  // namespace argos

#endif
