#include <argos3/plugins/simulator/visualizations/povray/sdl_text.h>

#include <argos3/testing/support/comma_locale.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace sdl_text_test {

using namespace argos;

TEST_CASE("sdl text: numbers read back exactly, whatever the locale", "[povray]") {
  const CCommaLocale locale;
  CHECK(ToSdl(0.1) == "0.1");
  CHECK(ToSdl(-1234567.25) == "-1234567.25");
  CHECK(std::stof(ToSdl(0.1f).replace(1, 1, ",")) == 0.1f);
  CHECK(ToSdl(Eigen::Vector3d(1.5, -2.0, 0.25)).find("1.5,-2") == 1);
  CHECK(ToSdl(std::array<float, 3>{0.1f, 0.2f, 1e-9f}) == "<0.1,0.2,1e-09>");
}

TEST_CASE("sdl text: colours are sRGB, with transmission if translucent", "[povray]") {
  CHECK(ToSdl(SRgba{255, 0, 51, 255}) == "srgb <1,0,0.2>");
  CHECK(ToSdl(SRgba{255, 0, 51, 204}) == "srgbt <1,0,0.2,0.2>");
  CHECK(ToSdlFilter(SRgba{255, 0, 51, 204}, 0.9) == "srgbf <1,0,0.2,0.9>");
}

TEST_CASE("sdl text: a matrix lists the images of the axes, then the origin", "[povray]") {
  // row i is what makes up coordinate i in the world
  const std::array<std::array<float, 4>, 3> rows = {
      {{1.0f, 2.0f, 3.0f, 4.0f}, {5.0f, 6.0f, 7.0f, 8.0f}, {9.0f, 10.0f, 11.0f, 12.0f}}};
  CHECK(ToSdl(rows) == "matrix <1,5,9,2,6,10,3,7,11,4,8,12>");
}

TEST_CASE("sdl text: no text ends a string literal", "[povray]") {
  CHECK(ToSdlString("plain") == "\"plain\"");
  CHECK(ToSdlString("a\"} sphere { 0, 1 }") == "\"a\\\"} sphere { 0, 1 }\"");
  CHECK(ToSdlString("\\") == "\"\\\\\"");
  CHECK(ToSdlString("\\\"") == "\"\\\\\\\"\"");
  CHECK(ToSdlString("one\ntwo\x01") == "\"one two \"");
  CHECK(ToSdlString("\xC3\xA4") == "\"\xC3\xA4\"");
  CHECK(ToSdlString("\xFFx\xC3") == "\"?x?\"");
}

TEST_CASE("sdl text: finds numbers that are not finite", "[povray]") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(IsFinite(std::array<float, 3>{0.0f, 1.0f, -1.0f}));
  CHECK_FALSE(IsFinite(std::array<float, 3>{0.0f, nan, 0.0f}));
  CHECK_FALSE(IsFinite(std::array<float, 3>{0.0f, std::numeric_limits<float>::infinity(), 0.0f}));
}

}  // namespace sdl_text_test
