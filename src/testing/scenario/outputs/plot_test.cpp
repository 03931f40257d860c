// argos3-plot: its errors, and pictures if there is gnuplot.

#include "../command_line/program_run.h"

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/plot_picture.h>

#include <catch2/catch.hpp>

#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <vector>

namespace plot_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

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
                              InBuildTree("bin/argos3-plot") + "' " + arguments +
                              " >out.txt 2>err.txt";
  const int status = std::system(command.c_str());
  SProgramRun run;
  run.Status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  run.Err = folder.Read("err.txt");
  return run;
}

// a word of a command for a shell
std::string Quote(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    quoted += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return quoted + "'";
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
  folder.Write("empty.csv", "");
  folder.Write("zeros.csv", std::string("# argos3 3.0.0-1\n\0\n\0x\n", 22));
  folder.Write("short.csv", "# argos3 3.0.0-1\nrun,tick\n");
  folder.Write("places.csv", "# argos3 3.0.0-1\nrun,tick,time,robot,x,y\n0,0,0,a,nan,0\n");
  folder.Write("words.csv", "# argos3 3.0.0-1\nrun,tick,time,food\n0,0,0,many\n");
  folder.Write("notes.txt", Metrics(3));
  std::string many = "# argos3 3.0.0-1\nrun,tick,time,robot,x,y\n";
  for (int i = 10; i < 32; ++i) {
    many += "0,0,0,r" + std::to_string(i) + ",0,0\n";
  }
  folder.Write("many.csv", many);
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
       {"trajectories empty.csv -o p.png", "it must begin with \"# argos3\""},
       {"trajectories zeros.csv -o p.png", "\"run,tick,time,...\" is missing"},
       {"trajectories short.csv -o p.png", "\"run,tick,time,...\" is missing"},
       {"trajectories places.csv -o p.png", "there are no rows with positions to plot"},
       {"trajectories robots.csv 1.csv -o p.png", "trajectories needs one file, found 2"},
       {"trajectories notes.txt -o p.png", "only .csv and .csv.gz can be plotted"},
       {"trajectories many.csv --robots z -o p.png", ", r28, r29\n"},
       {"trajectories robots.csv --run x -o p.png", "--run must be a whole number, found \"x\""},
       {"trajectories robots.csv --robots z -o p.png", "no rows of the robot \"z\""},
       {"trajectories robots.csv --run 3 -o p.png", "no rows"},
       {"metrics fod 1.csv -o p.png", "columns: run, tick, time, robots, food"},
       {"metrics x robots.csv -o p.png", "a row for each robot"},
       {"metrics food 1.csv --from x -o p.png", "--from must be a number"},
       {"metrics food 1.csv --to inf -o p.png", "--to must be a number of seconds, found \"inf\""},
       {"metrics food -o p.png", "metrics needs the names of columns and at least one file"},
       {"metrics food 1.csv --from 0.3 -o p.png", "there are no values of \"food\" to plot"},
       {"metrics food,run,tick,time,robots,food,run,tick,time,robots 1.csv -o p.png",
        "at most 9 metrics fit into one plot, found 10"},
       {"metrics food words.csv -o p.png", "column \"food\": \"many\" is no number"},
       {"--log -o p.png", "trajectories or metrics?"},
       {"metrics food 1.csv --frm 1 -o p.png", "unknown option --frm; did you mean \"--from\"?"},
       {"metrics food 1.csv --ended x -o p.png", "none of survivors, hold and drop"},
       {"metrics food 1.csv --robots a -o p.png", "--robots belongs to trajectories"},
       {"metrics food 1.csv --run 1 -o p.png", "--run belongs to trajectories"},
       {"trajectories robots.csv --log -o p.png", "--log belongs to metrics"},
       {"trajectories robots.csv --label x -o p.png", "--label belongs to metrics"},
       {"metrics food 1.csv -o p.png --to", "--to needs a value"}}));
  CAPTURE(arguments);
  const SProgramRun run = Plot(folder, arguments);
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains(message));
}

TEST_CASE("plots: a missing gnuplot is said", "[outputs][plots]") {
  const CTestFolder folder;
  folder.Write("robots.csv", kRobots);
  const SProgramRun run = Plot(folder, "trajectories robots.csv -o p.png", "PATH=\"$PWD/nowhere\"");
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("gnuplot is not installed") && Contains("gnuplot-nox"));
}

TEST_CASE("plots: the axes fill the picture, and a course goes from its first to its last value",
          "[outputs][plots]") {
  if (!HasGnuplot()) {
    return;
  }
  const CTestFolder folder;
  // a value equal to the time, from 1 s to 10 s; none at 0 s
  std::string table =
      "# argos3 3.0.0-1 table\n# units: time [s], a_name_that_is_long_indeed [kg]\n"
      "run,tick,time,robots,a_name_that_is_long_indeed\n0,0,0,2,\n";
  for (int tick = 1; tick <= 10; ++tick) {
    const std::string text = std::to_string(tick);
    table += "0," + text + ',' + text + ",2," + text + '\n';
  }
  folder.Write("1.csv", table);
  folder.Write("2.csv", table);
  const std::string files = GENERATE("1.csv", "1.csv 2.csv");
  REQUIRE(Plot(folder, "metrics a_name_that_is_long_indeed " + files + " -o p.png").Status == 0);
  const CPlotPicture picture(folder.Path("p.png"));
  const SPixelBox axes = picture.FindAxes();
  CHECK(axes.GetWidth() > 0.8 * picture.GetWidth());
  CHECK(axes.GetHeight() > 0.6 * picture.GetHeight());
  const SPixelBox line = picture.FindBox(CPlotPicture::kFirstColor, axes);
  // the axis of time begins at the first value and ends at the last; 4 pixels for widths of lines
  CHECK_THAT(line.Left, WithinAbs(axes.Left, 4.0));
  CHECK_THAT(line.Right, WithinAbs(axes.Right, 4.0));
  // the axis of values begins at 0, so that heights are in the proportion of values
  const double first = axes.Bottom - line.Bottom;
  const double last = axes.Bottom - line.Top;
  CHECK_THAT(last / first, WithinAbs(10.0, 1.0));
}

TEST_CASE("plots: a power of time is a straight line on logarithmic axes", "[outputs][plots]") {
  if (!HasGnuplot()) {
    return;
  }
  const CTestFolder folder;
  // the square of the time, from 1 s to 100 s; 0 at 0 s, and at 0.5 s
  std::string table =
      "# argos3 3.0.0-1 table\nrun,tick,time,robots,square\n0,0,0,2,0\n0,1,0.5,2,0\n";
  for (int tick = 2; tick <= 200; ++tick) {
    const std::string time = std::to_string(tick / 2.0);
    table +=
        "0," + std::to_string(tick) + ',' + time + ",2," + std::to_string(tick * tick / 4.0) + '\n';
  }
  folder.Write("1.csv", table);
  const SProgramRun run = Plot(folder, "metrics square 1.csv --log --xlog -o p.png");
  REQUIRE(run.Status == 0);
  CHECK_THAT(run.Err, Contains("argos3-plot: 1 time with a median of 0 or less left out."));
  const CPlotPicture picture(folder.Path("p.png"));
  const SPixelBox axes = picture.FindAxes();
  CHECK(axes.GetWidth() > 0.8 * picture.GetWidth());
  CHECK(axes.GetHeight() > 0.7 * picture.GetHeight());
  const SPixelBox line = picture.FindBox(CPlotPicture::kFirstColor, axes);
  // from end to end of the axis of time; that of values goes on by a factor of 1.2 on both sides
  const double decade = axes.GetHeight() / std::log10(1e4 * 1.2 * 1.2);
  CHECK_THAT(line.Left, WithinAbs(axes.Left, 4.0));
  CHECK_THAT(line.Right, WithinAbs(axes.Right, 4.0));
  CHECK_THAT(line.Bottom, WithinAbs(axes.Bottom - decade * std::log10(1.2), 4.0));
  CHECK_THAT(line.Top, WithinAbs(axes.Top + decade * std::log10(1.2), 4.0));
  // half-way, at 10 s, the value is 100
  const double middle = (axes.Left + axes.Right) / 2.0;
  const SPixelBox half =
      picture.FindBox(CPlotPicture::kFirstColor, {middle, axes.Top, middle, axes.Bottom});
  CHECK_THAT((half.Top + half.Bottom) / 2.0, WithinAbs((line.Top + line.Bottom) / 2.0, 4.0));
}

TEST_CASE("plots: paths are where the robots were", "[outputs][plots]") {
  if (!HasGnuplot()) {
    return;
  }
  const CTestFolder folder;
  folder.Write("robots.csv",
               "# argos3 3.0.0-1 table\n# arena: -2,-1 2,1\nrun,tick,time,robot,x,y\n"
               "0,0,0,a,-1,-0.5\n0,1,0.1,a,0,0\n0,2,0.2,a,1.5,0.75\n");
  REQUIRE(Plot(folder, "trajectories robots.csv -o p.png").Status == 0);
  const CPlotPicture picture(folder.Path("p.png"));
  // the frame is the arena and 2 % of its greater side
  const SPixelBox frame = picture.FindAxes();
  CHECK(frame.GetWidth() > 0.8 * picture.GetWidth());
  CHECK_THAT(frame.GetWidth() / frame.GetHeight(), WithinAbs(4.16 / 2.16, 0.03));
  const SPixelBox path = picture.FindBox(CPlotPicture::kFirstColor, frame);
  const double scale = frame.GetWidth() / 4.16;  // pixels for a metre
  // from the dot at the start to the circle at the end, whose radii are below 20 pixels
  CHECK_THAT(path.Left, WithinAbs(frame.Left + scale * (-1.0 + 2.08), 20.0));
  CHECK_THAT(path.Right, WithinAbs(frame.Left + scale * (1.5 + 2.08), 20.0));
  CHECK_THAT(path.Bottom, WithinAbs(frame.Bottom - scale * (-0.5 + 1.08), 20.0));
  CHECK_THAT(path.Top, WithinAbs(frame.Bottom - scale * (0.75 + 1.08), 20.0));
}

TEST_CASE("plots: the paths of more than nine robots are shades from blue to green",
          "[outputs][plots]") {
  if (!HasGnuplot()) {
    return;
  }
  const CTestFolder folder;
  std::string rows = "# argos3 3.0.0-1 table\n# arena: -1,-1 1,1\nrun,tick,time,robot,x,y\n";
  for (int tick = 0; tick < 2; ++tick) {
    for (int i = 0; i < 11; ++i) {
      rows += "0," + std::to_string(tick) + ",0,r" + std::to_string(i) + ',' +
              (tick == 0 ? "-0.5," : "0.5,") + std::to_string(-0.5 + 0.1 * i) + '\n';
    }
  }
  folder.Write("robots.csv", rows);
  REQUIRE(Plot(folder, "trajectories robots.csv -o p.png").Status == 0);
  const CPlotPicture picture(folder.Path("p.png"));
  const SPixelBox frame = picture.FindAxes();
  const double scale = frame.GetHeight() / 2.04;  // pixels for a metre
  // the colour map "viridis" at 0, 0.425 and 0.85
  for (const auto& [y, color] : {std::pair(-0.5, 0x440154), {0.0, 0x337a92}, {0.5, 0x97cd4e}}) {
    CAPTURE(y);
    const SPixelBox path = picture.FindBox(static_cast<UInt32>(color), frame);
    CHECK_THAT(path.Top, WithinAbs(frame.Bottom - scale * (y + 1.02), 20.0));
    CHECK_THAT(path.GetWidth(), WithinAbs(scale, 40.0));
  }
}

TEST_CASE("plots: the key says how many runs there are, and how many at the end",
          "[outputs][plots]") {
  if (!HasGnuplot()) {
    return;
  }
  const CTestFolder folder;
  folder.Write("1.csv", Metrics(3));
  // one that ended a tick earlier
  folder.Write("2.csv", Metrics(5).substr(0, Metrics(5).find("0,2,0.2")));
  const auto [ended, key] =
      GENERATE(table<std::string, std::string>({{"", "of 2 runs, 1 at the end"},
                                                {"--ended hold", "of 2 runs<"},
                                                {"--ended drop", "of 2 runs<"}}));
  REQUIRE(Plot(folder, "metrics food 1.csv 2.csv -o p.svg " + ended).Status == 0);
  CHECK_THAT(folder.Read("p.svg"), Contains("median and quartiles " + key));
}

TEST_CASE("plots: texts of a table are never commands", "[outputs][plots]") {
  const CTestFolder folder;
  const std::string command = GENERATE(
      std::string("`touch EVIL`"), std::string("\"\";system('touch EVIL')#"),
      std::string("';system(\"\"touch EVIL\"\");#"), std::string("$(touch EVIL)"),
      std::string("@EVIL\nsystem('touch EVIL')"), std::string("' . system('touch EVIL') . '"),
      std::string("|touch EVIL"), std::string("\\\ntouch EVIL"));
  CAPTURE(command);
  // where quotes are doubled it is a field, elsewhere it may break the line
  const std::string field = '"' + command + '"';
  const std::string start = "# argos3 3.0.0-1 table\n";
  const std::string rows =
      "run,tick,time,robot,x,y\n0,0,0," + field + ",0,0\n0,1,1," + field + ",1,1\n";
  const std::string metrics = "0,0,0,2,1\n0,1,1,2,2\n";
  const auto check = [&](const std::string& table, const std::string& arguments) {
    folder.Write("t.csv", table);
    for (const std::string picture : {"p.svg", "p.png"}) {
      const SProgramRun run = Plot(folder, arguments + " -o " + picture);
      CAPTURE(table, arguments, run.Err);
      CHECK((run.Status == 0 || run.Status == 1));
      CHECK_FALSE(std::filesystem::exists(folder.Path("EVIL")));
    }
  };
  check(start + rows, "trajectories t.csv");
  for (const char* header : {"# arena: ", "# polygon: ", "# circle: 0,0,1", "# circle: 0,0,"}) {
    check(start + header + command + '\n' + rows, "trajectories t.csv");
  }
  check(start + "# units: time [s], food [" + command + "]\nrun,tick,time,robots,food\n" + metrics,
        "metrics food t.csv");
  check(start + "run,tick,time,robots," + field + '\n' + metrics,
        "metrics " + Quote(command) + " t.csv");
  check(start + "run,tick,time,robots,food\n0,0," + field + ",2," + field + '\n' + metrics,
        "metrics food t.csv");
}

TEST_CASE("plots: a text with signs of gnuplot and a shell is drawn as it is", "[outputs][plots]") {
  if (!HasGnuplot()) {
    return;
  }
  const CTestFolder folder;
  folder.Write("t.csv",
               "# argos3 3.0.0-1 table\n# units: time [s], food [`id` {/=40 x}]\n"
               "run,tick,time,robots,food\n0,0,0,2,1\n0,1,1,2,2\n");
  REQUIRE(Plot(folder, "metrics food t.csv -o p.svg").Status == 0);
  CHECK_THAT(folder.Read("p.svg"), Contains("food, `id` {/=40 x}"));
  folder.Write("r.csv",
               "# argos3 3.0.0-1 table\nrun,tick,time,robot,x,y\n"
               "0,0,0,a_{b}^`id`'s,0,0\n0,1,1,a_{b}^`id`'s,1,1\n");
  REQUIRE(Plot(folder, "trajectories r.csv -o p.svg").Status == 0);
  CHECK_THAT(folder.Read("p.svg"), Contains("a_{b}^`id`'s"));
}

TEST_CASE("plots: header lines that are no numbers are errors with their line",
          "[outputs][plots]") {
  const auto [header, message] = GENERATE(table<std::string, std::string>(
      {{"# arena: -1,-1 1", "t.csv:2: expected 2 numbers, found \"1\""},
       {"# arena: 1,1", "an arena is two corners"},
       {"# arena: -1,1 1,-1", "an arena is two corners"},
       {"# arena: -inf,-1 1,1", "\"-inf\" is no number"},
       {"# circle: 0,0,1 1,1,1", "a circle is x, y and a radius above 0"},
       {"# arena: 1,1 -1,-1", "an arena is two corners"},
       {"# polygon: 0,0 1,1", "three corners or more"},
       {"# polygon: 0,0 1,x 2,2", "\"x\" is no number"},
       {"# circle: 0,0,0", "a radius above 0"},
       {"# circle: 0,0,0.5;system(\"x\")#", "is no number"},
       {"# circle: 0,0,1e999", "is no number"}}));
  const CTestFolder folder;
  folder.Write("t.csv",
               "# argos3 3.0.0-1 table\n" + header + "\nrun,tick,time,robot,x,y\n0,0,0,a,0,0\n");
  const SProgramRun run = Plot(folder, "trajectories t.csv -o p.svg");
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains(message));
}

TEST_CASE("plots: compressed tables, and one that is being written", "[outputs][plots]") {
  if (!HasGnuplot()) {
    return;
  }
  const CTestFolder folder;
  folder.Write("1.csv", Metrics(3));
  REQUIRE(std::system(("gzip '" + folder.Path("1.csv") + "'").c_str()) == 0);
  CHECK(Plot(folder, "metrics food 1.csv.gz -o p.svg").Status == 0);
  // the last line has no end yet
  folder.Write("2.csv", Metrics(3) + "0,3,0.3,2,9999");
  CHECK(Plot(folder, "metrics food 2.csv -o p.svg").Status == 0);
  CHECK_THAT(folder.Read("p.svg"), !Contains("10000"));
  // the check sum at the end is wrong
  std::string damaged = folder.Read("1.csv.gz");
  damaged[damaged.size() - 8] ^= 1;
  folder.Write("3.csv.gz", damaged);
  CHECK_THAT(Plot(folder, "metrics food 3.csv.gz -o p.svg").Err, Contains("the file is damaged"));
}

TEST_CASE("plots: tables of other systems and programs can be read", "[outputs][plots]") {
  if (!HasGnuplot()) {
    return;
  }
  const CTestFolder folder;
  // lines that end with CR LF; values that are missing in several spellings
  folder.Write("1.csv",
               "# argos3 3.0.0-1 table\r\n# units: time [s], food [kg]\r\n"
               "run,tick,time,robots,food\r\n0,0,0,2,-nan(ind)\r\n0,1,0.1,2,1.#INF\r\n\r\n"
               "0,2,0.2,2,-inf\r\n0,3,0.3,2,nan\r\n0,4,0.4,2,5\r\n0,5,0.5,2,6\r\n");
  const SProgramRun run = Plot(folder, "metrics food 1.csv -o p.svg");
  CHECK(run.Status == 0);
  CHECK(run.Err == "");
  CHECK_THAT(folder.Read("p.svg"), Contains("food, kg"));
  // both have no value in the first rows
  CHECK_THAT(Plot(folder, "metrics food 1.csv --to 0.35 -o p.svg").Err,
             Contains("there are no values of \"food\""));
}

TEST_CASE("plots: help and version", "[outputs][plots]") {
  const CTestFolder folder;
  const auto [arguments, text] =
      GENERATE(table<std::string, std::string>({{"-h", "Usage: argos3-plot "},
                                                {"metrics --help", "Usage: "},
                                                {"--version", "ARGOS_VERSION="}}));
  const SProgramRun run = Plot(folder, arguments);
  CHECK(run.Status == 0);
  CHECK(run.Err == "");
  CHECK_THAT(folder.Read("out.txt"), Contains(text));
}

TEST_CASE("plots: only the times from --from to --to are drawn", "[outputs][plots]") {
  if (!HasGnuplot()) {
    return;
  }
  const CTestFolder folder;
  // a value equal to the time
  std::string table = "# argos3 3.0.0-1 table\nrun,tick,time,food\n";
  for (int tick = 0; tick <= 10; ++tick) {
    const std::string text = std::to_string(tick);
    table += "0," + text + ',' + text + ',' + text + '\n';
  }
  folder.Write("1.csv", table);
  REQUIRE(Plot(folder, "metrics food 1.csv --from 2 --to 6 -o p.png").Status == 0);
  const CPlotPicture picture(folder.Path("p.png"));
  const SPixelBox axes = picture.FindAxes();
  const SPixelBox line = picture.FindBox(CPlotPicture::kFirstColor, axes);
  CHECK_THAT(line.Left, WithinAbs(axes.Left, 4.0));
  CHECK_THAT(line.Right, WithinAbs(axes.Right, 4.0));
  // the axis of values begins at 0
  CHECK_THAT((axes.Bottom - line.Top) / (axes.Bottom - line.Bottom), WithinAbs(3.0, 0.1));
}

TEST_CASE("plots: pictures of paths are as high as the arena, from 300 to 1000 pixels",
          "[outputs][plots]") {
  if (!HasGnuplot()) {
    return;
  }
  // 600 pixels times the ratio of the sides, 90 for the axis and 40 for a key of up to nine robots;
  // a picture has twice as many
  const auto [corner, robots, height] = GENERATE(table<std::string, int, int>({
      {"1,1", 1, 2 * 730},
      {"1,1", 10, 2 * 690},
      {"1,0.1", 1, 2 * 300},
      {"0.1,1", 1, 2 * 1000},
      // an arena without an extent is drawn as a square
      {"0,0", 1, 2 * 730},
  }));
  const CTestFolder folder;
  std::string rows =
      "# argos3 3.0.0-1 table\n# arena: 0,0 " + corner + "\nrun,tick,time,robot,x,y\n";
  for (int i = 0; i < robots; ++i) {
    rows += "0,0,0,r" + std::to_string(i) + ",0,0\n";
  }
  folder.Write("robots.csv", rows);
  const SProgramRun run = Plot(folder, "trajectories robots.csv -o p.png");
  CAPTURE(corner, robots, run.Err);
  REQUIRE(run.Status == 0);
  CHECK(CPlotPicture(folder.Path("p.png")).GetHeight() == height);
}

TEST_CASE("plots: without an arena the paths fill the frame; rows without a place are left out",
          "[outputs][plots]") {
  if (!HasGnuplot()) {
    return;
  }
  const CTestFolder folder;
  folder.Write("robots.csv",
               "# argos3 3.0.0-1 table\nrun,tick,time,robot,x,y\n0,0,0,a,1,0.5\n"
               "0,1,0.1,a,nan,7\n0,1,0.1,a,7,\n0,1,0.1,a,-1,-0.25\n0,2,0.2,a,0.5,0.75\n");
  REQUIRE(Plot(folder, "trajectories robots.csv -o p.png").Status == 0);
  const SPixelBox frame = CPlotPicture(folder.Path("p.png")).FindAxes();
  // from -1 to 1 and from -0.25 to 0.75, with 2 % of 2 on each side
  CHECK_THAT(frame.GetWidth() / frame.GetHeight(), WithinAbs(2.08 / 1.08, 0.03));
}

}  // namespace plot_test
