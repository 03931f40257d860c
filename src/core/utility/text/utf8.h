#ifndef ARGOS3_CORE_UTILITY_TEXT_UTF8_H
#define ARGOS3_CORE_UTILITY_TEXT_UTF8_H

#include <cstddef>
#include <string_view>

namespace argos {

/**
 * Bytes of the UTF-8 character at the beginning of a text; 0 if there is none: the text is empty,
 * or begins with a byte that begins no character, an overlong form, a surrogate, or a number beyond
 * Unicode.
 */
std::size_t CountUtf8Bytes(std::string_view text);

/** The longest beginning of a text that has at most @p bytes and ends with a whole character. */
std::string_view CutUtf8(std::string_view text, std::size_t bytes);

}  // namespace argos

#endif
