// What the program says of its plug-ins: -q, --json, --schema.

#include "program_run.h"

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/plugins/dynamic_loading.h>
#include <argos3/program/catalogue/facts_json.h>
#include <argos3/program/catalogue/facts_text.h>
#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace query_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

namespace fs = std::filesystem;

size_t WidestProseLine(const std::string& text) {
  std::istringstream lines(text);
  size_t widest = 0;
  for (std::string line; std::getline(lines, line);) {
    const size_t first = line.find_first_not_of(' ');
    // XML examples and names of headers are not broken
    const bool isCode = first != std::string::npos && (line[first] == '<' || line[first] == '#' ||
                                                       line.find("=\"") != std::string::npos);
    widest = isCode ? widest : std::max(widest, line.size());
  }
  return widest;
}

bool IsJson(const CTestFolder& folder, const std::string& text) {
  std::ofstream(folder.Path("answer.json")) << text;
  return std::system(("python3 -m json.tool '" + folder.Path("answer.json") + "' >'" +
                      folder.Path("pretty.json") + "'")
                         .c_str()) == 0;
}

/* Answers of the program to several questions, in this process: the samples are loaded once. */
class CAnswers {
 public:
  std::string AsText(const std::string& query) {
    return WriteText(query, m_catalogue.Find(query), m_catalogue);
  }
  std::string AsJson(const std::string& query) {
    return WriteJson(query, m_catalogue.Find(query), m_catalogue);
  }
  bool IsFound(const std::string& query) { return m_catalogue.Find(query).IsFound(); }

 private:
  struct SLoadedLibraries {
    SLoadedLibraries() { CDynamicLoading::LoadAllLibraries(); }
  };
  SLoadedLibraries m_libraries;  // precede the catalogue, which lists what is loaded
  CCatalogue m_catalogue;
};

// validates files against the schema that the program makes
class CSchema {
 public:
  CSchema() {
    // once for all tests: it takes samples of every plug-in
    static const SProgramRun run = CTestFolder().Run({"--schema", "rng"});
    CAPTURE(run.Err);
    REQUIRE(run.Status == 0);
    std::ofstream(m_folder.Path("argos.rng")) << run.Out;
  }

  bool AcceptsFile(const std::string& file) const {
    return std::system(("xmllint --noout --relaxng '" + m_folder.Path("argos.rng") + "' '" + file +
                        "' >'" + m_folder.Path("xmllint.txt") + "' 2>&1")
                           .c_str()) == 0;
  }
  bool Accepts(const std::string& xml) const {
    std::ofstream(m_folder.Path("file.argos")) << xml;
    return AcceptsFile(m_folder.Path("file.argos"));
  }
  /** Names of all elements and attributes. */
  std::set<std::string> ListNames() const {
    CConfigurationDocument document;
    document.LoadFile(m_folder.Path("argos.rng"));
    std::set<std::string> names;
    CollectNames(document.GetRoot(), names);
    return names;
  }
  std::string GetMessages() const { return m_folder.Read("xmllint.txt"); }

 private:
  static void CollectNames(TConfigurationNode& pattern, std::set<std::string>& names) {
    if (pattern.Value() == "element" || pattern.Value() == "attribute") {
      names.insert(pattern.GetAttribute("name"));
    }
    TConfigurationNodeIterator it;
    for (it = it.begin(&pattern); it != it.end(); ++it) {
      CollectNames(*it, names);
    }
  }

  CTestFolder m_folder;
};

// elements and attributes that sources read of experiment files
std::set<std::string> NamesThatAreRead() {
  static const std::regex kReading(
      "(?:GetNode|NodeExists|GetNodeAttribute|GetNodeAttributeOrDefault|NodeAttributeExists)"
      "\\([^;{]*?\"([a-z_]+)\"");
  std::set<std::string> names;
  for (const char* const folder :
       {"src/core/simulator", "src/core/control_interface", "src/plugins", "src/compat"}) {
    for (const auto& entry : fs::recursive_directory_iterator(InSourceTree(folder))) {
      if (entry.path().extension() == ".cpp") {
        std::ifstream file(entry.path());
        const std::string source((std::istreambuf_iterator<char>(file)), {});
        const std::sregex_iterator found(source.begin(), source.end(), kReading);
        std::for_each(found, std::sregex_iterator(),
                      [&names](const std::smatch& match) { names.insert(match[1]); });
      }
    }
  }
  return names;
}

/* What "-q all --json" says of elements. */
struct SDescribedElements {
  std::set<std::string> Attributes;  // "tag@name"
  std::set<std::string> WithoutText;  // the same
  std::set<std::string> InManuals;  // the same, of rows of tables
};

// names are those of attributes: "tag@one, @other"
void AddRow(const std::string& names, std::set<std::string>& attributes) {
  static const std::regex kName("([a-z_]*)@([a-z_]+)");
  std::string tag;
  for (std::sregex_iterator it(names.begin(), names.end(), kName), end; it != end; ++it) {
    tag = (*it)[1].length() > 0 ? std::string((*it)[1]) : tag;
    attributes.insert(tag + '@' + std::string((*it)[2]));
  }
}

SDescribedElements ReadElements(const std::string& json) {
  static const std::regex kElement("\"element\": \"(?:[^\"]*/)?([^\"/ ]+)(?: \\([a-z_]+\\))?\"");
  static const std::regex kRow("\\\\n  +((?:[a-z_/]*@[a-z_]+, )*[a-z_/]*@[a-z_]+)  ");
  SDescribedElements all;
  std::istringstream lines(json);
  std::string attribute;
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    const size_t name = line.find("\"name\": \"");
    if (std::regex_search(line, match, kElement)) {
      attribute = std::string(match[1]) + '@';
    } else if (!attribute.empty() && name != std::string::npos) {
      attribute += line.substr(name + 9, line.rfind('"') - name - 9);
      all.Attributes.insert(attribute);
    } else if (!attribute.empty() && line.find("\"text\": ") != std::string::npos) {
      if (line.find("\"text\": \"\"") != std::string::npos) {
        all.WithoutText.insert(attribute);
      }
      attribute.clear();
    } else if (line.find("\"manual\": ") != std::string::npos) {
      for (std::sregex_iterator it(line.begin(), line.end(), kRow), end; it != end; ++it) {
        AddRow((*it)[1], all.InManuals);
      }
    }
  }
  return all;
}

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

constexpr const char* kExperiment = R"(<?xml version="1.0"?>
<argos-configuration>
  <framework>
    <system threads="0" />
    <experiment length="10" ticks_per_second="10" random_seed="1" />
  </framework>
  <controllers>
    <my_controller id="c1" library="libmine">
      <actuators><leds implementation="default" medium="leds" /></actuators>
      <sensors>
        <footbot_proximity implementation="default" show_rays="true">
          <noise model="gaussian" std_dev="0.1" />
        </footbot_proximity>
      </sensors>
      <params anything="1"><at all="2" /></params>
    </my_controller>
  </controllers>
  <arena size="4, 4, 2" center="0,0,0.5">
    <box id="b" size="1,1,0.5" movable="true" mass="2"><body position="1,0,0" /></box>
    <distribute>
      <position method="uniform" min="-1,-1,0" max="1,1,0" />
      <orientation method="constant" values="0,0,0" />
      <entity quantity="3" max_trials="100">
        <foot-bot id="fb" rab_range="2"><controller config="c1" /></foot-bot>
      </entity>
    </distribute>
  </arena>
  <physics_engines><dynamics2d id="d" iterations="4" /></physics_engines>
  <media><led id="leds" /></media>
  <visualization />
</argos-configuration>
)";

}  // namespace

TEST_CASE("queries: a device has its C++ and Lua interfaces, robots and XML",
          "[command_line][query]") {
  const CTestFolder folder;
  const SProgramRun run = folder.Run({"-q", "range_and_bearing"});
  CHECK(run.Status == 0);
  CHECK(run.Err == "");
  for (const char* const fact :
       {"[ range_and_bearing (medium) ]\n", "A sensor.\n", "CCI_RangeAndBearingSensor\n",
        "#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_",
        "link ARGoS::genericrobot (libargos3plugin_simulator_genericrobot.so)\n",
        "GetReadings() const\n", "Real Range                        cm\n",
        "robot.range_and_bearing[i].horizontal_bearing  number\n",
        "robot.range_and_bearing.set_data()\n", "e-puck, eye-bot, foot-bot\n", "noise_std_dev",
        "[ range_and_bearing ]\n", "A medium.\n"}) {
    CAPTURE(fact);
    CHECK_THAT(run.Out, Contains(fact));
  }
  for (const char* const word : {"authors of this project", "undefined", "Usable"}) {
    CAPTURE(word);
    CHECK_THAT(run.Out, !Contains(word));
  }
  CHECK(WidestProseLine(run.Out) <= 80);
}

TEST_CASE("queries: all facts of all plug-ins are readable in 80 columns",
          "[command_line][query]") {
  const CTestFolder folder;
  for (const char* const label : {"all", "foot-bot", "prototype", "cameras", "dynamics3d",
                                  "offscreen", "pheromone", "robot-type", "lua_controller"}) {
    CAPTURE(label);
    const SProgramRun run = folder.Run({"-q", label});
    CHECK(run.Status == 0);
    CHECK(WidestProseLine(run.Out) <= 80);
    CHECK_THAT(run.Out, !Contains("undefined") && !Contains("authors of this project"));
  }
}

TEST_CASE("queries: a robot lists the devices that fit", "[command_line][query]") {
  const CTestFolder folder;
  const SProgramRun run = folder.Run({"-q", "e-puck"});
  CHECK_THAT(run.Out, Contains("SENSORS THAT FIT\n") && Contains("  epuck_proximity (default)\n") &&
                          Contains("  magnets (default), with <magnets> in its element\n") &&
                          !Contains("footbot_turret"));
  CHECK_THAT(folder.Run({"-q", "joints"}).Out,
             Contains("ROBOTS\n\n  prototype\n  each with <joints> inside"));
}

TEST_CASE("queries: elements and attributes of experiment files, with types, units and defaults",
          "[command_line][query]") {
  CAnswers answers;
  const std::pair<const char*, const char*> facts[] = {
      {"experiment", "ticks_per_second"},
      {"system", "pin_threads_to_cores"},
      {"profiling", "truncate_file"},
      {"arena", "redistribute"},
      {"distribute", "entity@max_trials"},
      {"boundaries", "vertex@point"},
      {"noise", "gaussian"},
      {"on_error", "framework/experiment\n  on_error  text\n"},
      {"base_num", "arena/distribute/entity\n"},
      {"real_time", "framework/experiment\n  real_time  boolean\n"},
      {"rab_range", "arena/e-puck"},
      {"reuse_readings", "arena/foot-bot/controller/params"},
      {"vertex", "physics_engines/dynamics2d/boundaries/sides/vertex"}};
  for (const auto& [word, fact] : facts) {
    CAPTURE(word);
    const std::string text = answers.AsText(word);
    CHECK_THAT(text, Contains("[ " + std::string(word) + " ]\n") && Contains(fact));
    CHECK(WidestProseLine(text) <= 80);
  }
  CHECK_FALSE(answers.IsFound("on_eror"));
  CHECK_THAT(answers.AsText("on_eror"), Contains("did you mean on_error?"));
  CHECK_THAT(answers.AsText("xyzxyz"), Contains("argos3 -q all"));
  CHECK_THAT(answers.AsText("Proximity"), Contains("epuck_proximity"));

  // types, units and defaults of attributes
  const auto attribute = [](const char* name, const char* type, const char* unit,
                            const char* initial) {
    const std::string line = ",\n          \"";
    return "\"name\": \"" + std::string(name) + '"' + line + "type\": \"" + type + '"' + line +
           "unit\": \"" + unit + '"' + line + "default\": \"" + initial + '"';
  };
  CHECK_THAT(answers.AsJson("experiment"), Contains(attribute("length", "real", "s", "0")));
  // of the other implementation, whose samples do not contain it
  CHECK_THAT(answers.AsJson("differential_steering"),
             Contains(attribute("bias_avg", "real", "m/s", "0")) &&
                 Contains(attribute("factor_stddev_left", "real", "", "that of factor_stddev")) &&
                 !Contains("\"name\": \"bias_avg\",\n          \"type\": \"text\""));
  // not what another view says of a child of it
  CHECK_THAT(answers.AsJson("qt-opengl"),
             Contains("path or name of the library that contains the plug-in."));
  // not those of the arena, which has an attribute of this name
  CHECK_THAT(answers.AsJson("walls"),
             Contains(attribute("threshold", "real", "", "0.5")) && !Contains("redistribute"));
  // a field has this name, too
  CHECK_THAT(answers.AsJson("distribute"), Contains("\"element\": \"distribute/orientation\""));
}

TEST_CASE("queries: every attribute that is read has a text, and every text is of one that is read",
          "[command_line][query]") {
  const CTestFolder folder;
  const SProgramRun run = folder.Run({"-q", "all", "--json"});
  REQUIRE(run.Status == 0);
  CHECK(IsJson(folder, run.Out));
  const SDescribedElements all = ReadElements(run.Out);
  CHECK(all.Attributes.size() >= 500);
  CHECK(all.WithoutText == std::set<std::string>());
  CHECK(all.InManuals.size() >= 100);
  for (const std::string& attribute : all.InManuals) {
    CAPTURE(attribute);
    CHECK(all.Attributes.count(attribute) == 1);
  }
}

TEST_CASE("queries: a device that no robot has shows what its header says of Lua",
          "[command_line][query]") {
  const CTestFolder folder;
  CHECK_THAT(folder.Run({"-q", "planar_drive"}).Out,
             Contains("IN LUA\n\n  robot.planar_drive.set_velocity(ahead, left, yaw_rate)\n") &&
                 Contains("None of the loaded libraries"));
}

TEST_CASE("queries: without a word all plug-ins are listed", "[command_line][query]") {
  const CTestFolder folder;
  CHECK(folder.Run({"-q"}).Out == folder.Run({"-q", "all"}).Out);
}

TEST_CASE("queries: what is not found has suggestions and the status 1", "[command_line][query]") {
  const CTestFolder folder;
  const SProgramRun rnage = folder.Run({"-q", "rnage"});
  CHECK(rnage.Status == 1);
  CHECK_THAT(rnage.Out, Contains("did you mean range_and_bearing, pipuck_rangefinders?"));
  // a field has this name; the initials are those of the device
  CHECK_THAT(folder.Run({"-q", "rab"}).Out,
             Contains("[ rab ]") && Contains("See also: ") && Contains("range_and_bearing\n"));
}

TEST_CASE("queries: a control interface finds its devices", "[command_line][query]") {
  const CTestFolder folder;
  CHECK_THAT(folder.Run({"-q", "CCI_LEDsActuator"}).Out,
             Contains("[ leds (default) ]") && !Contains("directional_leds (default) ]"));
}

TEST_CASE("queries: libraries that an experiment names are known", "[command_line][query]") {
  const CTestFolder folder;
  std::ofstream(folder.Path("e.argos"))
      << "<argos-configuration><controllers><x id='a' library='no_such_library' /></controllers>"
         "</argos-configuration>";
  const SProgramRun run = folder.Run({"-q", "leds", "-c", "e.argos"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("no_such_library"));
}

TEST_CASE("queries: JSON has the same facts", "[command_line][query]") {
  const CTestFolder folder;
  const SProgramRun run = folder.Run({"-q", "footbot_proximity", "--json"});
  CHECK(run.Status == 0);
  CHECK(IsJson(folder, run.Out));
  for (const char* const fact :
       {"\"class\": \"CCI_FootBotProximitySensor\"", "\"link\": \"ARGoS::footbot\"",
        "\"path\": \"robot.proximity[i].angle\"", "\"robot\": \"foot-bot\"",
        "\"name\": \"show_rays\",\n          \"type\": \"boolean\",\n          \"unit\": \"\",\n   "
        "       \"default\": \"false\"",
        "\"list\": \"sensors\""}) {
    CAPTURE(fact);
    CHECK_THAT(run.Out, Contains(fact));
  }
  const SProgramRun nothing = folder.Run({"-q", "rnage", "--json"});
  CHECK(nothing.Status == 1);
  CHECK(IsJson(folder, nothing.Out));
  CHECK_THAT(nothing.Out, Contains("\"plugins\": []") && Contains("\"range_and_bearing\""));
}

TEST_CASE("queries: names for completion are one a line", "[command_line][query]") {
  const CTestFolder folder;
  const SProgramRun run = folder.Run({"--generate", "plugins"});
  CHECK(run.Status == 0);
  CHECK_THAT(run.Out, Contains("all\n") && Contains("sensors\n") && Contains("\nfoot-bot\n") &&
                          Contains("\nrange_and_bearing\n"));
  CHECK(run.Out.find(' ') == std::string::npos);
}

TEST_CASE("schemas: every experiment of the repository is valid", "[command_line][schema]") {
  const CSchema schema;
  size_t files = 0;
  for (const char* const folder : {"experiments", "examples", "studies"}) {
    for (const auto& entry : fs::recursive_directory_iterator(InSourceTree(folder))) {
      const std::string file = entry.path().string();
      // what their libraries add is not known without them; the guide checks these
      const bool hasOwnPlugins = entry.path().filename().string().rfind("own_", 0) == 0;
      if (entry.path().extension() == ".argos" && !hasOwnPlugins) {
        const bool isValid = schema.AcceptsFile(file);
        INFO(schema.GetMessages());
        CAPTURE(file);
        CHECK(isValid);
        ++files;
      }
    }
  }
  CHECK(files >= 30);
}

TEST_CASE("schemas: every element and attribute that is read is in it", "[command_line][schema]") {
  const std::set<std::string> inSchema = CSchema().ListNames();
  std::set<std::string> read = NamesThatAreRead();
  // of <loop_functions>, <user_functions> and <frame_grabbing>, which may contain anything; of
  // entities that users' code makes; of older files
  for (const char* const name : {"label", "script", "headless_grabbing", "headless_frame_size",
                                 "headless_frame_rate", "msg_size", "idx"}) {
    read.erase(name);
  }
  CHECK(read.size() >= 150);
  for (const std::string& name : read) {
    CAPTURE(name);
    CHECK(inSchema.count(name) == 1);
  }
}

TEST_CASE("schemas: misspelt names and texts in place of numbers are not valid",
          "[command_line][schema]") {
  const CSchema schema;
  const bool isValid = schema.Accepts(kExperiment);
  INFO(schema.GetMessages());
  REQUIRE(isValid);
  const std::pair<const char*, const char*> faults[] = {
      {"<framework>", "<framework><sytem threads=\"0\" />"},
      {"threads=\"0\"", "thread=\"0\""},
      {"threads=\"0\"", "threads=\"none\""},
      {"length=\"10\"", "length=\"long\""},
      {"<experiment length=\"10\" ticks_per_second=\"10\"", "<experiment length=\"10\""},
      {"<leds ", "<led "},
      {"implementation=\"default\" medium", "implementation=\"defualt\" medium"},
      {"medium=\"leds\"", "meduim=\"leds\""},
      {" medium=\"leds\"", ""},
      {"show_rays=\"true\"", "show_rays=\"yes\""},
      {"<noise model", "<nosie model"},
      {"std_dev=\"0.1\"", "std_dev=\"a tenth\""},
      {"size=\"4, 4, 2\"", "size=\"4, 4\""},
      {"mass=\"2\"", "mass=\"2 kg\""},
      {"<box ", "<boxx "},
      {"<body position", "<bdoy position"},
      {"position=\"1,0,0\"", "postion=\"1,0,0\""},
      {"quantity=\"3\"", "quantity=\"three\""},
      {"quantity=\"3\" ", ""},
      {"rab_range=\"2\"", "rab_rnage=\"2\""},
      {"iterations=\"4\"", "iterations=\"4.5\""},
      {"<dynamics2d ", "<dynamic2d "},
      {"<media>", "<mediums>"}};
  for (const auto& [right, wrong] : faults) {
    CAPTURE(right, wrong);
    std::string xml = Replaced(kExperiment, right, wrong);
    if (xml.find("<boxx") != std::string::npos) {
      xml = Replaced(xml, "</box>", "</boxx>");
    } else if (xml.find("<mediums>") != std::string::npos) {
      xml = Replaced(xml, "</media>", "</mediums>");
    } else if (xml.find("<leds ") == std::string::npos) {
      REQUIRE(wrong == std::string("<led "));
    }
    CHECK_FALSE(schema.Accepts(xml));
  }
}

TEST_CASE(
    "schemas: attributes of every model of batteries, and noise of every algorithm of cameras",
    "[command_line][schema]") {
  const CSchema schema;
  for (const char* const battery :
       {"discharge_model='time' delta='1e-4'",
        "discharge_model='motion' pos_delta='1e-3' orient_delta='1e-3'",
        "discharge_model='time_motion' time_factor='1' pos_factor='1' orient_factor='1'"}) {
    CAPTURE(battery);
    const std::string robots = "<foot-bot id='f'><controller config='c' /><battery " +
                               std::string(battery) +
                               " /></foot-bot><e-puck id='e'><controller "
                               "config='c' /><battery " +
                               battery + " /></e-puck><box ";
    CHECK(schema.Accepts(Replaced(kExperiment, "<box ", robots)));
    CHECK_FALSE(schema.Accepts(
        Replaced(kExperiment, "<box ", Replaced(robots, "discharge_model", "discharge_mode"))));
  }
  const std::string noise =
      "<noise on='x' model='gaussian' std_dev='0.5' bias='1' /><noise "
      "model='rayleigh' sigma='1' relative='true' />";
  std::string cameras =
      "<sensors><cameras implementation='default'><camera id='c' anchor='origin' "
      "position='0,0,0' orientation='0,0,0' range='0:2' focal_length='500,500' "
      "principal_point='320,240' resolution='640,480'>";
  for (const char* const name : {"led_detector", "directional_led_detector", "tag_detector"}) {
    cameras += "<" + std::string(name) + " medium='m'>" + noise + "</" + name + ">";
  }
  cameras += "</camera></cameras>";
  CHECK(schema.Accepts(Replaced(kExperiment, "<sensors>", cameras)));
}

TEST_CASE("schemas: robots of <robot_types> have any tag", "[command_line][schema]") {
  const CSchema schema;
  const std::string types = R"(<robot_types><robot-type id="disc"><body mass="0.4">
    <solid geometry="cylinder" radius="0.04" height="0.05" /></body>
    <differential_drive wheel_distance="0.06" wheel_radius="0.02" max_force="1" max_torque="1" />
    </robot-type></robot_types>)";
  const std::string robot = "<disc id=\"d0\"><body position=\"0,0,0\" /></disc><box ";
  const std::string withRobot = Replaced(kExperiment, "<box ", robot);
  CHECK_FALSE(schema.Accepts(withRobot));
  CHECK(schema.Accepts(Replaced(withRobot, "<controllers>", types + "<controllers>")));
  CHECK_FALSE(schema.Accepts(
      Replaced(withRobot, "<controllers>",
               Replaced(types, "wheel_radius=\"0.02\"", "wheel_radius=\"x\"") + "<controllers>")));
}

TEST_CASE("schemas: the compact syntax has the same definitions", "[command_line][schema]") {
  const CTestFolder folder;
  const SProgramRun compact = folder.Run({"--schema", "rnc"});
  CHECK(compact.Status == 0);
  CHECK_THAT(compact.Out, Contains("\nstart =\n") && Contains("element argos-configuration {") &&
                              Contains("attribute ticks_per_second { natural }"));
  const SProgramRun wrong = folder.Run({"--schema", "xsd"});
  CHECK(wrong.Status == 1);
  CHECK_THAT(wrong.Err, Contains("--schema xsd: unknown; known: rng, rnc"));
}

TEST_CASE("plug-ins: the simplest of each kind is found, runs and is described",
          "[command_line][query]") {
  const CTestFolder folder;
  std::ofstream(folder.Path("simplest.argos"))
      << R"(<argos-configuration>
  <framework><experiment length="1" ticks_per_second="10" random_seed="1" /></framework>
  <controllers />
  <arena size="4,4,2">
    <box id="b" size="1,1,1" movable="true" mass="1"><body position="1,0,0" /></box>
  </arena>
  <physics_engines><test_simplest_engine id="e" library=")"
      << InBuildTree("testing/plugins/libargos3_test_simplest.so") << R"(" /></physics_engines>
  <media><test_simplest_medium id="m" /></media>
  <outputs>
    <table file="t.csv" of="box" fields="test_simplest_field" />
    <metrics file="m.csv" builtin="test_simplest_metric" />
    <test_simplest_output />
  </outputs>
  <visualization><test_simplest_view /></visualization>
</argos-configuration>)";
  const SProgramRun run = folder.Run({"simplest.argos"});
  CHECK(run.Status == 0);
  CHECK(run.Err == "");
  CHECK_THAT(run.Out, Contains("view\n") && Contains("states: 11\n"));
  CHECK_THAT(folder.Read("t.csv"), Contains("simplest_column") && Contains("b,7\n"));
  CHECK_THAT(folder.Read("m.csv"), Contains("test_simplest_metric") && Contains(",10"));
  for (const char* const kind : {"engine", "medium", "output", "field", "metric", "view"}) {
    CAPTURE(kind);
    const std::string label = "test_simplest_" + std::string(kind);
    const SProgramRun query = folder.Run({"-q", label, "-c", "simplest.argos"});
    CHECK(query.Status == 0);
    CHECK_THAT(query.Out, Contains("[ " + label + " ]") && Contains("About it."));
  }
  CHECK_THAT(folder.Run({"-q", "test_simplest_element", "-c", "simplest.argos"}).Out,
             Contains("An element by A. Author") && Contains("default 1."));
}

TEST_CASE("argos3: manual page and completions are generated", "[command_line]") {
  const auto [word, start] = GENERATE(table<std::string, std::string>(
      {{"man", ".TH "}, {"zsh", "#compdef argos3"}, {"bash", "complete"}}));
  const SProgramRun run = CTestFolder().Run({"--generate", word});
  CHECK(run.Status == 0);
  CHECK_THAT(run.Out, Contains(start) && Contains("threads"));
}

}  // namespace query_test
