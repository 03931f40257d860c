// Tables of the program argos3: files that cannot grow, --csv, Lua variables, messages, Lua
// metrics.

#include "limited_run.h"
#include "table_reading.h"

#include <argos3/testing/support/experiment.h>

#include <catch2/catch.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>

namespace table_faults_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

constexpr char kRobotScript[] = R"(
number = 1
word = "go"
flag = false
function init() end
function reset() end
function destroy() end
function step()
  number = number + 0.5
  flag = not flag
  if number > 2 then word = "stop" end
  robot.range_and_bearing.set_data(1, 200 + robot.id:byte(2))
end
)";

constexpr char kLoopScript[] = R"(
function init() simulation.metric("sum", 0, "m") end
function post_step() simulation.metric("sum", simulation.clock() / 4) end
)";

// two foot-bots at a distance of 0.5 m that send one byte each
std::string LuaExperiment(const CTestFolder& folder, const std::string& outputs,
                          const std::string& script = kRobotScript, Real length = 0.3) {
  folder.Write("robot.lua", script);
  folder.Write("loop.lua", kLoopScript);
  SExperiment experiment;
  experiment.Length = length;
  experiment.Controllers =
      "<lua_controller id='c'><actuators><range_and_bearing implementation='default'/></actuators>"
      "<sensors><range_and_bearing implementation='medium' medium='rab'/></sensors>"
      "<params script='robot.lua'/></lua_controller>";
  experiment.Engines = "<dynamics2d id='dyn2d'/>";
  experiment.Media = "<range_and_bearing id='rab'/>";
  experiment.LoopFunctions =
      "<loop_functions label='lua'><params script='loop.lua'/></loop_functions>";
  experiment.Arena =
      "<foot-bot id='f1'><body position='0,0,0'/><controller config='c'/></foot-bot>"
      "<foot-bot id='f2'><body position='0.5,0,0'/><controller config='c'/></foot-bot>";
  std::string xml = experiment.ToXml();
  const std::string end = "</argos-configuration>";
  xml.insert(xml.rfind(end), "<outputs>" + outputs + "</outputs>");
  return folder.Write("e.argos", xml);
}

}  // namespace

TEST_CASE("tables: variables of Lua scripts, messages and metrics of Lua", "[outputs][tables]") {
  const CTestFolder folder;
  LuaExperiment(folder,
                "<table file='v.csv' fields='lua:number,lua:word,lua:flag'/>"
                "<table file='v.h5' fields='lua:word,rab'/>"
                "<table file='m.csv' fields='messages'/><metrics file='metrics.csv'/>");
  const SProgramRun run = folder.Run({"-n", "-c", "e.argos"});
  CAPTURE(run.Out, run.Err);
  REQUIRE(run.Status == 0);
  const SReadTable variables = ReadCSV(folder.Read("v.csv"));
  typedef std::vector<std::string> TTexts;
  CHECK(variables.Columns.at("lua_number") ==
        TTexts{"1", "1", "1.5", "1.5", "2", "2", "2.5", "2.5"});
  CHECK(variables.Columns.at("lua_word") ==
        TTexts{"go", "go", "go", "go", "go", "go", "stop", "stop"});
  CHECK(variables.Columns.at("lua_flag") == TTexts{"0", "0", "1", "1", "0", "0", "1", "1"});
  CHECK(ReadHDF5Texts(folder.Path("v.h5"), "lua_word") == variables.Columns.at("lua_word"));
  const SReadTable messages = ReadCSV(folder.Read("m.csv"));
  // one from the other robot in each tick after the first state
  CHECK(messages.Columns.at("robot") == TTexts{"f1", "f2", "f1", "f2", "f1", "f2"});
  const auto ranges = messages.GetNumbers("message_range");
  const auto bearings = messages.GetNumbers("message_horizontal_bearing");
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    // 0.5 m in cm, rounded
    CHECK(std::abs(ranges[i] - 50.0) < 1e-9);
    CHECK(std::abs(std::abs(bearings[i]) - (i % 2 == 0 ? 0.0 : M_PI)) < 1e-9);
  }
  // f1 receives from f2, after its first order has been applied: 200 + '2'
  CHECK(messages.Columns.at("message_data")[4].rfind("fa", 0) == 0);
  CHECK(ReadCSV(folder.Read("metrics.csv")).Columns.at("sum") ==
        TTexts{"0", "0.25", "0.5", "0.75"});
}

TEST_CASE("tables: variables of Lua scripts that change their type", "[outputs][tables]") {
  const CTestFolder folder;
  LuaExperiment(folder,
                "<table file='n.csv' robots='f1' fields='lua:number'/>"
                "<table file='t.csv' robots='f1' fields='lua:text'/>",
                R"(
number, text, ticks = 1, "a", 0
local numbers = {true, "x", {}, 7.5}
local texts = {2.5, true, {}, 'b,"c"'}
function init() end
function reset() end
function destroy() end
function step()
  ticks = ticks + 1
  number, text = numbers[ticks], texts[ticks]
end
)",
                0.5);
  const SProgramRun run = folder.Run({"-n", "-c", "e.argos"});
  CAPTURE(run.Out, run.Err);
  REQUIRE(run.Status == 0);
  typedef std::vector<std::string> TTexts;
  CHECK(ReadCSV(folder.Read("n.csv")).Columns.at("lua_number") ==
        TTexts{"1", "1", "", "", "7.5", ""});
  // rows of a single robot, whose last column is quoted where it needs that
  const std::string rows = folder.Read("t.csv");
  for (const char* row : {",f1,a\n", ",0.1,f1,2.5\n", ",0.2,f1,1\n", ",0.3,f1,\n",
                          ",0.4,f1,\"b,\"\"c\"\"\"\n", ",0.5,f1,\n"}) {
    CHECK_THAT(rows, Contains(row));
  }
  // one warning for each field
  CHECK_THAT(run.Err,
             Contains("field \"lua:number\": in robot \"f1\" the variable is now a string") &&
                 Contains("field \"lua:text\": in robot \"f1\" the variable is now a table") &&
                 !Contains("field \"lua:number\": in robot \"f1\" the variable is now a table"));
}

TEST_CASE("tables: texts of HDF5 files that become longer keep the rows before",
          "[outputs][tables]") {
  const CTestFolder folder;
  // elements of 32 bytes, then of the 80 that are needed, then of twice as many, beyond 2048 rows,
  // which are copied together
  LuaExperiment(folder,
                "<table file='v.csv' fields='lua:word'/><table file='v.h5' fields='lua:word'/>",
                R"(
word, ticks = "start", 0
function init() end
function reset() end
function destroy() end
function step()
  ticks = ticks + 1
  if ticks == 5 then word = ("x"):rep(80) end
  if ticks == 6 then word = "short" end
  if ticks == 1100 then word = ("y"):rep(81) end
end
)",
                112.0);
  REQUIRE(folder.Run({"-n", "-c", "e.argos"}).Status == 0);
  const SReadTable csv = ReadCSV(folder.Read("v.csv"));
  const std::vector<std::string> texts = ReadHDF5Texts(folder.Path("v.h5"), "lua_word");
  CHECK(texts == csv.Columns.at("lua_word"));
  CHECK(texts.size() == 2 * 1121);
  CHECK(texts[2 * 5] == std::string(80, 'x'));
  CHECK(texts[2 * 1100] == std::string(81, 'y'));
}

TEST_CASE("tables: a long text in the head of an HDF5 file is cut", "[outputs][tables]") {
  const CTestFolder folder;
  LuaExperiment(folder, "<table file='t.h5' fields='pose'/>");
  // an attribute of HDF5 has at most 64 KiB
  const SProgramRun run = folder.Run(
      {"-n", "-c", "e.argos", "--set", "//table/@fields=" + std::string(70000, ' ') + "pose"});
  CAPTURE(run.Out, run.Err);
  CHECK(run.Status == 0);
  CHECK(ReadHDF5Numbers(folder.Path("t.h5"), "x").size() == 8);
}

TEST_CASE("tables: an unknown Lua variable is an error with the known ones", "[outputs][tables]") {
  const CTestFolder folder;
  LuaExperiment(folder, "<table file='v.csv' fields='lua:numbr'/>");
  const SProgramRun run = folder.Run({"-n", "-c", "e.argos"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("lua:numbr") && Contains("did you mean \"lua:number\"?"));
}

TEST_CASE("tables: --csv writes robots and metrics into a folder that it creates",
          "[outputs][tables]") {
  const CTestFolder folder;
  LuaExperiment(folder, "");
  const SProgramRun run =
      folder.Run({"-n", "-c", "e.argos", "--csv", "out/1", "--set", "arena/foot-bot[1]/@id=f3"});
  CAPTURE(run.Err);
  REQUIRE(run.Status == 0);
  CHECK(ReadCSV(folder.Read("out/1/robots.csv")).GetNumRows() == 8);
  CHECK(ReadCSV(folder.Read("out/1/metrics.csv")).GetNumRows() == 4);
  CHECK_THAT(folder.Read("out/1/robots.csv"),
             Contains("# experiment: e.argos\n# set: arena/foot-bot[1]/@id=f3\n"));
  CHECK(folder.Run({"-n", "-c", "e.argos", "--csv", ""}).Status == 1);
  CHECK(folder.Run({"-q", "all", "--csv", "out"}).Status == 1);
}

TEST_CASE("tables: a file that cannot grow ends the run, and the rows in it are whole",
          "[outputs][tables][faults]") {
  const CTestFolder folder;
  const std::string ending = GENERATE("csv", "csv.gz", "h5");
  CAPTURE(ending);
  LuaExperiment(folder, "<table file='t." + ending + "' fields='pose,lua:number'/>");
  // longer, so that there are several blocks of rows
  SCircumstances circumstances;
  circumstances.FileSize = ending == "h5" ? 2000000 : 300000;
  const SProgramRun run = RunProgramUnder(
      folder, {"-n", "-l", "/dev/null", "-c", "e.argos", "--length", "4000"}, circumstances);
  CAPTURE(run.Err);
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("t." + ending) && Contains("File too large"));
  const std::string path = folder.Path("t." + ending);
  if (ending == "h5") {
    const auto x = ReadHDF5Numbers(path, "x");
    CHECK(x.size() > 0);
    CHECK(ReadHDF5Numbers(path, "lua_number").size() == x.size());
    return;
  }
  const std::string text = ending == "csv" ? folder.Read("t.csv") : Unzip(path);
  CHECK(text.size() > 0);
  CHECK(text.back() == '\n');
  CHECK(ReadCSV(text).Columns.at("lua_number").back() != "");
}

TEST_CASE("tables: a file that another process writes stays as it is",
          "[outputs][tables][faults]") {
  const CTestFolder folder;
  const std::string name = GENERATE(as<std::string>(), "t.csv", "t.csv.gz", "t.h5");
  CAPTURE(name);
  LuaExperiment(folder, "<table file='" + name + "'/>");
  const std::string path = folder.Write(name, "of the other process");
  const int file = open(path.c_str(), O_RDWR | O_CLOEXEC);
  REQUIRE(flock(file, LOCK_EX) == 0);
  const SProgramRun run = folder.Run({"-n", "-c", "e.argos"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains(name) && Contains(" is writing it"));
  CHECK(folder.Read(name) == "of the other process");
  close(file);
  CHECK(folder.Run({"-n", "-c", "e.argos"}).Status == 0);
  CHECK(folder.Read(name) != "of the other process");
}

TEST_CASE("tables: a FIFO that nothing reads is an error", "[outputs][tables][faults]") {
  const CTestFolder folder;
  const std::string element = GENERATE(as<std::string>(), "table file='f.csv'",
                                       "metrics file='f.csv.gz'", "recording file='f.rec'");
  CAPTURE(element);
  LuaExperiment(folder, "<" + element + "/>");
  const std::size_t begin = element.find('\'') + 1;
  const std::string name = element.substr(begin, element.rfind('\'') - begin);
  REQUIRE(mkfifo(folder.Path(name).c_str(), 0600) == 0);
  SCircumstances circumstances;
  circumstances.Environment = {"ARGOS_OUTPUT_TIMEOUT=0.3"};
  const SProgramRun run = RunProgramUnder(folder, {"-n", "-c", "e.argos"}, circumstances);
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains(name) && Contains("it is a FIFO, and no program has opened it for "
                                                 "reading within 0.3 s (ARGOS_OUTPUT_TIMEOUT)"));
}

}  // namespace table_faults_test
