#include <argos3/campaign/report/gnuplot_text.h>

#include <argos3/campaign/report/report_text.h>
#include <argos3/core/utility/text/lists.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace argos {

namespace {

// P. Tol, "Colour Schemes" (2021), scheme "muted"; neighbours differ in lightness
constexpr std::array<const char*, kMaxColors> kColors = {"#332288", "#CC6677", "#44AA99",
                                                         "#DDCC77", "#882255", "#117733",
                                                         "#88CCEE", "#999933", "#AA4499"};

// letters of labels of an axis that fit side by side into 640 pixels
constexpr size_t kLettersOfAxis = 60;

// from 0.01 to below 10^4 numbers are written as they are
bool IsPlainNumber(Real number) {
  constexpr Real kMin = 0.01, kMax = 1e4;
  constexpr Real kRounding = 1e-9;  // of logarithms
  return number > kMin * (1.0 - kRounding) && number < kMax * (1.0 - kRounding);
}

// 10^4, 2·10^4
std::string FormatPower(Real number) {
  constexpr Real kRounding = 1e-9;  // of logarithms
  const Real exponent = std::floor(std::log10(number) + kRounding);
  const std::string digits = fmt::format("{:.4g}", number / std::pow(10.0, exponent));
  return fmt::format("{}10^{{{:.0f}}}", digits == "1" ? "" : digits + "\u00B7", exponent);
}

// positive numbers as labels; powers of ten if any is large or small
std::string MakeNumberTics(const std::string& axis, const std::vector<Real>& numbers) {
  const bool arePlain = std::all_of(numbers.begin(), numbers.end(), IsPlainNumber);
  std::string list;
  for (const Real number : numbers) {
    const std::string label = arePlain ? fmt::format("{:.4g}", number) : FormatPower(number);
    list += (list.empty() ? "'" : ", '") + label + "' " + FormatForGnuplot(number);
  }
  return fmt::format("set {}tics ({})\n", axis, list);
}

// 1, 2, 5, 10, ... times a power of ten, from the last one up to low to the first one from high on
std::vector<Real> ListRoundNumbers(Real low, Real high) {
  constexpr Real kTolerance = 1e-9;  // of numbers that are round themselves
  std::vector<Real> numbers;
  const auto first = static_cast<int>(std::floor(std::log10(low)));
  const auto last = static_cast<int>(std::ceil(std::log10(high)));
  for (int exponent = first; exponent <= last; ++exponent) {
    for (const Real digit : {1.0, 2.0, 5.0}) {
      const Real number = digit * std::pow(10.0, exponent);
      if (number <= low * (1.0 + kTolerance)) {
        numbers.clear();
      }
      numbers.push_back(number);
      if (number >= high * (1.0 - kTolerance)) {
        return numbers;
      }
    }
  }
  return numbers;
}

}  // namespace

const char* GetColor(size_t index) {
  return kColors.at(index);
}

std::string QuoteForGnuplot(const std::string& text) {
  std::string quoted = "'";
  for (const char c : MakeLine(text)) {
    quoted += c == '\'' ? "''" : std::string(1, c);
  }
  return quoted + "'";
}

std::string MakeStyle(const std::string& title, const std::string& xLabel,
                      const std::string& yLabel) {
  std::string style = R"(set encoding utf8
set border 3 linecolor rgb '#555555'
set tics nomirror out scale 0.5
set grid ytics linecolor rgb '#dddddd' linetype 1 linewidth 0.7
set key outside top left horizontal reverse Left samplen 1.5 noenhanced textcolor rgb '#333333'
set datafile missing 'NaN'
)";
  if (!title.empty()) {
    style += "set title " + QuoteForGnuplot(title) + " noenhanced textcolor rgb '#333333'\n";
  }
  style += "set xlabel " + QuoteForGnuplot(xLabel) + " noenhanced textcolor rgb '#333333'\n";
  style += "set ylabel " + QuoteForGnuplot(yLabel) + " noenhanced textcolor rgb '#333333'\n";
  return style;
}

std::string MakeTics(const std::string& axis,
                     const std::vector<std::pair<Real, std::string>>& placesAndLabels) {
  std::string list;
  size_t letters = 0;
  for (const auto& [place, label] : placesAndLabels) {
    AppendItem(list, QuoteForGnuplot(label) + ' ' + FormatForGnuplot(place));
    letters += label.size() + 2;
  }
  const bool isRotated = axis == "x" && letters > kLettersOfAxis;
  return fmt::format("set {}tics noenhanced{} ({})\n", axis, isRotated ? " rotate by -35" : "",
                     list);
}

std::string MakeLogarithmicAxis(const std::string& axis, Real low, Real high) {
  constexpr Real kManyDecades = 100.0;
  if (high <= low) {
    low /= kLogarithmicMargin;
    high *= kLogarithmicMargin;
  }
  const bool hasManyDecades = high >= kManyDecades * low;
  const std::vector<Real> numbers = ListRoundNumbers(low, high);
  std::vector<Real> tics;
  for (const Real number : numbers) {
    const bool isPower = std::abs(std::remainder(std::log10(number), 1.0)) < 1e-9;
    if (number >= low && number <= high && (isPower || !hasManyDecades)) {
      tics.push_back(number);
    }
  }
  if (tics.size() < 2) {
    // a narrow range is widened, so that there is something to read
    low = numbers.front();
    high = numbers.back();
    tics = numbers;
  }
  return fmt::format("set logscale {0}\nset {0}range [{1}:{2}]\n", axis, FormatForGnuplot(low),
                     FormatForGnuplot(high)) +
         MakeNumberTics(axis, tics);
}

std::string MakeTerminal(const std::string& format, UInt32 width, UInt32 height, bool isOpaque) {
  if (format == "svg") {
    return fmt::format(
        "set terminal svg size {},{} dynamic font 'DejaVu Sans,Helvetica,Arial,sans-serif,14' "
        "linewidth 1{}\n",
        width, height, isOpaque ? " background rgb 'white'" : "");
  }
  if (format == "pdf") {
    constexpr Real kPixelsPerInch = 100.0;
    return fmt::format("set terminal pdfcairo size {:.2f}in,{:.2f}in font 'DejaVu Sans,10'\n",
                       width / kPixelsPerInch, height / kPixelsPerInch);
  }
  return fmt::format(
      "set terminal pngcairo size {},{} background rgb 'white' font 'DejaVu Sans,28' linewidth 2 "
      "pointscale 2\n",
      2 * width, 2 * height);
}

std::string FormatForGnuplot(Real value) {
  return std::isfinite(value) ? fmt::format("{:.10g}", value) : "NaN";
}

}  // namespace argos
