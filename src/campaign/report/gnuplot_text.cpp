#include <argos3/campaign/report/gnuplot_text.h>

#include <argos3/campaign/report/report_text.h>
#include <argos3/core/utility/text/lists.h>

#include <fmt/format.h>

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

// as people write it: 0.01, 5000, 10^4, 2·10^4
std::string FormatPower(Real number) {
  constexpr Real kMin = 0.01, kMax = 1e4;
  constexpr Real kRounding = 1e-9;  // of logarithms
  if (number > kMin * (1.0 - kRounding) && number < kMax * (1.0 - kRounding)) {
    return fmt::format("{:.4g}", number);
  }
  const Real exponent = std::floor(std::log10(number) + kRounding);
  const std::string digits = fmt::format("{:.4g}", number / std::pow(10.0, exponent));
  return fmt::format("{}10^{{{:.0f}}}", digits == "1" ? "" : digits + "\u00B7", exponent);
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

std::string MakeNumberTics(const std::string& axis, const std::vector<Real>& numbers) {
  std::string list;
  for (const Real number : numbers) {
    list += (list.empty() ? "'" : ", '") + FormatPower(number) + "' " + FormatForGnuplot(number);
  }
  return fmt::format("set {}tics ({})\n", axis, list);
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
