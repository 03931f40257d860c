#include <argos3/campaign/report/report_text.h>

#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/core/utility/text/utf8.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace argos {

namespace {

constexpr const char* kReplacement = "\xEF\xBF\xBD";  // U+FFFD

template <typename TConvert>
std::string ConvertText(const std::string& text, TConvert convert) {
  std::string result;
  for (size_t i = 0; i < text.size();) {
    const size_t length = CountUtf8Bytes(std::string_view(text).substr(i));
    if (length == 0) {
      result += kReplacement;
    } else if (length == 1) {
      result += convert(text[i]);
    } else {
      result.append(text, i, length);
    }
    i += std::max<size_t>(length, 1);
  }
  return result;
}

bool IsControl(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
}

std::string EscapeForHTML(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    case '\t':
    case '\n':
      return std::string(1, c);
    default:
      return IsControl(c) ? kReplacement : std::string(1, c);
  }
}

char BlankIfControl(char c) {
  return IsControl(c) ? ' ' : c;
}

}  // namespace

std::string FormatNumber(Real value) {
  if (std::isnan(value)) {
    return "-";
  }
  // 10000, not 1e+04
  const bool isReadable = std::abs(value) >= 9999.5 && std::abs(value) < 1e6;
  return isReadable ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value);
}

std::string FormatExactly(Real value) {
  return std::isnan(value) ? "" : fmt::format("{}", value);
}

std::string FormatRange(Real lower, Real upper) {
  return FormatNumber(lower) + " to " + FormatNumber(upper);
}

std::string FormatPValue(Real value) {
  constexpr Real kMin = 0.001;
  return value < kMin ? "p < 0.001" : fmt::format("p = {:.2g}", value);
}

std::string FormatDuration(Real seconds) {
  constexpr Real kMinute = 60.0;
  if (seconds < kMinute) {
    return fmt::format("{:.3g} s", seconds);
  }
  const auto whole = static_cast<UInt64>(std::llround(seconds));
  if (whole < 3600) {
    return fmt::format("{} min {} s", whole / 60, whole % 60);
  }
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

std::string FormatLevel(Real level) {
  return fmt::format("{:.3g} %", 100.0 * level);
}

std::string EscapeHTML(const std::string& text) {
  return ConvertText(text, EscapeForHTML);
}

std::string MakeLine(const std::string& text) {
  return ConvertText(text, BlankIfControl);
}

std::string QuoteField(const std::string& text) {
  std::string line = MakeLine(text);
  if (line.find_first_of(",\"#") == std::string::npos) {
    return line;
  }
  std::string quoted = "\"";
  for (const char c : line) {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + '"';
}

std::string MakeLabel(const std::string& name, const std::string& unit) {
  std::string label = MakeLine(name);
  std::replace(label.begin(), label.end(), '_', ' ');
  return unit.empty() ? label : label + " (" + MakeLine(unit) + ")";
}

std::string DescribeProblem(const std::exception& error) {
  std::string text = error.what();
  Replace(text, "[FATAL] ", "");
  return MakeLine(text);
}

std::string Count(size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace argos
