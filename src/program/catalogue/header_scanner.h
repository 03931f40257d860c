#ifndef ARGOS3_PROGRAM_CATALOGUE_HEADER_SCANNER_H
#define ARGOS3_PROGRAM_CATALOGUE_HEADER_SCANNER_H

#include <string>
#include <vector>

namespace argos {

/** A declaration of a class or of a file. */
struct SHeaderItem {
  std::string Code; /**< text before its body or the semicolon, on one line; or "public:", ... */
  std::string Body; /**< text between the braces of the body; "" if there is none */
  std::string Comment; /**< stands before or behind it: no asterisks, tags in words */
};

/**
 * Splits what a header, a namespace or a class contains. Knows comments, strings and nested
 * brackets, and no more of C++.
 */
std::vector<SHeaderItem> SplitDeclarations(const std::string& text);

/** The text of a comment: without asterisks, tags such as @param in words. */
std::string PlainComment(const std::string& comment);

}  // namespace argos

#endif
