#ifndef ARGOS3_CORE_UTILITY_LOGGING_ARGOS_COLORED_TEXT_H
#define ARGOS3_CORE_UTILITY_LOGGING_ARGOS_COLORED_TEXT_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <iostream>

namespace argos {

/** Text attributes of a terminal. Source of the values: ECMA-48, "select graphic rendition". */
enum EARGoSLogAttributes {
  ARGOS_LOG_ATTRIBUTE_RESET = 0,
  ARGOS_LOG_ATTRIBUTE_BRIGHT = 1,
  ARGOS_LOG_ATTRIBUTE_DIM = 2,
  ARGOS_LOG_ATTRIBUTE_UNDERSCORE = 3,
  ARGOS_LOG_ATTRIBUTE_BLINK = 5,
  ARGOS_LOG_ATTRIBUTE_REVERSE = 7,
  ARGOS_LOG_ATTRIBUTE_HIDDEN = 8
};

/** Text colours of a terminal; the escape sequence uses 30 plus this. */
enum EARGoSLogColors {
  ARGOS_LOG_COLOR_BLACK = 0,
  ARGOS_LOG_COLOR_RED = 1,
  ARGOS_LOG_COLOR_GREEN = 2,
  ARGOS_LOG_COLOR_YELLOW = 3,
  ARGOS_LOG_COLOR_BLUE = 4,
  ARGOS_LOG_COLOR_MAGENTA = 5,
  ARGOS_LOG_COLOR_CYAN = 6,
  ARGOS_LOG_COLOR_WHITE = 7
};

/** A text colour and attribute. Streaming it emits the escape sequence that switches to it. */
struct SLogColor {
  UInt8 Attribute;
  UInt8 Foreground;

  /** Resets the terminal's colours, white foreground. */
  SLogColor() : Attribute(ARGOS_LOG_ATTRIBUTE_RESET), Foreground(ARGOS_LOG_COLOR_WHITE) {}

  SLogColor(EARGoSLogAttributes attribute, EARGoSLogColors foreground)
      : Attribute(static_cast<UInt8>(attribute)), Foreground(static_cast<UInt8>(foreground)) {}
};

/** Emits ESC "[" attribute ";3" foreground "m". */
std::ostream& operator<<(std::ostream& stream, const SLogColor& color);

/** Stream manipulators: bright text of the colour, until reset. */
std::ostream& red(std::ostream& stream);
std::ostream& green(std::ostream& stream);
std::ostream& yellow(std::ostream& stream);
std::ostream& blue(std::ostream& stream);
std::ostream& magenta(std::ostream& stream);
std::ostream& cyan(std::ostream& stream);
std::ostream& white(std::ostream& stream);

/** Stream manipulator: back to the terminal's normal text. */
std::ostream& reset(std::ostream& stream);

}  // namespace argos

#endif
