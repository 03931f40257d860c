#ifndef ARGOS3_PLUGINS_OUTPUTS_TABLES_NUMBER_TEXT_H
#define ARGOS3_PLUGINS_OUTPUTS_TABLES_NUMBER_TEXT_H

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace argos {

/** The longest text of a number, characters. */
constexpr std::size_t kLongestNumber = 32;

/**
 * Writes a number as decimal text; nothing for NaN.
 * @param to      has room for kLongestNumber characters.
 * @param digits  significant ones, from 1 to 17, of numbers that are not whole; 0: the fewest that
 *   read back to the same number.
 * @return the end of the text.
 */
inline char* WriteNumber(char* to, double number, int digits) {
  if (std::isnan(number)) {
    return to;
  }
  char* const end = to + kLongestNumber;
  // whole numbers have all their digits: they may be colors, or numbers of something
  constexpr double kLargest = 1e15;
  const bool isWhole = std::abs(number) < kLargest && number == std::trunc(number);
  if (isWhole && !(number == 0.0 && std::signbit(number))) {
    return std::to_chars(to, end, static_cast<std::int64_t>(number)).ptr;
  }
  if (digits == 0) {
    return std::to_chars(to, end, number).ptr;
  }
  return std::to_chars(to, end, number, std::chars_format::general, digits).ptr;
}

}  // namespace argos

#endif
