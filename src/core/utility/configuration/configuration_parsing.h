#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_PARSING_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_PARSING_H

/*
 * Conversion of the text of an attribute or element to a value; the public interface is
 * argos_configuration.h.
 *
 * The whole text must be the value, except for blanks around it. Accepted:
 *   numbers          see ParseNumber()
 *   bool             exactly "true" or "false"
 *   std::string      the text as it is, blanks included
 *   any other type   what its operator>> reads; lists of numbers are checked field by field
 *
 * A lenient document (CConfigurationDocument::SetLenient()) also accepts what ARGoS 3 accepts, with
 * a warning: see ParseLoosely().
 */

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/non_copyable.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <istream>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <typeinfo>

namespace argos {

class CColor;
class CDegrees;
class CQuaternion;
class CRadians;
class CVector2;
class CVector3;
template <typename T>
class CRange;

namespace detail {

/**
 * Returns the expected form of a text, for error messages. Overload it for types with a special
 * form.
 */
inline std::string ExpectedText(const CColor*) {
  return "a colour name or four integers from 0 to 255, \"R,G,B,A\"";
}
inline std::string ExpectedText(const CDegrees*) {
  return "an angle in degrees, a real number";
}
inline std::string ExpectedText(const CRadians*) {
  return "an angle in radians, a real number";
}
inline std::string ExpectedText(const CVector2*) {
  return "two real numbers, \"x,y\"";
}
inline std::string ExpectedText(const CVector3*) {
  return "three real numbers, \"x,y,z\"";
}
inline std::string ExpectedText(const CQuaternion*) {
  return "three angles in degrees, about Z, Y and X, \"z,y,x\"";
}
template <typename T>
std::string ExpectedText(const CRange<T>*) {
  return "a range \"min:max\" with min <= max";
}
template <typename T>
std::string ExpectedText(const T*) {
  if constexpr (std::is_same_v<T, bool>) {
    return "\"true\" or \"false\"";
  } else if constexpr (std::is_floating_point_v<T>) {
    return "a real number";
  } else if constexpr (kIsParsableNumber<T>) {
    return "an integer from " + std::to_string(std::numeric_limits<T>::min()) + " to " +
           std::to_string(std::numeric_limits<T>::max());
  } else {
    return "a value of type " + DemangledName(typeid(T));
  }
}

/** A valid text, which few parts refuse: to find further errors. Null for texts of any form. */
inline const char* SampleText(const CColor*) {
  return "red";
}
inline const char* SampleText(const CDegrees*) {
  return "1";
}
inline const char* SampleText(const CRadians*) {
  return "1";
}
inline const char* SampleText(const CVector2*) {
  return "1,1";
}
inline const char* SampleText(const CVector3*) {
  return "1,1,1";
}
inline const char* SampleText(const CQuaternion*) {
  return "0,0,0";
}
template <typename T>
const char* SampleText(const CRange<T>*) {
  return "0:1";
}
template <typename T>
const char* SampleText(const T*) {
  if constexpr (std::is_same_v<T, bool>) {
    return "false";
  }
  return kIsParsableNumber<T> ? "1" : nullptr;
}

/** @return true if a value that was read without error is valid. */
template <typename T>
bool IsValidValue(const T&) {
  return true;
}
template <typename T>
bool IsValidValue(const CRange<T>& range) {
  return !(range.GetMin() > range.GetMax());
}

/** True for types whose text consists of real numbers, or may do so. */
template <typename T>
inline constexpr bool kHasRealNumbers = !std::is_integral_v<T> && !std::is_same_v<T, std::string>;

/** An input stream over a text that is not copied; strict, or loose (SetLooseParsing()). */
class CTextReader : private CNonCopyable {
 public:
  explicit CTextReader(const char* text, bool strict = true);
  ~CTextReader();

  std::istream& Stream() { return m_stream; }

  /** @return true if reading succeeded and only blanks are left. */
  bool Finish();

 private:
  class CBuffer : public std::streambuf {
   public:
    explicit CBuffer(const char* text);
  };

  CBuffer m_buffer;
  std::istream m_stream;
};

/**
 * Converts a text to a value.
 * @param value   the result; unspecified if the function returns false.
 * @param reason  details of a failure, or empty.
 */
template <typename T>
bool ParseText(const char* text, T& value, std::string& reason) {
  if constexpr (std::is_same_v<T, std::string>) {
    value = text;
    return true;
  } else if constexpr (std::is_same_v<T, bool>) {
    const std::string_view word(text);
    value = word == "true";
    return value || word == "false";
  } else if constexpr (kIsParsableNumber<T>) {
    const ENumberParsing outcome = ParseNumber(text, value);
    if (outcome == ENumberParsing::TrailingText) {
      reason = "text follows the number";
    } else if (outcome == ENumberParsing::OutOfRange) {
      reason = "the number is out of range";
    } else if (outcome == ENumberParsing::NotWhole) {
      reason = "the number is not whole";
    }
    return outcome == ENumberParsing::Ok;
  } else {
    try {
      CTextReader reader(text);
      reader.Stream() >> value;
      return reader.Finish() && IsValidValue(value);
    } catch (CARGoSException& ex) {
      reason = ex.what();
      return false;
    }
  }
}

/**
 * Converts a text that ParseText() refuses as ARGoS 3 does: what follows a number is ignored, as
 * are further fields of a list; a field that is not a number is 0.
 * @return false if it is an error there, too.
 */
template <typename T>
bool ParseLoosely(const char* text, T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    return false;
  } else {
    try {
      CTextReader reader(text, false);
      if constexpr (std::is_integral_v<T> && sizeof(T) == 1) {
        int number = 0;  // the stream would read a character
        reader.Stream() >> number;
        value = static_cast<T>(number);
      } else {
        reader.Stream() >> value;
      }
      return !reader.Stream().fail();
    } catch (CARGoSException&) {
      return false;
    }
  }
}

/**
 * Converts a value to text: real numbers keep all their digits, 8-bit integers are written as
 * numbers, booleans as "true" or "false".
 */
std::string FormatReal(float value);
std::string FormatReal(double value);

template <typename T>
std::string FormatText(const T& value) {
  if constexpr (std::is_same_v<T, float> || std::is_same_v<T, double>) {
    return FormatReal(value);
  } else {
    CTextOutput stream;
    stream.precision(std::numeric_limits<Real>::max_digits10);
    stream << std::boolalpha << value;
    return stream.str();
  }
}

}  // namespace detail
}  // namespace argos

#endif
