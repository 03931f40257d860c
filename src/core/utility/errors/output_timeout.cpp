#include <argos3/core/utility/errors/output_timeout.h>

#include <charconv>
#include <cstdlib>
#include <string_view>

namespace argos {

std::chrono::milliseconds GetOutputTimeout() {
  constexpr double kDefault = 30.0;  // s
  constexpr double kShortest = 0.1;
  constexpr double kMaxLength = 1e6;
  double seconds = kDefault;
  const char* const set = std::getenv("ARGOS_OUTPUT_TIMEOUT");
  if (set != nullptr) {
    const std::string_view text(set);
    double number = 0.0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
    if (result.ec == std::errc() && number >= kShortest && number <= kMaxLength) {
      seconds = number;
    }
  }
  return std::chrono::milliseconds(static_cast<long>(1e3 * seconds));
}

std::string DescribeOutputTimeout() {
  const auto milliseconds = GetOutputTimeout().count();
  const std::string fraction = std::to_string(milliseconds % 1000 / 100);
  return std::to_string(milliseconds / 1000) + (fraction == "0" ? "" : "." + fraction) +
         " s (ARGOS_OUTPUT_TIMEOUT)";
}

}  // namespace argos
