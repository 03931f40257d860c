#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/outputs/run_output.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/plugins/factory.h>
#include <argos3/support/child_process.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/testing/support/log_capture.h>
#include <argos3/testing/support/temporary_folder.h>
#include <argos3/testing/unit/plugins/visualizations/short_run.h>

#include <catch2/catch.hpp>

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace povray_output_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

// makes a shell script the program that renders
class CFakePovray {
 public:
  explicit CFakePovray(const std::string& script) {
    const std::string path = m_folder.GetPath() + "/fake";
    std::ofstream(path) << "#!/bin/sh\n" << script;
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    setenv("ARGOS_POVRAY", path.c_str(), 1);
  }
  ~CFakePovray() { unsetenv("ARGOS_POVRAY"); }
  const CTemporaryFolder& GetFolder() const { return m_folder; }

 private:
  CTemporaryFolder m_folder;
};

std::string In(const CTemporaryFolder& folder, const std::string& attributes) {
  return "<povray size='16x16' directory='" + folder.GetPath() + "' " + attributes + "/>";
}

}  // namespace

TEST_CASE("povray: writes scene files of the ticks that are chosen", "[povray]") {
  const CTemporaryFolder folder;
  const CLogCapture log;
  CShortRun(In(folder, "every='4' render='false'")).Run();
  CHECK(folder.List() == std::vector<std::string>{"scene_0000000000.pov", "scene_0000000004.pov",
                                                  "scene_0000000008.pov", "scene_0000000010.pov"});
}

TEST_CASE("povray: an image of the floor is written for each change of it", "[povray]") {
  class CPainting : public CLoopFunctions {
   public:
    explicit CPainting(CSimulator& simulator) : m_simulator(simulator) {}
    CColor GetFloorColor(const CVector2& /*point*/) override { return m_color; }
    void PostStep() override {
      if (m_simulator.GetSpace().GetSimulationClock() == 6) {
        m_color = CColor(0, 0, 200);
        m_simulator.GetSpace().GetFloorEntity().SetChanged();
      }
    }

   private:
    CSimulator& m_simulator;
    CColor m_color = CColor(200, 0, 0);
  };
  const CTemporaryFolder folder;
  const CLogCapture log;
  CShortRun experiment(In(folder, "every='4' render='false'"),
                       "<floor id='floor' source='loop_functions' pixels_per_meter='4'/>");
  CPainting painting(experiment.GetSimulator());
  experiment.GetSimulator().SetLoopFunctions(painting);
  experiment.Run();
  std::vector<std::string> images;
  for (const std::string& file : folder.List()) {
    if (file.ends_with(".ppm")) {
      images.push_back(file);
    }
  }
  REQUIRE(images.size() == 2);
  // 2 m of 4 pixels each way
  CHECK(folder.Read(images[0]).ends_with(std::string("\xc8\0\0", 3)));
  CHECK(folder.Read(images[1]).ends_with(std::string("\0\0\xc8", 3)));
  for (const auto& [scene, image] : {std::pair("scene_0000000000.pov", 0),
                                     {"scene_0000000004.pov", 0},
                                     {"scene_0000000008.pov", 1},
                                     {"scene_0000000010.pov", 1}}) {
    CAPTURE(scene);
    CHECK_THAT(folder.Read(scene), Contains(images[image]) && !Contains(images[1 - image]));
  }
  experiment.GetSimulator().Destroy();
}

TEST_CASE("povray: runs the program in the folder of the scenes", "[povray]") {
  const CTemporaryFolder folder;
  const CLogCapture log;
  // writes its working directory and its arguments as the picture
  const CFakePovray povray(
      "for i; do case $i in +O*) out=${i#+O};; esac; done\n(pwd; echo \"$@\") >\"$out\"\n");
  CShortRun(In(folder, "ticks='0' threads='1' render='true'")).Run();
  CHECK(folder.List() == std::vector<std::string>{"scene_0000000000.png", "scene_0000000000.pov"});
  std::ifstream picture(folder.GetPath() + "/scene_0000000000.png");
  std::string directory;
  std::string arguments;
  std::getline(picture, directory);
  std::getline(picture, arguments);
  CHECK(std::filesystem::equivalent(directory, folder.GetPath()));
  CHECK_THAT(arguments,
             Contains("+Iscene_0000000000.pov") && Contains("+W16 +H16 -D") && Contains("+WT1"));
}

TEST_CASE("povray: POV-Ray renders scenes whose names have blanks and quotes", "[povray]") {
  if (FindProgram("povray").empty()) {
    WARN("no POV-Ray: it renders nothing here");
    return;
  }
  const std::string name =
      GENERATE("a scene ", "it's", "tab\there", "a;b#c", " two  blanks ", "a\"b");
  CAPTURE(name);
  const CTemporaryFolder folder;
  const CLogCapture log;
  std::string escaped = name;
  Replace(escaped, "'", "&apos;");
  Replace(escaped, "\t", "&#9;");
  CShortRun(In(folder, "ticks='0' render='true' base_name='" + escaped + "'")).Run();
  CHECK(folder.List() ==
        std::vector<std::string>{name + "0000000000.png", name + "0000000000.pov"});
}

TEST_CASE("povray: names that POV-Ray cannot open are errors before the run", "[povray]") {
  const std::string name = GENERATE("\u00e9", "'&quot;");
  CAPTURE(name);
  const CTemporaryFolder folder;
  const CLogCapture log;
  const CFakePovray povray("exit 0\n");
  std::string escaped = name;
  Replace(escaped, "'", "&apos;");
  const std::string attributes = "base_name='" + escaped + "' ticks='0' render=";
  CHECK_THROWS_WITH(CShortRun(In(folder, attributes + "'auto'")),
                    Contains("test.argos:5") && Contains("POV-Ray cannot open files"));
  CHECK_NOTHROW(CShortRun(In(folder, attributes + "'false'")).Run());
  CHECK(folder.List().size() == 1);
}

TEST_CASE("povray: the command for a folder and names with blanks is quoted", "[povray]") {
  const CTemporaryFolder folder;
  setenv("ARGOS_POVRAY", "no such povray", 1);
  CLogCapture log(LOGERR);
  CShortRun("<povray size='16x16' directory='" + folder.GetPath() +
            "/my scenes' every='5' base_name='a scene '/>")
      .Run();
  CHECK_THAT(log.GetText(), Contains("Where it is: cd '" + folder.GetPath() +
                                     "/my scenes' && 'no such povray' "
                                     "'Input_File_Name=\"a scene 0000000000.pov\"' "
                                     "'Output_File_Name=\"a scene 0000000000.png\"'"));
  unsetenv("ARGOS_POVRAY");
}

TEST_CASE("povray: tells why a scene cannot be rendered", "[povray]") {
  const CTemporaryFolder folder;
  const CLogCapture log;
  const CFakePovray povray(
      "echo \"File 'scene.pov' line 7: Parse Error: No matching }\" >&2\nexit 3\n");
  CShortRun experiment(In(folder, "every='5' render='true'"));
  CHECK_THROWS_WITH(experiment.Run(), Contains("scene_0000000000.pov") && Contains("status 3") &&
                                          Contains("line 7: Parse Error: No matching }"));
}

TEST_CASE("povray: is started three times where its threads do not start in time", "[povray]") {
  const CTemporaryFolder folder;
  const CLogCapture log;
  const CTemporaryFolder counts;
  const std::string count = counts.GetPath() + "/count";
  const int failures = GENERATE(2, 3);
  CAPTURE(failures);
  const CFakePovray povray("count='" + count + "'\nfailures=" + std::to_string(failures) + R"(
echo >>"$count"
if [ $(wc -l <"$count") -le $failures ]; then
  echo Timed out waiting for worker thread startup >&2
  exit 1
fi
for i; do case $i in +O*) echo >"${i#+O}" ;; esac; done
)");
  CShortRun experiment(In(folder, "ticks='0' render='true'"));
  if (failures < 3) {
    experiment.Run();
    CHECK(folder.List() ==
          std::vector<std::string>{"scene_0000000000.png", "scene_0000000000.pov"});
  } else {
    CHECK_THROWS_WITH(experiment.Run(), Contains("status 1") && Contains("worker thread startup"));
  }
  CHECK(std::filesystem::file_size(count) == 3);
}

TEST_CASE("povray: a program that writes no picture is an error", "[povray]") {
  const CTemporaryFolder folder;
  const CLogCapture log;
  const CFakePovray povray("exit 0\n");
  CShortRun experiment(In(folder, "ticks='0' render='true'"));
  CHECK_THROWS_WITH(experiment.Run(), Contains("cannot render") && Contains("No such file"));
}

TEST_CASE("povray: without POV-Ray, says once how to render", "[povray]") {
  const CTemporaryFolder folder;
  setenv("ARGOS_POVRAY", "no_such_povray", 1);
  CLogCapture log(LOGERR);
  CShortRun(In(folder, "every='5'")).Run();
  CHECK(std::filesystem::exists(folder.Path("scene_0000000005.pov")));
  const std::string text = log.GetText();
  CHECK_THAT(text, Contains("\"no_such_povray\" is not installed. Where it is: cd " +
                            folder.GetPath() + " && no_such_povray +Iscene_0000000000.pov"));
  CHECK(text.find("is not installed") == text.rfind("is not installed"));
  CHECK_THROWS_WITH(CShortRun(In(folder, "render='true'")),
                    Contains("test.argos:5") && Contains("no_such_povray"));
  unsetenv("ARGOS_POVRAY");
}

TEST_CASE("povray: names file and line of wrong attributes", "[povray]") {
  const CTemporaryFolder folder;
  const auto [attributes, message] = GENERATE(table<std::string, std::string>({
      {"quality='god'", "did you mean \"good\"?"},
      {"render='maybe'", "\"maybe\" is not valid"},
      {"look='lihgt'", "did you mean \"light\"?"},
      {"every='0'", "it must be at least 1"},
      {"ticks='5-1'", "is not valid"},
      {"threads='513'", "at most 512"},
      {"max_lights='1001'", "at most 1000"},
      {"base_name='a/b'", "must not contain"},
  }));
  CHECK_THROWS_WITH(CShortRun(In(folder, attributes)),
                    Contains("test.argos:5") && Contains(message));
}

TEST_CASE("povray: names a folder that cannot be written to", "[povray]") {
  CHECK_THROWS_WITH(CShortRun("<povray directory='/proc/no_such_folder' render='false'/>"),
                    Contains("test.argos:5") && Contains("/proc/no_such_folder"));
}

}  // namespace povray_output_test
