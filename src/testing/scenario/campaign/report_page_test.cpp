// The page of a report, as a browser shows it, and the options of the command.

#include "../command_line/program_run.h"
#include "campaign_world.h"

#include <argos3/core/simulator/images/image_file.h>
#include <argos3/support/child_process.h>

#include <catch2/catch.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace report_page_test {

using namespace argos;

namespace {

constexpr std::array<int, 2> kWidths = {1280, 390};  // of a desktop and of a phone, pixels
constexpr int kHeight = 6000;  // of the view, pixels: more than the page has

/* Pixels of the view, from its upper left corner. */
struct SBox {
  double Left, Top, Width, Height;
};

/* How a page is laid out at a width. */
struct SLayout {
  double ContentWidth = 0.0;
  std::vector<SBox> Figures;
};

std::string FindBrowser() {
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
    const std::string path = FindProgram(name);
    if (!path.empty()) {
      return path;
    }
  }
  return "";
}

// with an argument such as --dump-dom; a browser that hangs is ended
bool RunBrowser(const CTestFolder& folder, const std::string& argument, int width) {
  const std::string command = fmt::format(
      "cd '{0}' && timeout 60 '{1}' --headless --no-sandbox --disable-gpu --hide-scrollbars "
      "--force-device-scale-factor=1 --user-data-dir='{0}/profile' --window-size={2},{3} {4} "
      "'file://{0}/view.html' > browser.out 2> browser.err",
      folder.Path("."), FindBrowser(), width, kHeight, argument);
  return std::system(command.c_str()) == 0;
}

/*
 * The page in frames of all widths, side by side: a browser's window has a smallest width. Each
 * frame sends its layout, which the view writes into its body, as lines "LAYOUT width
 * left,top,...".
 */
void WriteView(const CTestFolder& folder) {
  std::string page = folder.Read("c.report/report.html");
  page.insert(page.find("</body>"), R"(<script>
addEventListener("load", () => {
  const boxes = [...document.querySelectorAll("figure svg")].map((svg) => {
    const box = svg.getBoundingClientRect();
    return [box.left, box.top, box.width, box.height].join(",");
  });
  parent.postMessage([innerWidth, document.documentElement.scrollWidth, ...boxes].join(" "), "*");
});
</script>)");
  folder.Write("page.html", page);
  std::string view =
      "<!DOCTYPE html><html><body style='margin:0;background:#fff'><script>\n"
      "addEventListener('message', (event) => {\n"
      "  const line = document.createElement('i');\n"
      "  line.hidden = true;\n"
      "  line.textContent = 'LAYOUT ' + event.data + ';';\n"
      "  document.body.append(line);\n});\n</script>";
  int left = 0;
  for (const int width : kWidths) {
    view += fmt::format(
        "<iframe src='page.html' style='position:absolute;left:{}px;top:0;border:0;width:{}px;"
        "height:{}px'></iframe>",
        left, width, kHeight);
    left += width;
  }
  folder.Write("view.html", view + "</body></html>\n");
}

SLayout ParseLayout(const std::string& dump, int width) {
  const std::string head = fmt::format("LAYOUT {} ", width);
  const size_t start = dump.find(head);
  INFO(dump.substr(0, 2000));
  REQUIRE(start != std::string::npos);
  std::istringstream line(
      dump.substr(start + head.size(), dump.find(';', start) - start - head.size()));
  SLayout layout;
  line >> layout.ContentWidth;
  SBox box{};
  char comma = 0;
  while (line >> box.Left >> comma >> box.Top >> comma >> box.Width >> comma >> box.Height) {
    layout.Figures.push_back(box);
  }
  return layout;
}

// the number of different colours in a part of a picture
size_t CountColors(const SImage& image, const SBox& box, int offset) {
  std::set<std::array<UInt8, 3>> colors;
  for (auto y = static_cast<size_t>(box.Top); y < static_cast<size_t>(box.Top + box.Height); ++y) {
    for (auto x = static_cast<size_t>(box.Left); x < static_cast<size_t>(box.Left + box.Width);
         ++x) {
      const size_t row = image.Height - 1 - y;  // the lowest one is first
      const UInt8* pixel = &image.Pixels.at(3 * (row * image.Width + x + offset));
      colors.insert({pixel[0], pixel[1], pixel[2]});
    }
  }
  return colors.size();
}

}  // namespace

TEST_CASE("report: a browser shows the page at the widths of a desktop and a phone",
          "[campaign][report]") {
  if (FindBrowser().empty() || FindProgram("gnuplot").empty()) {
    WARN("skipped: " << (FindBrowser().empty() ? "no browser is installed (Debian: chromium)"
                                               : "gnuplot is not installed"));
    return;
  }
  const CTestFolder folder;
  folder.Write("experiment.argos", MakeCampaignExperiment("throw", 3));
  folder.Write("c.xml", R"(<argos-campaign experiment='experiment.argos'>
  <factors>
    <factor name='gain' path='loop_functions/@gain' values='1, 2, 4' />
    <factor name='length' path='//experiment/@length' values='0.5, 1' />
  </factors>
  <runs seeds='4' />
  <collect><metric name='level' /><metric name='level' series='true' /></collect>
  <figures>
    <boxplot y='level' x='gain' group='length' />
    <series y='level' group='gain' />
    <scaling y='level' x='gain' group='length' />
    <heatmap z='level' x='gain' y='length' />
  </figures>
  <tests><compare metric='level' factor='gain' /></tests>
</argos-campaign>)");
  REQUIRE(folder.RunProgram("argos3-campaign", {"run", "c.xml", "--quiet"}).Status == 3);
  const SProgramRun report = folder.RunProgram("argos3-campaign", {"report", "c.xml"});
  INFO(report.Out << report.Err);
  REQUIRE(report.Status == 0);
  WriteView(folder);
  const int allWidths = kWidths[0] + kWidths[1];
  const bool isDumped = RunBrowser(folder, "--dump-dom", allWidths);
  INFO(folder.Read("browser.err"));
  REQUIRE(isDumped);
  const std::string dump = folder.Read("browser.out");
  REQUIRE(RunBrowser(folder, "--screenshot=page.png", allWidths));
  const SImage image = ReadImage(folder.Path("page.png"), "screenshot");
  REQUIRE(image.Width == static_cast<size_t>(allWidths));
  int offset = 0;
  for (const int width : kWidths) {
    CAPTURE(width);
    const SLayout layout = ParseLayout(dump, width);
    // else the page would scroll sideways
    CHECK(layout.ContentWidth <= width);
    REQUIRE(layout.Figures.size() == 4);
    for (const SBox& box : layout.Figures) {
      CAPTURE(box.Top);
      CHECK(box.Left >= 0.0);
      CHECK(box.Left + box.Width <= width);
      // as wide as the page, except for its margins; 640 pixels are enough on a desktop
      CHECK(box.Width >= std::min(0.8 * width, 640.0));
      CHECK(box.Height >= 0.5 * box.Width);
      // background, text and data, with edges that are smoothed
      CHECK(CountColors(image, box, offset) > 10);
    }
    offset += width;
  }
}

TEST_CASE("report: a boxplot shows the last values of a series", "[campaign][report]") {
  const CTestFolder folder;
  folder.Write("experiment.argos", MakeCampaignExperiment("throw", 3));
  folder.Write("c.xml", R"(<argos-campaign experiment='experiment.argos'>
  <factors><factor name='gain' path='loop_functions/@gain' values='1, 2' /></factors>
  <runs seeds='1' />
  <collect><metric name='level' series='true' /></collect>
  <figures><boxplot y='level' x='gain' /></figures>
</argos-campaign>)");
  REQUIRE(folder.RunProgram("argos3-campaign", {"run", "c.xml", "--quiet"}).Status == 0);
  REQUIRE(folder.RunProgram("argos3-campaign", {"report", "c.xml"}).Status == 0);
  REQUIRE(folder.RunProgram("argos3-campaign", {"export", "c.xml", "--csv", "t"}).Status == 0);
  // run, factor, seed, tick and value: of the last tick of the first run
  const std::string series = folder.Read("t/series_level.csv");
  const size_t second = series.find("\n2,");
  REQUIRE(second != std::string::npos);
  const size_t comma = series.rfind(',', second);
  const std::string last =
      fmt::format("{:.10g}", std::stod(series.substr(comma + 1, second - comma - 1)));
  CHECK_THAT(folder.Read("c.report/figures/boxplot_level_gain.dat"),
             Catch::Contains("\n0 " + last + ' ' + last + ' ' + last));
}

TEST_CASE("report: options that a figure does not have are errors", "[campaign][report]") {
  const CTestFolder folder;
  folder.Write("experiment.argos", MakeCampaignExperiment("throw", 3));
  folder.Write("c.xml", R"(<argos-campaign experiment='experiment.argos'>
  <factors><factor name='gain' path='loop_functions/@gain' values='1, 2' /></factors>
  <runs seeds='1' />
  <collect><metric name='level' /></collect>
</argos-campaign>)");
  REQUIRE(folder.RunProgram("argos3-campaign", {"run", "c.xml", "--quiet"}).Status == 0);
  const auto run = [&folder](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"report", "c.xml"});
    return folder.RunProgram("argos3-campaign", arguments);
  };
  const std::vector<std::string> figure = {"--plot", "boxplot", "-o", "f.svg"};
  const auto runWith = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), figure.begin(), figure.end());
    return run(arguments);
  };
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--reference", "0"}, {"--xlog", "--reference", "1"}}) {
    CAPTURE(options);
    const SProgramRun refused = runWith(options);
    CHECK(refused.Status != 0);
    CHECK_THAT(refused.Err, Catch::Contains("--reference belongs to --plot means"));
  }
  CHECK_THAT(runWith({"--xlog"}).Err,
             Catch::Contains("--xlog belongs to --plot series, difference and means"));
  CHECK_THAT(run({"--plot", "difference", "-o", "f.svg", "--log"}).Err,
             Catch::Contains("a difference may be negative"));
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--band", "interval"}, {"--ended", "hold"}, {"--ended", "drop"}}) {
    CAPTURE(options);
    const SProgramRun refused = runWith(options);
    CHECK(refused.Status != 0);
    CHECK_THAT(refused.Err, Catch::Contains("--band and --ended belong to --plot series"));
  }
  // each option of a figure without one
  for (const std::vector<std::string>& options : {std::vector<std::string>{"--x", "gain"},
                                                  {"--y", "level"},
                                                  {"--z", "level"},
                                                  {"--group", "gain"},
                                                  {"--title", "T"},
                                                  {"--where", "gain > 1"},
                                                  {"--band", "interval"},
                                                  {"--ended", "hold"},
                                                  {"--log"},
                                                  {"--xlog"},
                                                  {"--reference", "1"}}) {
    CAPTURE(options);
    const SProgramRun refused = run(options);
    CHECK(refused.Status != 0);
    CHECK_THAT(refused.Err, Catch::Contains("give --plot KIND, too"));
  }
  CHECK_THAT(run({"--plot", "boxplot"}).Err, Catch::Contains("--plot needs -o FILE.svg"));
  // those that it has are taken: then something else is wrong
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"means", "--reference", "1", "--xlog"},
        {"series", "--band", "interval", "--ended", "hold", "--xlog"},
        {"difference", "--group", "gain", "--xlog"}}) {
    CAPTURE(options);
    std::vector<std::string> arguments = {"--y", "height", "--x", "gain", "-o", "f.svg", "--plot"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    CHECK_THAT(run(arguments).Err, Catch::Contains("\"height\""));
  }
}

}  // namespace report_page_test
