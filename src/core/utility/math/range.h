#ifndef ARGOS3_CORE_UTILITY_MATH_RANGE_H
#define ARGOS3_CORE_UTILITY_MATH_RANGE_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <cctype>
#include <cmath>
#include <istream>
#include <ostream>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>

namespace argos {

/** Wrapping of a value into a period, for CRange::WrapValue() and the normalisation of angles. */
namespace math_detail {

/**
 * Adds or subtracts span until the value lies in [min,max].
 *
 * Values more than a few turns away are first reduced by an exact remainder, so the time is
 * bounded; an infinite value gives NaN, NaN stays NaN, and a span that is not positive gives min.
 */
inline Real WrapReal(Real value, Real min, Real max, Real span) {
  constexpr Real kTurnsByRepetition = 8.0;
  if (!(span > 0.0)) {
    return min;
  }
  if (value > max + kTurnsByRepetition * span || value < min - kTurnsByRepetition * span) {
    // a whole number of spans plus the remainder, which is exact for angles
    value = (min - std::fmod(min, span)) + std::fmod(value, span);
  }
  while (value > max) {
    value -= span;
  }
  while (value < min) {
    value += span;
  }
  return value;
}

/** The same for integers, in modular arithmetic so that differences cannot overflow. */
template <typename T>
constexpr T WrapInteger(T value, T min, T max) {
  using TUnsigned = std::make_unsigned_t<T>;
  const TUnsigned span =
      static_cast<TUnsigned>(static_cast<TUnsigned>(max) - static_cast<TUnsigned>(min));
  if (span == 0) {
    return min;
  }
  const bool above = value > max;
  if (!above && !(value < min)) {
    return value;
  }
  const TUnsigned excess =
      static_cast<TUnsigned>(above ? static_cast<TUnsigned>(value) - static_cast<TUnsigned>(max)
                                   : static_cast<TUnsigned>(min) - static_cast<TUnsigned>(value));
  const TUnsigned overshoot = static_cast<TUnsigned>((span - excess % span) % span);
  return static_cast<T>(above ? static_cast<TUnsigned>(max) - overshoot
                              : static_cast<TUnsigned>(min) + overshoot);
}

/** True for angle types, which hold one Real behind GetValue() and SetValue(). */
template <typename T, typename = void>
struct SHoldsReal : std::false_type {};

template <typename T>
struct SHoldsReal<
    T, std::void_t<decltype(std::declval<T&>().SetValue(std::declval<const T&>().GetValue()))> >
    : std::true_type {};

}  // namespace math_detail

/**
 * An interval between two values of any type with <=, <, > and -.
 *
 * T may be Real, an integer (also unsigned), CRadians, CDegrees or CVector3 (ordered in every
 * component). A range is inverted if its minimum exceeds its maximum; this is checked in the
 * constructor from two values in builds without NDEBUG, and always when reading from text.
 */
template <typename T>
class CRange {
 public:
  /** @throws CARGoSException if min <= max does not hold, in builds without NDEBUG. */
  constexpr CRange(const T& min = T(), const T& max = T()) : m_min(min), m_max(max) {
    if (!(m_min <= m_max)) {
      RejectInverted();
    }
  }

  constexpr T GetMin() const { return m_min; }

  /** Not checked against the maximum, which may be set next. */
  constexpr void SetMin(const T& min) { m_min = min; }

  constexpr T GetMax() const { return m_max; }

  /** Not checked against the minimum, which may be set next. */
  constexpr void SetMax(const T& max) { m_max = max; }

  /** Returns max - min, computed in T. */
  constexpr T GetSpan() const { return static_cast<T>(m_max - m_min); }

  /** @throws CARGoSException if min <= max does not hold, in builds without NDEBUG. */
  constexpr void Set(const T& min, const T& max) { *this = CRange(min, max); }

  constexpr bool WithinMinBoundIncludedMaxBoundIncluded(const T& value) const {
    return m_min <= value && value <= m_max;
  }

  constexpr bool WithinMinBoundIncludedMaxBoundExcluded(const T& value) const {
    return m_min <= value && value < m_max;
  }

  constexpr bool WithinMinBoundExcludedMaxBoundIncluded(const T& value) const {
    return m_min < value && value <= m_max;
  }

  constexpr bool WithinMinBoundExcludedMaxBoundExcluded(const T& value) const {
    return m_min < value && value < m_max;
  }

  /** Clamps the value in place. */
  constexpr void TruncValue(T& value) const {
    if (value > m_max) {
      value = m_max;
    }
    if (value < m_min) {
      value = m_min;
    }
  }

  /**
   * Clamps the value and returns its relative position in the range, 0 for the minimum and 1 for
   * the maximum; 0 if the span is 0.
   */
  constexpr Real NormalizeValue(const T& value) const {
    T clamped = value;
    TruncValue(clamped);
    if (m_max <= m_min) {
      return 0.0;
    }
    if constexpr (std::is_arithmetic_v<T>) {
      // it is computed in Real, because the span of a signed integer may overflow its type
      const Real min = static_cast<Real>(m_min);
      return (static_cast<Real>(clamped) - min) / (static_cast<Real>(m_max) - min);
    } else {
      return (clamped - m_min) / (m_max - m_min);
    }
  }

  /**
   * Clamps the input to this range and returns the value at the same relative position in another
   * range.
   *
   * @tparam U  a type for which Real * U is defined; the result is converted to it (integers
   * truncate).
   */
  template <typename U>
  constexpr void MapValueIntoRange(U& output, const T& input, const CRange<U>& range) const {
    output = static_cast<U>(NormalizeValue(input) * range.GetSpan() + range.GetMin());
  }

  /**
   * Adds or subtracts the span until the value is inside [min,max]; a value on a bound stays.
   *
   * Takes bounded time for numbers and angles: see math_detail::WrapReal(). A span of 0 gives min.
   */
  constexpr void WrapValue(T& value) const {
    if constexpr (std::is_floating_point_v<T>) {
      value = static_cast<T>(math_detail::WrapReal(value, m_min, m_max, GetSpan()));
    } else if constexpr (std::is_integral_v<T>) {
      value = math_detail::WrapInteger<T>(value, m_min, m_max);
    } else if constexpr (math_detail::SHoldsReal<T>::value) {
      value.SetValue(math_detail::WrapReal(value.GetValue(), m_min.GetValue(), m_max.GetValue(),
                                           m_max.GetValue() - m_min.GetValue()));
    } else {
      WrapByRepetition(value);
    }
  }

 private:
  void RejectInverted() const {
    ARGOS_ASSERT(m_min <= m_max, "Inverted range: the minimum "
                                     << m_min << " exceeds the maximum " << m_max
                                     << "; write the smaller value first.");
  }

  // for other types, the loop stops when a step makes no progress
  constexpr void WrapByRepetition(T& value) const {
    const T span = m_max - m_min;
    for (T next = value - span; value > m_max && !(value <= next); next = value - span) {
      value = next;
    }
    for (T next = value + span; value < m_min && !(next <= value); next = value + span) {
      value = next;
    }
  }

  T m_min;
  T m_max;
};

/** Reading a range from text. */
namespace math_detail {

/**
 * @throws CARGoSException always; the text quotes the line from the given position on and gives the
 *   format of a range.
 */
[[noreturn]] void RejectRange(std::istream& is, std::streampos start, const std::string& reason);

/** Reads one bound. Rejects signed text for an unsigned type; reads 8-bit integers as numbers. */
template <typename T>
bool ReadRangeBound(std::istream& is, T& bound) {
  is >> std::ws;
  if constexpr (std::is_unsigned_v<T>) {
    if (is.peek() == '-') {
      return false;
    }
  }
  if constexpr (std::is_integral_v<T> && sizeof(T) == 1) {
    SInt32 number = 0;
    is >> number;
    bound = static_cast<T>(number);
    return !is.fail() && static_cast<SInt32>(bound) == number;
  } else {
    return static_cast<bool>(is >> bound);
  }
}

}  // namespace math_detail

/** Writes "min:max". */
template <typename T>
std::ostream& operator<<(std::ostream& os, const CRange<T>& range) {
  return os << range.GetMin() << ":" << range.GetMax();
}

/**
 * Reads "min:max"; blanks around the values are allowed.
 *
 * @throws CARGoSException if there are not exactly two values, if one of them is not of type T, or
 * if the minimum exceeds the maximum.
 */
template <typename T>
std::istream& operator>>(std::istream& is, CRange<T>& range) {
  if (!is) {
    return is;
  }
  const std::streampos start = is.tellg();
  std::string minText;
  std::getline(is, minText, ':');
  if (is.eof() || is.fail()) {
    math_detail::RejectRange(is, start, "':' is missing");
  }

  T min = T();
  T max = T();
  CTextInput minStream(minText);
  if (!math_detail::ReadRangeBound(minStream, min) || !(minStream >> std::ws).eof()) {
    math_detail::RejectRange(is, start, "the minimum is not valid");
  }
  if (!math_detail::ReadRangeBound(is, max)) {
    math_detail::RejectRange(is, start, "the maximum is not valid");
  }
  const int next = is.eof() ? std::istream::traits_type::eof() : is.peek();
  if (next != std::istream::traits_type::eof() && std::isspace(next) == 0) {
    math_detail::RejectRange(is, start, "text follows the maximum");
  }

  if (!(min <= max)) {
    THROW_ARGOSEXCEPTION("Inverted range: the minimum " << min << " exceeds the maximum " << max
                                                        << "; write the smaller value first.");
  }
  range.Set(min, max);
  return is;
}

}  // namespace argos

#endif
