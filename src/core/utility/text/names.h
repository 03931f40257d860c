#ifndef ARGOS3_CORE_UTILITY_TEXT_NAMES_H
#define ARGOS3_CORE_UTILITY_TEXT_NAMES_H

#include <string_view>

namespace argos {

/** @return true for ASCII letters, digits and '_', beginning with a letter. */
bool IsName(std::string_view text);

}  // namespace argos

#endif
