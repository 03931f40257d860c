#ifndef ARGOS3_PLUGINS_MEDIA_MEDIUM_MANUAL_H
#define ARGOS3_PLUGINS_MEDIA_MEDIUM_MANUAL_H

#include <string>

namespace argos {

/*
 * Texts that the manuals of several media share: parts of the LONG_DESCRIPTION of REGISTER_MEDIUM.
 * Each one begins with a blank line. They are called while the library loads, so they use no other
 * static objects.
 */

/** "REQUIRED XML". @param medium  its XML element. */
std::string RequiredMediumXML(const std::string& medium);
/** "OPTIONAL XML". @param medium  its XML element. */
std::string OptionalMediumXML(const std::string& medium);

/**
 * Required XML, attributes and an example of a medium that is only an index.
 * @param tag, id  of its XML element.
 * @param members  what it contains, in the plural: "LEDs".
 */
std::string IndexMediumManual(const std::string& tag, const std::string& id,
                              const std::string& members);

}  // namespace argos

#endif
