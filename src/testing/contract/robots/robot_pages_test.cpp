// The pages in doc/robots equal those generated from the plug-ins.

#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/robot_pages.h>

#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>

namespace robot_pages_test {

using namespace argos;

TEST_CASE("robot pages: are up to date with the descriptions of the plug-ins",
          "[contract][robots]") {
  for (const std::string& robot : RobotsWithPages()) {
    CAPTURE(robot);
    std::ifstream file(InSourceTree("doc/robots/" + robot + ".md"));
    REQUIRE(file.good());
    std::ostringstream page;
    page << file.rdbuf();
    INFO("regenerate it: cmake --build <build folder> --target robot_pages");
    // compared outside an assertion, which would print both texts
    const bool isCurrent = page.str() == MakeRobotPage(robot);
    CHECK(isCurrent);
  }
}

}  // namespace robot_pages_test
