#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_VALUE_RANGE_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_VALUE_RANGE_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>

namespace argos {

/**
 * The values of a quantity with which all parts of the program can compute; both limits belong to
 * the range. The products of lengths, masses and their inverses stay within single precision, which
 * the physics in the plane uses, and far from overflow in double precision.
 */
struct SValueRange {
  Real Min;
  Real Max;
  const char* Unit = ""; /**< empty for numbers without unit and for those of several units */
};

/** Every real number of an element that the program itself reads lies in [-kMaxReal,kMaxReal]. */
constexpr Real kMaxReal = 1e12;

/** Numbers of any unit that must be greater than zero, unless another range is stated. */
constexpr SValueRange kPositive = {1e-9, 1e9};
/** Numbers of any unit that must not be less than zero, unless another range is stated. */
constexpr SValueRange kNotNegative = {0.0, 1e9};
/** Extents of solids: from a hundredth of a millimetre to 100 km. */
constexpr SValueRange kSolidLength = {1e-5, 1e5, "m"};
/** Masses of movable bodies: from a milligram to a million tonnes. */
constexpr SValueRange kMass = {1e-6, 1e9, "kg"};
/** Components of the fields of magnets, A m^2. */
constexpr SValueRange kField = {-1e6, 1e6};
/** Components of gravity. */
constexpr SValueRange kAcceleration = {-1e4, 1e4, "m/s^2"};

/** 'a number from 1e-06 to 1e+09 kg'. */
std::string ToText(const SValueRange& range);

/** @return true if the value is in the range; false for NaN. */
inline bool IsIn(const SValueRange& range, Real value) {
  return value >= range.Min && value <= range.Max;
}

/**
 * @param owner  owner of the value, for the message: 'box "b1"', or 'file:line: <tag>'.
 * @param what   name of the value: 'attribute "mass"'.
 * @return the value. @throws CARGoSException unless it is in the range.
 */
Real RequireIn(const SValueRange& range, Real value, const std::string& owner,
               const std::string& what);

/** The ranges that apply if a description states no other; for the documentation of plug-ins. */
extern const char* const kRangesDocumentation;

}  // namespace argos

#endif
