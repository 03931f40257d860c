#ifndef ARGOS3_CAMPAIGN_DESIGN_FACTOR_VALUES_H
#define ARGOS3_CAMPAIGN_DESIGN_FACTOR_VALUES_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>
#include <vector>

namespace argos {

class CRandomStream;

/** An interval of numbers from which the values of a factor are taken. */
struct SFactorRange {
  Real Min = 0.0, Max = 1.0;
  bool IsLogarithmic = false;
  bool IsInteger = false; /**< values are rounded to whole numbers from Min to Max */

  /**
   * The value at a place in the range: 0 = Min, 1 = Max, between them in proportion to the number,
   * or to its logarithm; with 12 significant digits.
   */
  std::string ValueAt(Real place) const;
};

/**
 * Splits a list of values: at ';' if there is one outside of expressions, else at ','. "a:b:step"
 * and "a:b" (step 1) are the numbers from a to b, both included.
 * @throws CARGoSException if a value is empty, if a range has a wrong step or more than 100000
 *   numbers, or if braces do not match.
 */
std::vector<std::string> SplitValues(const std::string& text);

/** Equal steps from Min to Max, both included; @p count is at least 2. */
std::vector<std::string> ComputeSteps(const SFactorRange& range, UInt32 count);

/** Independent random numbers in the range, in the order in which they are drawn. */
std::vector<std::string> DrawValues(const SFactorRange& range, UInt32 count, CRandomStream& random);

/**
 * A list of whole numbers: "3, 5, 8:12".
 * @throws CARGoSException if a part is no whole number from 1 to 2^32 - 1, or given twice.
 */
std::vector<UInt32> ParseSeeds(const std::string& text);

}  // namespace argos

#endif
