// argos3-plot: its errors, and pictures if there is gnuplot.

#include "../command_line/program_run.h"

#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <sys/wait.h>

#include <cstdlib>

namespace plot_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

constexpr char kRobots[] =
    "# argos3 3.0.0-1 table\n# arena: -1,-1 1,1\n# polygon: 0,0 0.5,0 0.5,0.5\n"
    "# circle: -0.5,-0.5,0.2\n# units: time [s], x [m], y [m]\nrun,tick,time,robot,x,y\n"
    "0,0,0,a,0,0\n0,0,0,\"b,\"\"c\",1,1\n0,1,0.1,a,0.1,0\n0,1,0.1,\"b,\"\"c\",0.9,1\n";

std::string Metrics(int value) {
  const std::string text = std::to_string(value);
  return "# argos3 3.0.0-1 table\n# units: time [s], food [kg]\nrun,tick,time,robots,food\n"
         "0,0,0,2,\n0,1,0.1,2," +
         text + "\n0,2,0.2,2," + text + "0\n";
}

/* Runs argos3-plot in the folder. */
SProgramRun Plot(const CTestFolder& folder, const std::string& arguments,
                 const std::string& environment = "") {
  const std::string command = "cd '" + folder.Path("") + "' && " + environment + " '" +
                              InSourceTree("scripts/argos3-plot") + "' " + arguments +
                              " >out.txt 2>err.txt";
  const int status = std::system(command.c_str());
  SProgramRun run;
  run.Status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  run.Err = folder.Read("err.txt");
  return run;
}

bool HasGnuplot() {
  return std::system("command -v gnuplot >/dev/null") == 0;
}

}  // namespace

TEST_CASE("plots: pictures of ways and metrics", "[outputs][plots]") {
  if (!HasGnuplot()) {
    WARN("there is no gnuplot: skipped");
    return;
  }
  const CTestFolder folder;
  folder.Write("robots.csv", kRobots);
  folder.Write("1.csv", Metrics(3));
  folder.Write("2.csv", Metrics(5));
  const auto [picture, start] = GENERATE(table<std::string, std::string>(
      {{"p.svg", "<?xml"}, {"p.png", "\x89PNG"}, {"p.pdf", "%PDF"}}));
  for (const std::string arguments :
       {"trajectories robots.csv -o ", "trajectories robots.csv --robots a --to 0.05 -o ",
        "metrics food 1.csv 2.csv -o ", "metrics food,robots 1.csv -o "}) {
    CAPTURE(arguments, picture);
    const SProgramRun run = Plot(folder, arguments + picture);
    CHECK(run.Status == 0);
    CHECK(run.Err == "");
    CHECK(folder.Read(picture).rfind(start, 0) == 0);
  }
  // the label has the unit, the key the number of runs
  CHECK(Plot(folder, "metrics food 1.csv 2.csv -o q.svg").Status == 0);
  CHECK_THAT(folder.Read("q.svg"),
             Contains("food, kg") && Contains("median and quartiles of 2 runs"));
}

TEST_CASE("plots: mistakes are errors that say what would be right", "[outputs][plots]") {
  const CTestFolder folder;
  folder.Write("robots.csv", kRobots);
  folder.Write("1.csv", Metrics(3));
  folder.Write("other.csv", "a,b\n1,2\n");
  if (!HasGnuplot()) {
    return;
  }
  const auto [arguments, message] = GENERATE(table<std::string, std::string>(
      {{"", "trajectories or metrics"},
       {"ways robots.csv -o p.png", "known: trajectories, metrics"},
       {"trajectories robots.csv", "-o PICTURE is missing"},
       {"trajectories robots.csv -o none/p.png", "\"none/p.png\" cannot be written"},
       {"trajectories robots.csv -o p.gif", ".svg, .png or .pdf"},
       {"trajectories none.csv -o p.png", "there is no file \"none.csv\""},
       {"trajectories 1.csv -o p.png", "no column \"x\""},
       {"trajectories other.csv -o p.png", "no table of argos3"},
       {"trajectories robots.csv --robots z -o p.png", "no rows of the robot \"z\""},
       {"trajectories robots.csv --run 3 -o p.png", "no rows"},
       {"metrics fod 1.csv -o p.png", "columns: run, tick, time, robots, food"},
       {"metrics x robots.csv -o p.png", "a row for each robot"},
       {"metrics food 1.csv --from x -o p.png", "--from must be a number"},
       {"metrics food 1.csv --frm 1 -o p.png", "unknown option --frm"}}));
  CAPTURE(arguments);
  const SProgramRun run = Plot(folder, arguments);
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains(message));
}

TEST_CASE("plots: a missing gnuplot is said", "[outputs][plots]") {
  const CTestFolder folder;
  folder.Write("robots.csv", kRobots);
  // what the script needs before it looks for gnuplot
  const SProgramRun run =
      Plot(folder, "trajectories robots.csv -o p.png",
           "mkdir -p bin && ln -sf /bin/bash bin && PATH=\"$PWD/bin\" /bin/bash");
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("gnuplot is not installed") && Contains("gnuplot-nox"));
}

}  // namespace plot_test
