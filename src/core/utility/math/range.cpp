#include <argos3/core/utility/math/range.h>

#include <argos3/core/utility/math/text_input.h>

namespace argos {

namespace math_detail {

void RejectRange(std::istream& is, std::streampos start, const std::string& reason) {
  THROW_ARGOSEXCEPTION(QuoteInput(is, start) << " is not a range: " << reason
                                             << ". A range is written min:max, as in 0:1.");
}

}  // namespace math_detail

}  // namespace argos
