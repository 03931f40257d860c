#include <argos3/core/utility/configuration/value_range.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/classic_locale.h>

namespace argos {

const char* const kRangesDocumentation =
    R"(RANGES, where none is stated: real numbers from -1e12 to 1e12; those that must be > 0 from 1e-9 to 1e9; those that
must be >= 0 up to 1e9; extents of solids from 1e-5 to 1e5 m; masses of movable bodies from 1e-6 to 1e9 kg; positions
in the plane up to 1e5 m from the origin.
)";

std::string ToText(const SValueRange& range) {
  CTextOutput text;
  text << "a number from " << range.Min << " to " << range.Max;
  if (*range.Unit != '\0') {
    text << ' ' << range.Unit;
  }
  return text.str();
}

Real RequireIn(const SValueRange& range, Real value, const std::string& owner,
               const std::string& what) {
  if (!IsIn(range, value)) {
    THROW_ARGOSEXCEPTION(owner << ": " << what << " must be " << ToText(range) << ", got "
                               << value);
  }
  return value;
}

}  // namespace argos
