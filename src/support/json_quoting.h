#ifndef ARGOS3_SUPPORT_JSON_QUOTING_H
#define ARGOS3_SUPPORT_JSON_QUOTING_H

#include <string>

namespace argos {

/** @return the text as a string of JSON (RFC 8259); bytes that are no UTF-8 become U+FFFD. */
std::string QuoteForJson(const std::string& text);

}  // namespace argos

#endif
