#ifndef ARGOS3_TESTING_SUPPORT_GOLDEN_TEXT_H
#define ARGOS3_TESTING_SUPPORT_GOLDEN_TEXT_H

#include <argos3/core/utility/files/file_replacement.h>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>

namespace argos {

/**
 * Checks that a text equals that of a file, line by line. If the variable ARGOS_RENEW_GOLDEN is
 * set, the text replaces the file first.
 * @param normalize  what of a line is compared, as a function of the line; by default all of it.
 */
template <typename NORMALIZE = std::identity>
void CheckGoldenText(const std::string& path, const std::string& text,
                     const NORMALIZE& normalize = {}) {
  if (std::getenv("ARGOS_RENEW_GOLDEN") != nullptr) {
    std::string problem;
    REQUIRE(ReplaceFile(path, text, problem));
  }
  std::ifstream expectedLines(path);
  REQUIRE(expectedLines.is_open());
  std::istringstream foundLines(text);
  std::string expected;
  std::string found;
  for (int line = 1; std::getline(expectedLines, expected); ++line) {
    CAPTURE(path, line);
    REQUIRE(std::getline(foundLines, found));
    REQUIRE(normalize(found) == normalize(expected));
  }
  CHECK_FALSE(std::getline(foundLines, found));
}

}  // namespace argos

#endif
