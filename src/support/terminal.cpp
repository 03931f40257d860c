#include <argos3/support/terminal.h>

#include <fmt/format.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <string_view>

namespace argos {

bool IsTerminal(int file) {
  const char* const kind = std::getenv("TERM");
  return isatty(file) != 0 && (kind == nullptr || std::string_view(kind) != "dumb");
}

size_t GetTerminalWidth() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string DescribeDuration(Real seconds, UInt32 maxHours) {
  if (!(seconds < maxHours * 3600.0)) {
    return fmt::format("more than {} h", maxHours);
  }
  const auto whole = static_cast<UInt64>(std::lround(seconds));
  return whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                      : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace argos
