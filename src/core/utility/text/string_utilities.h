#ifndef ARGOS3_CORE_UTILITY_TEXT_STRING_UTILITIES_H
#define ARGOS3_CORE_UTILITY_TEXT_STRING_UTILITIES_H

#include <argos3/core/config.h>  // checks the language level
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <cstdint>
#include <istream>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <typeinfo>
#include <vector>

namespace argos {

/** Prints a value through its operator<<; booleans as "true" and "false". */
template <typename T>
std::string ToString(const T& value) {
  CTextOutput stream;
  stream << std::boolalpha << value;
  return stream.str();
}

/**
 * Reads a value through its operator>>; booleans as "true" and "false". Unchecked: text that is not
 * a T gives whatever operator>> leaves in a T().
 */
template <typename T>
T FromString(const std::string& value) {
  T result = T();
  CTextInput stream(value);
  stream >> std::boolalpha >> result;
  return result;
}

/** The readable name of a type, for error messages. */
std::string DemangledName(const std::type_info& type);

/** Result of parsing a number. */
enum class ENumberParsing {
  Ok,
  /** The text does not begin with a number of that type. */
  NotANumber,
  /** Text other than blanks follows the number. */
  TrailingText,
  /** A well-formed number outside the range of the type. */
  OutOfRange,
  /** A real number that is not whole, for an integer. */
  NotWhole
};

/**
 * Parses a number that fills the whole text, except for blanks around it.
 *
 * The decimal point is '.', whatever the locale; a leading '+' is allowed. Real numbers may have an
 * exponent; "inf" and "nan" are not numbers here. An integer may be written as a real number,
 * "25.0" or "1e3"; a negative one is out of range for an unsigned type.
 * @param value  set only if the result is Ok.
 */
ENumberParsing ParseNumber(std::string_view text, float& value);
ENumberParsing ParseNumber(std::string_view text, double& value);
ENumberParsing ParseNumber(std::string_view text, long double& value);
ENumberParsing ParseNumber(std::string_view text, signed char& value);
ENumberParsing ParseNumber(std::string_view text, unsigned char& value);
ENumberParsing ParseNumber(std::string_view text, short& value);
ENumberParsing ParseNumber(std::string_view text, unsigned short& value);
ENumberParsing ParseNumber(std::string_view text, int& value);
ENumberParsing ParseNumber(std::string_view text, unsigned int& value);
ENumberParsing ParseNumber(std::string_view text, long& value);
ENumberParsing ParseNumber(std::string_view text, unsigned long& value);
ENumberParsing ParseNumber(std::string_view text, long long& value);
ENumberParsing ParseNumber(std::string_view text, unsigned long long& value);

/** True if ParseNumber() accepts T. */
template <typename T>
inline constexpr bool kIsParsableNumber =
    std::is_floating_point_v<T> ||
    (std::is_integral_v<T> && !std::is_same_v<T, bool> && !std::is_same_v<T, char> &&
     !std::is_same_v<T, wchar_t> && !std::is_same_v<T, char16_t> && !std::is_same_v<T, char32_t>);

/**
 * Makes ParseValues() strict on this stream: an invalid field, and text after the last field, are
 * then errors. Experiment files are read in this mode.
 */
void SetStrictParsing(std::istream& stream, bool strict);
bool IsStrictParsing(std::istream& stream);
/** Makes the lists of vectors and quaternions, which are strict by default, unchecked, too. */
void SetLooseParsing(std::istream& stream);
bool IsLooseParsing(std::istream& stream);

namespace detail {

/** Throw the errors of ParseValues(), the same for all types. */
[[noreturn]] void ThrowTooFewValues(std::uint32_t expected, std::uint32_t found, char delimiter);
[[noreturn]] void ThrowBadValue(const std::string& field, std::uint32_t index);
[[noreturn]] void ThrowTooManyValues(std::uint32_t expected, char delimiter);

template <typename T>
void ParseStrictField(const std::string& field, std::uint32_t index, T& value) {
  if constexpr (kIsParsableNumber<T>) {
    if (ParseNumber(field, value) != ENumberParsing::Ok) {
      ThrowBadValue(field, index);
    }
  } else {
    CTextInput fieldStream(field);
    SetStrictParsing(fieldStream, true);
    fieldStream >> value;
    if (fieldStream.fail() || !(fieldStream.clear(), fieldStream >> std::ws).eof()) {
      ThrowBadValue(field, index);
    }
  }
}

}  // namespace detail

/**
 * Reads n values separated by a delimiter. Blanks before a value are skipped.
 *
 * On an ordinary stream an invalid field is no error and yields T(), and fields after the n-th stay
 * in the stream. On a strict stream (see SetStrictParsing()) both are errors. On success the
 * stream's state is cleared, so that fail() is false at the end of the input.
 *
 * @param buffer  receives n values.
 * @throws CARGoSException if there are fewer than n fields, or, on a strict stream, if a field is
 *         not a T or there are more than n.
 */
template <typename T>
void ParseValues(std::istream& in, std::uint32_t n, T* buffer, const char delimiter = '\n') {
  const bool strict = IsStrictParsing(in);
  std::string field;
  for (std::uint32_t i = 0; i < n; ++i) {
    if (!std::getline(in, field, delimiter)) {
      detail::ThrowTooFewValues(n, i, delimiter);
    }
    if (strict) {
      // a delimiter consumed after the last field means that there is one too many
      if (i + 1 == n && !in.eof()) {
        detail::ThrowTooManyValues(n, delimiter);
      }
      detail::ParseStrictField(field, i, buffer[i]);
    } else {
      CTextInput fieldStream(field);
      T value = T();
      fieldStream >> value;
      buffer[i] = value;
    }
  }
  in.clear();
}

/** The same, from a string. */
template <typename T>
void ParseValues(const std::string& in, const std::uint32_t n, T* buffer,
                 const char delimiter = '\n') {
  CTextInput stream(in);
  ParseValues<T>(stream, n, buffer, delimiter);
}

/**
 * Appends the parts of a string to a vector. Adjacent delimiters count as one; delimiters at the
 * ends of the string are ignored.
 * @param delimiters  each of its characters is a delimiter.
 */
void Tokenize(const std::string& in, std::vector<std::string>& tokens,
              const std::string& delimiters = " ");

/** Convert ASCII letters only. */
std::string StringToUpperCase(const std::string& text);
std::string StringToLowerCase(const std::string& text);

/**
 * Replaces every occurrence in place, from left to right; the replacement is not searched again. An
 * empty original changes nothing.
 */
void Replace(std::string& buffer, const std::string& original, const std::string& replacement);

/**
 * @return true if a POSIX extended regular expression matches a part of the input; false also if
 *   the pattern is invalid.
 */
bool MatchPattern(const std::string& input, const std::string& pattern);

/**
 * Replaces each $NAME by the value of that environment variable, in place; an unset variable gives
 * an empty text. A name is a letter or '_' followed by letters, digits and '_'; a '$' without a
 * name stays.
 * @return the buffer.
 */
std::string& ExpandEnvVariables(std::string& buffer);

/**
 * The names most similar to a given one, for error messages: separated by ", ", best first.
 *
 * Similarity is the edit distance (insertion, deletion, replacement, transposition), ignoring case.
 * A name is similar if at most a third of the longer one's letters (at least one) must be edited,
 * or if one contains the other and the shorter has three letters or more.
 * @param most  maximum number of names.
 * @return empty if no name is similar.
 */
std::string NearestNames(const std::string& given, const std::vector<std::string>& candidates,
                         std::size_t most = 3);

/**
 * The end of an error message about an unknown name: '; did you mean "x"?' if a name is similar
 * (the nearest three at most), otherwise "; known: a, b, c", or "; known: none".
 */
std::string DidYouMean(const std::string& given, const std::vector<std::string>& candidates);

}  // namespace argos

#endif
