// Values of --set that have no effect.

#include "../command_line/program_run.h"
#include "experiment_text.h"

#include <argos3/core/utility/configuration/argos_configuration.h>

#include <catch2/catch.hpp>

namespace overrides_test {

using namespace argos;
using Catch::Contains;

namespace {

std::string SetError(const std::string& path, const std::string& value) {
  const CTestFolder folder;
  folder.Write("test.argos", SExperimentText().ToXml());
  const SProgramRun run = folder.Run({"-c", "test.argos", "--set", path + '=' + value});
  CHECK(run.Status == (run.Err.empty() ? 0 : 1));
  return run.Err;
}

}  // namespace

TEST_CASE("option --set: a value that nothing reads is an error with the nearest name",
          "[bad_input]") {
  const std::string error = SetError("//e-puck/@rab_rage", "0.5");
  CHECK_THAT(error, Contains("--set //e-puck/@rab_rage=0.5: test.argos:6: <e-puck>: attribute "
                             "\"rab_rage\" is not used by anything; did you mean \"rab_range\"?"));
  CHECK_THAT(SetError("physics_engines/dynamics2d/@iteration", "5"),
             Contains("did you mean \"iterations\" or "));
  CHECK_THAT(SetError("framework/experiment/@lenght", "5"), Contains("did you mean \"length\"?"));
  // without a similar name
  CHECK_THAT(SetError("arena/@zzz", "5"), Contains("\"zzz\" is not used by anything") &&
                                              !Contains("did you mean") && Contains("[FATAL]"));
}

TEST_CASE("option --set: values that are read late, or by some of the elements, are accepted",
          "[bad_input]") {
  CHECK(SetError("//e-puck/@rab_range", "0.5").empty());
  CHECK(SetError("//box/@mass", "2").empty());
  // <body> reads an id
  CHECK(SetError("arena/box/body/@id", "b").empty());
}

TEST_CASE("document: settings that nothing has read are described, also of replaced elements",
          "[bad_input]") {
  CConfigurationDocument document;
  document.Parse("<a>\n<b x='1' y='1'/>\n<b y='2'/>\n<c/>\n</a>", "e.argos");
  document.SetByPath("//b/@y", "3");
  document.SetByPath("//b/@z", "4");
  document.SetByPath("c/@x", "5");
  TConfigurationNode& root = document.GetRoot();
  // replaced by a copy, as some sections replace elements
  root.InsertEndChild(GetNode(root, "b"));
  root.RemoveChild(&GetNode(root, "b"));
  std::string text;
  GetNodeAttributeOrDefault(*root.LastChildElement(), "y", text, text);
  GetNodeAttributeOrDefault(GetNode(root, "b"), "zz", text, text);
  const std::vector<std::string> unread = document.DescribeUnreadSettings();
  REQUIRE(unread.size() == 2);
  CHECK_THAT(unread[0], Contains("--set //b/@z=4: e.argos:") && Contains("<b>: attribute \"z\""));
  CHECK(unread[1] ==
        "--set c/@x=5: e.argos:4: <c> is not used by anything, nor is its attribute \"x\"");
}

}  // namespace overrides_test
