#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_XML_TEXT_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_XML_TEXT_H

// private: checks of XML that the parser does not make

#include <string>

namespace argos {

/** A fault of an XML text. */
struct SXmlFault {
  std::string Text; /**< says what was found and what would be right; empty: there is no fault */
  int Line = 0; /**< counted from 1 */
};

/**
 * Finds the first thing that the parser would read as something else: zero bytes, bytes that are
 * not UTF-8, '&' that begins no reference, references to entities other than the five of XML, and
 * declarations inside a DOCTYPE. Comments may contain anything but zero bytes.
 */
SXmlFault FindXmlFault(const std::string& xml);

/**
 * Converts a text to UTF-8 from the encoding that its XML declaration names: UTF-8, US-ASCII or
 * ISO-8859-1. The declaration then names UTF-8.
 * @return the fault if it is another encoding; @p xml is then unchanged.
 */
SXmlFault ConvertToUtf8(std::string& xml);

/** Names the first closing tag of another element than the open one; the parser does not. */
SXmlFault FindMismatch(const std::string& xml);

}  // namespace argos

#endif
