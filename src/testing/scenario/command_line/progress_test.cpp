// The progress of a run: its text, and the line in a terminal.

#include "program_run.h"

#include <argos3/program/progress.h>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <regex>
#include <string>
#include <vector>

namespace progress_test {

using namespace argos;
using Catch::Contains;

TEST_CASE("progress: shows ticks, simulated time, real-time factor and time left",
          "[command_line]") {
  SProgress progress;
  progress.Ticks = 150;
  progress.MaxTicks = 600;
  progress.TickLength = 0.1;
  progress.WallSeconds = 30.0;
  // 15 s took 30 s; 450 more ticks at 5 per second
  CHECK(DescribeProgress(progress) ==
        "tick 150/600 (25 %), 1:30 left, 0.5 x real time, 15 s simulated");
  progress.WallSeconds = 3000.0;
  CHECK_THAT(DescribeProgress(progress), Contains("2:30:00 left"));
  // 450 of 600 ticks are left, so three times the time until now
  progress.WallSeconds = 3599.0 / 3.0;
  CHECK_THAT(DescribeProgress(progress), Contains(", 59:59 left"));
  progress.WallSeconds = 40.0;
  CHECK_THAT(DescribeProgress(progress), Contains(", 2:00 left"));
  progress.WallSeconds = 1200.0;
  CHECK_THAT(DescribeProgress(progress), Contains(", 1:00:00 left"));
  progress.WallSeconds = 119'999.0;
  CHECK_THAT(DescribeProgress(progress), Contains(", 99:59:57 left"));
  progress.WallSeconds = 120'000.0;
  CHECK_THAT(DescribeProgress(progress), Contains(", more than 100 h left"));
}

TEST_CASE("progress: without a limit no time left is shown", "[command_line]") {
  SProgress progress;
  progress.Ticks = 10;
  progress.TickLength = 0.1;
  progress.WallSeconds = 0.5;
  CHECK(DescribeProgress(progress) == "tick 10, 2 x real time, 1 s simulated");
  progress.Ticks = 0;
  CHECK(DescribeProgress(progress) == "tick 0, 0 s simulated");
}

namespace {

const std::string kExperiment =
    "<argos-configuration><framework><experiment ticks_per_second='700' length='5000000' "
    "real_time='true'/></framework><controllers/><arena size='4,4,1'/><physics_engines/><media/>"
    "</argos-configuration>";

}  // namespace

TEST_CASE("argos3: the progress line is no wider than the terminal", "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", kExperiment);
  const auto show = [&](unsigned short columns, const std::string& trigger) {
    const std::string text = folder.RunOnTerminal({"-c", "e.argos"}, columns, trigger);
    CAPTURE(text);
    std::smatch match;
    REQUIRE(std::regex_search(text, match, std::regex("\r\x1b\\[K(t[^\r]*)\r\x1b\\[K")));
    return match[1].str();
  };
  // more than 80 characters, unless the computer is so slow that the first line comes early
  const std::regex whole(
      "tick [0-9]+/3500000000 \\(0 %\\), more than 100 h left, [0-9.]+ x real time, "
      "[0-9.]+ s simulated");
  const std::string wide = show(200, "s simulated");
  CAPTURE(wide);
  CHECK(std::regex_match(wide, whole));
  // the last column stays free: a full line wraps around in some terminals
  CHECK(show(40, "\x1b[Kt").size() == 39);
  CHECK(show(1, "\x1b[Kt") == "t");
  // of an unknown width
  const std::string unknown = show(0, "\x1b[Kt");
  CHECK((unknown.size() == 79 || (unknown.size() < 79 && std::regex_match(unknown, whole))));
}

TEST_CASE("argos3: the progress line goes to no dumb terminal", "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", kExperiment);
  const std::vector<std::string> arguments = {"-c", "e.argos", "--length", "0.5"};
  // erased before the summary
  CHECK_THAT(folder.RunOnTerminal(arguments, 200, "none"),
             Contains("\r\x1b[Ktick ") && Contains(" s simulated\r\x1b[K\x1b[1;31m"));
  CHECK_THAT(folder.RunOnTerminal(arguments, 200, "none", "dumb"),
             Contains("simulated 0.5 s") && !Contains("\r\x1b[K"));
}

TEST_CASE("argos3: in a terminal the log has colours unless NO_COLOR is set", "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", kExperiment);
  const std::vector<std::string> arguments = {"-c", "e.argos", "--length", "0.01"};
  CHECK_THAT(folder.RunOnTerminal(arguments, 80, "none"), Contains("\x1b[1;32m[INFO] "));
  setenv("NO_COLOR", "1", 1);
  const std::string plain = folder.RunOnTerminal(arguments, 80, "none");
  unsetenv("NO_COLOR");
  CHECK_THAT(plain, Contains("[INFO] ") && !Contains("\x1b"));
}

}  // namespace progress_test
