#include <argos3/core/utility/text/string_utilities.h>

#include <cxxabi.h>
#include <regex.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <numeric>

namespace argos {

// numbers

namespace {

// the blanks of the C locale, which is what XML files contain
constexpr std::string_view kBlanks = " \t\n\v\f\r";

std::string_view Trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

// from_chars() does not accept a leading '+'
std::string_view WithoutPlus(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') {
    text.remove_prefix(1);
  }
  return text;
}

// a whole text, which has neither blanks nor a '+'
template <typename T>
ENumberParsing Convert(std::string_view text, T& value) {
  T result;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
  if (error == std::errc::invalid_argument) {
    return ENumberParsing::NotANumber;
  }
  if (end != text.data() + text.size()) {
    return ENumberParsing::TrailingText;
  }
  if (error == std::errc::result_out_of_range) {
    return ENumberParsing::OutOfRange;
  }
  value = result;
  return ENumberParsing::Ok;
}

template <typename T>
ENumberParsing ParseReal(std::string_view text, T& value) {
  text = WithoutPlus(Trim(text));
  // from_chars() takes "inf" and "nan" as well
  const std::size_t first = text.find_first_not_of('-');
  if (first == std::string_view::npos ||
      !(std::isdigit(static_cast<unsigned char>(text[first])) || text[first] == '.')) {
    return ENumberParsing::NotANumber;
  }
  return Convert(text, value);
}

// an integer that is written as a real number: with a decimal point or an exponent
template <typename T>
ENumberParsing ParseWhole(std::string_view text, T& value) {
  long double real = 0.0L;
  const ENumberParsing outcome = ParseReal(text, real);
  if (outcome != ENumberParsing::Ok) {
    return outcome;
  }
  if (real != std::floor(real)) {
    return ENumberParsing::NotWhole;
  }
  // the first number above the range is a power of two, which every real type represents
  const long double end = std::ldexp(1.0L, std::numeric_limits<T>::digits);
  const long double least = std::is_unsigned_v<T> ? 0.0L : -end;
  if (!(real >= least && real < end)) {
    return ENumberParsing::OutOfRange;
  }
  value = static_cast<T>(real);
  return ENumberParsing::Ok;
}

template <typename T>
ENumberParsing ParseInteger(std::string_view text, T& value) {
  if (text.find_first_of(".eE") != std::string_view::npos) {
    return ParseWhole(text, value);
  }
  text = WithoutPlus(Trim(text));
  const bool negativeUnsigned = std::is_unsigned_v<T> && text.size() > 1 && text[0] == '-';
  if (negativeUnsigned) {
    text.remove_prefix(1);
  }
  T result = 0;
  const ENumberParsing outcome = Convert(text, result);
  if (outcome != ENumberParsing::Ok) {
    return outcome;
  }
  if (negativeUnsigned && result != 0) {
    return ENumberParsing::OutOfRange;
  }
  value = result;
  return ENumberParsing::Ok;
}

}  // namespace

ENumberParsing ParseNumber(std::string_view text, float& value) {
  return ParseReal(text, value);
}
ENumberParsing ParseNumber(std::string_view text, double& value) {
  return ParseReal(text, value);
}
ENumberParsing ParseNumber(std::string_view text, long double& value) {
  return ParseReal(text, value);
}
ENumberParsing ParseNumber(std::string_view text, signed char& value) {
  return ParseInteger(text, value);
}
ENumberParsing ParseNumber(std::string_view text, unsigned char& value) {
  return ParseInteger(text, value);
}
ENumberParsing ParseNumber(std::string_view text, short& value) {
  return ParseInteger(text, value);
}
ENumberParsing ParseNumber(std::string_view text, unsigned short& value) {
  return ParseInteger(text, value);
}
ENumberParsing ParseNumber(std::string_view text, int& value) {
  return ParseInteger(text, value);
}
ENumberParsing ParseNumber(std::string_view text, unsigned int& value) {
  return ParseInteger(text, value);
}
ENumberParsing ParseNumber(std::string_view text, long& value) {
  return ParseInteger(text, value);
}
ENumberParsing ParseNumber(std::string_view text, unsigned long& value) {
  return ParseInteger(text, value);
}
ENumberParsing ParseNumber(std::string_view text, long long& value) {
  return ParseInteger(text, value);
}
ENumberParsing ParseNumber(std::string_view text, unsigned long long& value) {
  return ParseInteger(text, value);
}

// lists of values

namespace {

enum EParsingMode : long { kOrdinary, kStrict, kLoose };

// the mode of a stream
long& ParsingModeOf(std::istream& stream) {
  static const int slot = std::ios_base::xalloc();
  return stream.iword(slot);
}

std::string Quoted(char delimiter) {
  return delimiter == '\n' ? std::string("line breaks") : std::string("'") + delimiter + '\'';
}

std::string NumberOfValues(std::uint32_t n) {
  return std::to_string(n) + (n == 1 ? " value" : " values");
}

}  // namespace

void SetStrictParsing(std::istream& stream, bool strict) {
  ParsingModeOf(stream) = strict ? kStrict : kOrdinary;
}

bool IsStrictParsing(std::istream& stream) {
  return ParsingModeOf(stream) == kStrict;
}

void SetLooseParsing(std::istream& stream) {
  ParsingModeOf(stream) = kLoose;
}

bool IsLooseParsing(std::istream& stream) {
  return ParsingModeOf(stream) == kLoose;
}

namespace detail {

void ThrowTooFewValues(std::uint32_t expected, std::uint32_t found, char delimiter) {
  THROW_ARGOSEXCEPTION("found " << NumberOfValues(found) << ", expected "
                                << NumberOfValues(expected) << " separated by "
                                << Quoted(delimiter));
}

void ThrowBadValue(const std::string& field, std::uint32_t index) {
  THROW_ARGOSEXCEPTION("value number " << index + 1 << " is \"" << field
                                       << "\", which is not a valid value");
}

void ThrowTooManyValues(std::uint32_t expected, char delimiter) {
  THROW_ARGOSEXCEPTION("found more than the expected " << NumberOfValues(expected)
                                                       << " separated by " << Quoted(delimiter));
}

}  // namespace detail

// text

std::string DemangledName(const std::type_info& type) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(type.name(), nullptr, nullptr, &status), &std::free);
  std::string result(status == 0 ? name.get() : type.name());
  // remove argos::, which adds no information
  const std::string prefix = "argos::";
  std::size_t position = 0;
  while ((position = result.find(prefix, position)) != std::string::npos) {
    const bool isWholeName =
        position == 0 || (std::isalnum(static_cast<unsigned char>(result[position - 1])) == 0 &&
                          result[position - 1] != '_' && result[position - 1] != ':');
    if (isWholeName) {
      result.erase(position, prefix.size());
    } else {
      position += prefix.size();
    }
  }
  return result;
}

void Tokenize(const std::string& in, std::vector<std::string>& tokens,
              const std::string& delimiters) {
  std::size_t begin = in.find_first_not_of(delimiters);
  while (begin != std::string::npos) {
    const std::size_t end = in.find_first_of(delimiters, begin);
    tokens.push_back(in.substr(begin, end - begin));
    begin = in.find_first_not_of(delimiters, end);
  }
}

std::string StringToUpperCase(const std::string& text) {
  std::string result(text);
  for (char& c : result) {
    c = (c >= 'a' && c <= 'z') ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return result;
}

std::string StringToLowerCase(const std::string& text) {
  std::string result(text);
  for (char& c : result) {
    c = (c >= 'A' && c <= 'Z') ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return result;
}

void Replace(std::string& buffer, const std::string& original, const std::string& replacement) {
  if (original.empty()) {
    return;
  }
  std::size_t position = 0;
  while ((position = buffer.find(original, position)) != std::string::npos) {
    buffer.replace(position, original.size(), replacement);
    position += replacement.size();
  }
}

bool MatchPattern(const std::string& input, const std::string& pattern) {
  regex_t expression;
  if (regcomp(&expression, pattern.c_str(), REG_EXTENDED | REG_NOSUB) != 0) {
    return false;
  }
  const bool matches = regexec(&expression, input.c_str(), 0, nullptr, 0) == 0;
  regfree(&expression);
  return matches;
}

std::string& ExpandEnvVariables(std::string& buffer) {
  const auto isNameStart = [](char c) {
    return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  };
  std::string expanded;
  std::size_t position = 0;
  while (position < buffer.size()) {
    if (buffer[position] != '$' || position + 1 == buffer.size() ||
        !isNameStart(buffer[position + 1])) {
      expanded += buffer[position++];
      continue;
    }
    std::size_t end = position + 2;
    while (end < buffer.size() &&
           (isNameStart(buffer[end]) || (buffer[end] >= '0' && buffer[end] <= '9'))) {
      ++end;
    }
    const char* value = std::getenv(buffer.substr(position + 1, end - position - 1).c_str());
    expanded += value != nullptr ? value : "";
    position = end;
  }
  buffer.swap(expanded);
  return buffer;
}

// similar names

namespace {

// optimal string alignment: insertions, deletions, replacements, swaps of neighbours count 1 each.
// Source: Damerau, A technique for computer detection and correction of spelling errors (1964)
std::size_t EditDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> beforeLast(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> current(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t(0));
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      current[j] = std::min({last[j] + 1, current[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        current[j] = std::min(current[j], beforeLast[j - 2] + 1);
      }
    }
    beforeLast.swap(last);
    last.swap(current);
  }
  return last[b.size()];
}

bool IsNear(const std::string& a, const std::string& b, std::size_t distance) {
  const std::size_t shorter = std::min(a.size(), b.size());
  const std::size_t longer = std::max(a.size(), b.size());
  // constants of the header: a third of the letters, and three letters for a contained name
  if (distance <= std::max<std::size_t>(1, longer / 3)) {
    return distance < longer;
  }
  return shorter >= 3 && (a.find(b) != std::string::npos || b.find(a) != std::string::npos);
}

// characters; names are shorter
constexpr std::size_t kMaxComparedLength = 200;

std::vector<std::string> FindNearest(const std::string& given,
                                     const std::vector<std::string>& candidates, std::size_t most) {
  const std::string wanted = StringToLowerCase(given);
  std::vector<std::pair<std::size_t, std::string>> near;
  for (const std::string& candidate : candidates) {
    const std::string name = StringToLowerCase(candidate);
    // the edit distance takes time in proportion to the product of the lengths
    if (std::max(wanted.size(), name.size()) > kMaxComparedLength) {
      continue;
    }
    const std::size_t distance = EditDistance(wanted, name);
    if (!name.empty() && !wanted.empty() && IsNear(wanted, name, distance)) {
      near.emplace_back(distance, candidate);
    }
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  std::vector<std::string> names;
  for (std::size_t i = 0; i < near.size() && i < most; ++i) {
    names.push_back(near[i].second);
  }
  return names;
}

std::string Join(const std::vector<std::string>& names, const std::string& between) {
  std::string joined;
  for (const std::string& name : names) {
    joined += (joined.empty() ? "" : between) + name;
  }
  return joined;
}

}  // namespace

std::string NearestNames(const std::string& given, const std::vector<std::string>& candidates,
                         std::size_t most) {
  return Join(FindNearest(given, candidates, most), ", ");
}

std::string DidYouMean(const std::string& given, const std::vector<std::string>& candidates) {
  const std::vector<std::string> near = FindNearest(given, candidates, 3);
  if (!near.empty()) {
    return "; did you mean \"" + Join(near, "\" or \"") + "\"?";
  }
  return "; known: " + (candidates.empty() ? std::string("none") : Join(candidates, ", "));
}

}  // namespace argos
