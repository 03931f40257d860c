#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/outputs/run_output.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/logging/log_control.h>
#include <argos3/core/utility/plugins/factory.h>
#include <argos3/testing/support/log_capture.h>
#include <argos3/testing/support/temporary_folder.h>
#include <argos3/testing/unit/plugins/visualizations/short_run.h>

#include <catch2/catch.hpp>

#include <FreeImage.h>

#include <filesystem>
#include <string>

namespace offscreen_output_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

std::string Frame(const std::string& tick) {
  return "frame_" + std::string(10 - tick.size(), '0') + tick + ".png";
}

}  // namespace

TEST_CASE("offscreen: frames show the first state, every n-th tick, and the last state",
          "[visualizations][offscreen]") {
  const CTemporaryFolder folder;
  CLogCapture log(LOGERR);
  CShortRun experiment("<offscreen directory='" + folder.GetPath() +
                       "/new' size='64x48' every='4'/>");
  experiment.GetSimulator().Execute();
  CHECK(experiment.GetSimulator().GetSpace().GetSimulationClock() == 10);
  CHECK(folder.List("new") ==
        std::vector<std::string>{Frame("0"), Frame("4"), Frame("8"), Frame("10")});
  CHECK_THAT(log.GetText(), Contains("64x48") && Contains("every 4 ticks"));
}

TEST_CASE("offscreen: the log names the driver of OpenGL only at the level debug",
          "[visualizations][offscreen]") {
  for (const ELogLevel level : {ELogLevel::Info, ELogLevel::Debug}) {
    const CTemporaryFolder folder;
    CLogCapture log(LOGERR);
    CLogControl::SetLevel(level);
    CShortRun experiment("<offscreen directory='" + folder.GetPath() + "' size='64x48'/>");
    experiment.GetSimulator().Execute();
    CLogControl::SetLevel(ELogLevel::Info);
    CHECK_THAT(log.GetText(), Contains("64x48"));
    CHECK((log.GetText().find("OpenGL") != std::string::npos) == (level == ELogLevel::Debug));
  }
}

TEST_CASE("offscreen: a frame has the requested size", "[visualizations][offscreen]") {
  const CTemporaryFolder folder;
  CShortRun experiment("<offscreen directory='" + folder.GetPath() +
                       "' size='100x60' every='100' samples='1'/>");
  experiment.GetSimulator().Execute();
  FIBITMAP* bitmap = FreeImage_Load(FIF_PNG, (folder.GetPath() + "/" + Frame("10")).c_str());
  REQUIRE(bitmap != nullptr);
  CHECK(FreeImage_GetWidth(bitmap) == 100);
  CHECK(FreeImage_GetHeight(bitmap) == 60);
  FreeImage_Unload(bitmap);
}

TEST_CASE("offscreen: after a reset the run writes the same frames",
          "[visualizations][offscreen]") {
  const CTemporaryFolder folder;
  CShortRun experiment("<offscreen directory='" + folder.GetPath() + "' size='64x48' every='5'/>");
  experiment.GetSimulator().Execute();
  std::filesystem::remove(folder.GetPath() + "/" + Frame("5"));
  experiment.GetSimulator().Reset();
  experiment.GetSimulator().Execute();
  CHECK(folder.List() == std::vector<std::string>{Frame("0"), Frame("5"), Frame("10")});
}

TEST_CASE("offscreen: drawing does not change the run", "[visualizations][offscreen]") {
  const CTemporaryFolder folder;
  CShortRun drawn("<offscreen directory='" + folder.GetPath() + "' size='64x48'/>");
  drawn.GetSimulator().Execute();
  const UInt64 digest = drawn.GetSimulator().GetSpace().ComputeDigest();
  CShortRun headless("");
  headless.GetSimulator().Execute();
  CHECK(headless.GetSimulator().GetSpace().ComputeDigest() == digest);
}

TEST_CASE("offscreen: errors are reported while loading, with their place",
          "[visualizations][offscreen]") {
  CHECK_THROWS_WITH(CShortRun("<offscreen format='mpg'/>"),
                    Contains("test.argos:") && Contains("\"mpg\"") && Contains("png"));
  CHECK_THROWS_WITH(CShortRun("<offscreen directory='/dev/null'/>"),
                    Contains("\"/dev/null\": it is not a directory"));
  CHECK_THROWS_WITH(CShortRun("<offscreen size='1x1'/>"), Contains("out of range"));
  const CTemporaryFolder folder;
  CHECK_THROWS_WITH(
      CShortRun("<offscreen directory='" + folder.GetPath() +
                "'><user_functions label='unknown' library='/no/such/lib.so'/>"
                "</offscreen>"),
      Contains("test.argos:5: <user_functions label=\"unknown\">") && Contains("/no/such/lib.so"));
}

TEST_CASE(
    "qt-opengl: a file without frame grabbing runs headless, and a line of the log reports it",
    "[visualizations][offscreen]") {
  CLogCapture log;
  CShortRun experiment(
      "<qt-opengl><camera><placement idx='0' position='0,0,1' look_at='0,1,0'/>"
      "</camera></qt-opengl>");
  experiment.GetSimulator().Execute();
  CHECK(experiment.GetSimulator().GetSpace().GetSimulationClock() == 10);
  CHECK_THAT(log.GetText(), Contains("<qt-opengl>") && Contains("headless"));
}

TEST_CASE("qt-opengl: user functions are loaded only for frames", "[visualizations][offscreen]") {
  const std::string functions = "<user_functions label='unknown'/>";
  CLogCapture log;
  CHECK_NOTHROW(CShortRun("<qt-opengl>" + functions + "</qt-opengl>"));
  CHECK_THAT(log.GetText(), Contains("headless, without its user functions"));
  const CTemporaryFolder folder;
  CHECK_THROWS_WITH(CShortRun("<qt-opengl>" + functions + "<frame_grabbing directory='" +
                              folder.GetPath() + "'/></qt-opengl>"),
                    Contains("test.argos:5: <user_functions label=\"unknown\">") &&
                        Contains("there is no CDrawingFunctions"));
}

TEST_CASE("qt-opengl: a file with frame grabbing writes every n-th frame",
          "[visualizations][offscreen]") {
  const CTemporaryFolder folder;
  CLogCapture log(LOGERR);
  CShortRun experiment("<qt-opengl><frame_grabbing directory='" + folder.GetPath() +
                       "/' headless_grabbing='true' headless_frame_size='64x48'"
                       " headless_frame_rate='4'/></qt-opengl>");
  experiment.GetSimulator().Execute();
  CHECK(folder.List() == std::vector<std::string>{Frame("0"), Frame("4"), Frame("8")});
  CHECK_THAT(log.GetText(), Contains("<qt-opengl>") && Contains("asks for frames"));
}

TEST_CASE("qt-opengl: the directory for frames must exist", "[visualizations][offscreen]") {
  CHECK_THROWS_WITH(
      CShortRun("<qt-opengl><frame_grabbing directory='/no/such/place'/></qt-opengl>"),
      Contains("\"/no/such/place\": there is no such directory"));
}

TEST_CASE("offscreen: both visualizations are registered and describe their XML",
          "[visualizations][offscreen]") {
  for (const std::string label : {"offscreen", "qt-opengl"}) {
    CAPTURE(label);
    REQUIRE(CFactory<CRunOutput>::Exists(label));
    const auto& info = *CFactory<CRunOutput>::GetTypeMap().find(label)->second;
    CHECK_THAT(info.LongDescription, Contains("<" + label));
    CHECK_FALSE(info.BriefDescription.empty());
  }
}

TEST_CASE("offscreen: only the ticks that are asked for have frames",
          "[visualizations][offscreen]") {
  const CTemporaryFolder folder;
  CShortRun experiment("<offscreen directory='" + folder.GetPath() +
                       "' size='64x48' every='2' ticks='3-6,9'/>");
  experiment.GetSimulator().Execute();
  CHECK(folder.List() == std::vector<std::string>{Frame("4"), Frame("6")});
}

}  // namespace offscreen_output_test
