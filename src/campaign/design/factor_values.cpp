#include <argos3/campaign/design/factor_values.h>

#include <argos3/campaign/design/element_reading.h>
#include <argos3/campaign/design/expression.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace argos {

namespace {

constexpr Real kMaxValues = 100000.0;

// calls use(character, index) for the characters outside of expressions
template <typename USE>
void VisitOutside(const std::string& text, const USE& use) {
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '{' && i + 1 < text.size() && text[i + 1] == '{') {
      ++i;
    } else if (text[i] == '{') {
      i = FindEndOfExpression(text, i);
      if (i == std::string::npos) {
        THROW_ARGOSEXCEPTION("\"" << text << "\": '{' without '}'");
      }
    } else {
      use(text[i], i);
    }
  }
}

std::vector<std::string> SplitAt(const std::string& text, char separator) {
  std::vector<std::string> parts;
  size_t start = 0;
  VisitOutside(text, [&](char c, size_t index) {
    if (c == separator) {
      parts.push_back(TrimBlanks(text.substr(start, index - start)));
      start = index + 1;
    }
  });
  parts.push_back(TrimBlanks(text.substr(start)));
  return parts;
}

// the numbers between colons; empty if it is another text
std::vector<Real> ParseColons(const std::string& text) {
  std::vector<Real> numbers;
  size_t start = 0;
  while (start <= text.size()) {
    const size_t end = std::min(text.find(':', start), text.size());
    Real number = 0.0;
    if (ParseNumber(text.substr(start, end - start), number) != ENumberParsing::Ok) {
      return {};
    }
    numbers.push_back(number);
    start = end + 1;
  }
  return numbers.size() == 2 || numbers.size() == 3 ? numbers : std::vector<Real>();
}

std::string FormatValue(Real value) {
  // adding 0 turns -0 into 0
  return fmt::format("{:.12g}", value + 0.0);
}

void AddRange(const std::string& text, const std::vector<Real>& numbers,
              std::vector<std::string>& values) {
  const Real first = numbers[0];
  const Real last = numbers[1];
  const Real step = numbers.size() == 3 ? numbers[2] : 1.0;
  if (step == 0.0 || (last - first) / step < 0.0) {
    THROW_ARGOSEXCEPTION("\"" << text << "\": steps of " << step << " do not lead from " << first
                              << " to " << last);
  }
  // a tolerance gives 0:1:0.1 its 11 numbers in spite of rounding
  constexpr Real kTolerance = 1e-9;
  const Real count = std::floor((last - first) / step * (1.0 + kTolerance) + kTolerance) + 1.0;
  if (!(count <= kMaxValues)) {
    THROW_ARGOSEXCEPTION("\"" << text << "\": more than " << kMaxValues << " numbers");
  }
  for (int i = 0; i < static_cast<int>(count); ++i) {
    values.push_back(FormatValue(first + i * step));
  }
}

}  // namespace

std::string SFactorRange::ValueAt(Real place) const {
  Real value = IsLogarithmic ? Min * std::pow(Max / Min, place) : Min + (Max - Min) * place;
  if (IsInteger) {
    // bounds need not be whole
    value = std::clamp(std::round(value), std::ceil(Min), std::floor(Max));
  }
  return FormatValue(value);
}

std::vector<std::string> SplitValues(const std::string& text) {
  bool hasSemicolon = false;
  VisitOutside(text, [&](char c, size_t) { hasSemicolon = hasSemicolon || c == ';'; });
  std::vector<std::string> values;
  for (const std::string& part : SplitAt(text, hasSemicolon ? ';' : ',')) {
    if (part.empty()) {
      THROW_ARGOSEXCEPTION("\"" << text << "\": a value is empty");
    }
    const std::vector<Real> numbers = ParseColons(part);
    if (numbers.empty()) {
      values.push_back(part);
    } else {
      AddRange(part, numbers, values);
    }
  }
  return values;
}

std::vector<std::string> ComputeSteps(const SFactorRange& range, UInt32 count) {
  std::vector<std::string> values;
  for (UInt32 i = 0; i < count; ++i) {
    const std::string value = range.ValueAt(static_cast<Real>(i) / (count - 1));
    // several steps may be rounded to one whole number
    if (values.empty() || values.back() != value) {
      values.push_back(value);
    }
  }
  return values;
}

std::vector<std::string> DrawValues(const SFactorRange& range, UInt32 count,
                                    CRandomStream& random) {
  std::vector<std::string> values;
  for (UInt32 i = 0; i < count; ++i) {
    values.push_back(range.ValueAt(random.Uniform01()));
  }
  return values;
}

std::vector<UInt32> ParseSeeds(const std::string& text) {
  std::vector<UInt32> seeds;
  std::set<UInt32> known;
  for (const std::string& value : SplitValues(text)) {
    UInt32 seed = 0;
    if (ParseNumber(value, seed) != ENumberParsing::Ok || seed == 0) {
      THROW_ARGOSEXCEPTION(
          "\"" << value << "\" is not a seed: expected a whole number from 1 to 4294967295");
    }
    if (!known.insert(seed).second) {
      THROW_ARGOSEXCEPTION("the seed " << seed << " is given twice");
    }
    seeds.push_back(seed);
  }
  return seeds;
}

}  // namespace argos
