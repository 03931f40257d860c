#include <argos3/core/utility/logging/argos_colored_text.h>

namespace argos {

std::ostream& operator<<(std::ostream& stream, const SLogColor& color) {
  return stream << "\033[" << static_cast<int>(color.Attribute) << ";3"
                << static_cast<int>(color.Foreground) << 'm';
}

namespace {
std::ostream& Bright(std::ostream& stream, EARGoSLogColors color) {
  return stream << SLogColor(ARGOS_LOG_ATTRIBUTE_BRIGHT, color);
}
}  // namespace

std::ostream& red(std::ostream& stream) {
  return Bright(stream, ARGOS_LOG_COLOR_RED);
}
std::ostream& green(std::ostream& stream) {
  return Bright(stream, ARGOS_LOG_COLOR_GREEN);
}
std::ostream& yellow(std::ostream& stream) {
  return Bright(stream, ARGOS_LOG_COLOR_YELLOW);
}
std::ostream& blue(std::ostream& stream) {
  return Bright(stream, ARGOS_LOG_COLOR_BLUE);
}
std::ostream& magenta(std::ostream& stream) {
  return Bright(stream, ARGOS_LOG_COLOR_MAGENTA);
}
std::ostream& cyan(std::ostream& stream) {
  return Bright(stream, ARGOS_LOG_COLOR_CYAN);
}
std::ostream& white(std::ostream& stream) {
  return Bright(stream, ARGOS_LOG_COLOR_WHITE);
}

std::ostream& reset(std::ostream& stream) {
  return stream << "\033[0m";
}

}  // namespace argos
