#ifndef ARGOS3_CORE_UTILITY_TEXT_LISTS_H
#define ARGOS3_CORE_UTILITY_TEXT_LISTS_H

#include <string>
#include <string_view>

namespace argos {

/** Appends an item to a list in a message: a, b, c. */
inline void AppendItem(std::string& list, std::string_view item) {
  if (!list.empty()) {
    list += ", ";
  }
  list += item;
}

/** Appends an item in quotes: "a", "b". */
inline void AppendQuoted(std::string& list, std::string_view item) {
  AppendItem(list, "\"");
  list += item;
  list += '"';
}

/** The items of a container of texts as a list. */
template <typename TEXTS>
std::string JoinItems(const TEXTS& texts) {
  std::string list;
  for (const std::string_view text : texts) {
    AppendItem(list, text);
  }
  return list;
}

}  // namespace argos

#endif
