// The pages in doc/robots are what the plug-ins say today.

#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/robot_pages.h>

#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>

using namespace argos;

TEST_CASE("robot pages: they say what the plug-ins say", "[contract][robots]") {
  for (const std::string& robot : RobotsWithPages()) {
    CAPTURE(robot);
    std::ifstream file(InSourceTree("doc/robots/" + robot + ".md"));
    REQUIRE(file.good());
    std::ostringstream page;
    page << file.rdbuf();
    INFO("write it anew: cmake --build <build folder> --target robot_pages");
    // not compared in an assertion, which would print both
    const bool isCurrent = page.str() == MakeRobotPage(robot);
    CHECK(isCurrent);
  }
}
