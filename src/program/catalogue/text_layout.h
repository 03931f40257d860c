#ifndef ARGOS3_PROGRAM_CATALOGUE_TEXT_LAYOUT_H
#define ARGOS3_PROGRAM_CATALOGUE_TEXT_LAYOUT_H

#include <string>

namespace argos {

/** Columns of texts for terminals. */
constexpr std::size_t kTextWidth = 80;

/** Number of blanks before the first word. */
std::size_t IndentOf(const std::string& line);

/**
 * Fills lines with the words of a text; a newline in it begins a new line.
 * @param indent  of all lines. @param hanging  more indentation, of all lines but the first.
 */
std::string Wrapped(const std::string& text, std::size_t indent, std::size_t hanging = 0);

/** A manual with lines of at most kTextWidth columns, but for its XML. */
std::string WrappedManual(const std::string& manual);

}  // namespace argos

#endif
