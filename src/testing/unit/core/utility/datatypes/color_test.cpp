#include <argos3/core/utility/datatypes/color.h>

#include <argos3/core/utility/string_utilities.h>

#include <catch2/catch.hpp>

#include <cstring>

namespace color_test {

using namespace argos;
using Catch::Contains;

namespace {

struct SExpectedColor {
  const char* Name;
  CColor Color;
  int Red;
  int Green;
  int Blue;
};

// tests that constants of other files are ready in static initialisers
const CColor kCopiedAtStart = CColor::PURPLE;

}  // namespace

TEST_CASE("color: default is opaque black", "[core][color]") {
  const CColor color;
  CHECK(color.GetRed() == 0);
  CHECK(color.GetGreen() == 0);
  CHECK(color.GetBlue() == 0);
  CHECK(color.GetAlpha() == 255);
  CHECK(color == CColor::BLACK);
}

TEST_CASE("color: constants are ready before main", "[core][color]") {
  CHECK(kCopiedAtStart == CColor(160, 32, 240));
}

TEST_CASE("color: named values are those of the file format", "[core][color]") {
  const std::vector<SExpectedColor> expected = {
      {"black", CColor::BLACK, 0, 0, 0},         {"white", CColor::WHITE, 255, 255, 255},
      {"red", CColor::RED, 255, 0, 0},           {"green", CColor::GREEN, 0, 255, 0},
      {"blue", CColor::BLUE, 0, 0, 255},         {"magenta", CColor::MAGENTA, 255, 0, 255},
      {"cyan", CColor::CYAN, 0, 255, 255},       {"yellow", CColor::YELLOW, 255, 255, 0},
      {"orange", CColor::ORANGE, 255, 140, 0},   {"brown", CColor::BROWN, 165, 42, 42},
      {"purple", CColor::PURPLE, 160, 32, 240},  {"gray10", CColor::GRAY10, 26, 26, 26},
      {"gray20", CColor::GRAY20, 51, 51, 51},    {"gray30", CColor::GRAY30, 77, 77, 77},
      {"gray40", CColor::GRAY40, 102, 102, 102}, {"gray50", CColor::GRAY50, 127, 127, 127},
      {"gray60", CColor::GRAY60, 153, 153, 153}, {"gray70", CColor::GRAY70, 179, 179, 179},
      {"gray80", CColor::GRAY80, 204, 204, 204}, {"gray90", CColor::GRAY90, 229, 229, 229},
  };
  for (const SExpectedColor& color : expected) {
    CAPTURE(color.Name);
    CHECK(color.Color.GetRed() == color.Red);
    CHECK(color.Color.GetGreen() == color.Green);
    CHECK(color.Color.GetBlue() == color.Blue);
    CHECK(color.Color.GetAlpha() == 255);
    CHECK(ToString(color.Color) == color.Name);
    CHECK(FromString<CColor>(color.Name) == color.Color);
  }
}

TEST_CASE("color: channels can be set one by one and together", "[core][color]") {
  CColor color;
  color.SetRed(1);
  color.SetGreen(2);
  color.SetBlue(3);
  color.SetAlpha(4);
  CHECK(color == CColor(1, 2, 3, 4));
  color.Set(5, 6, 7);
  CHECK(color == CColor(5, 6, 7, 255));
  CHECK(color != CColor(5, 6, 7, 254));
}

TEST_CASE("color: text with four numbers is read, blanks allowed", "[core][color]") {
  CColor color;
  color.Set("1,2,3,4");
  CHECK(color == CColor(1, 2, 3, 4));
  color.Set(" 10 , 20,30 ,255 ");
  CHECK(color == CColor(10, 20, 30, 255));
  std::istringstream stream("255, 0, 0, 128 green 7");
  CColor first;
  CColor second;
  int third = 0;
  stream >> first >> second >> third;
  CHECK(first == CColor(255, 0, 0, 128));
  CHECK(second == CColor::GREEN);
  CHECK(third == 7);
}

TEST_CASE("color: hexadecimal digits are read", "[core][color]") {
  CColor color;
  const auto [text, expected] =
      GENERATE(table<std::string, CColor>({{"#0a7Fff", CColor(10, 127, 255)},
                                           {"#0A7FFF80", CColor(10, 127, 255, 128)},
                                           {" #f08 ", CColor(255, 0, 136)}}));
  CAPTURE(text);
  color.Set(text);
  CHECK(color == expected);
}

TEST_CASE("color: a colour without a name prints its four numbers", "[core][color]") {
  CHECK(ToString(CColor(1, 2, 3)) == "1,2,3,255");
  // names are printed for opaque colours only
  CHECK(ToString(CColor(255, 0, 0, 254)) == "255,0,0,254");
}

TEST_CASE("color: malformed texts are refused and leave the colour unchanged", "[core][color]") {
  const std::string text = GENERATE("255,0,0", "256,0,0,255", "-1,0,0,255", "1,2,3,4,5", "a,b,c,d",
                                    "Red", "", "red green", "#", "#12", "#1234", "#gg0000",
                                    "#12345", "#1234567", "# 123456", "112233", "#-10000");
  CAPTURE(text);
  CColor color(1, 2, 3, 4);
  CHECK_THROWS_WITH(color.Set(text), Contains("is not a colour: expected a name, four integers"));
  CHECK(color == CColor(1, 2, 3, 4));
}

TEST_CASE("color: the error on an unknown name gives the nearest", "[core][color]") {
  CColor color;
  CHECK_THROWS_WITH(color.Set("puprle"), Contains("did you mean \"purple\"?"));
  CHECK_THROWS_WITH(color.Set("Red"), Contains("did you mean \"red\""));
}

TEST_CASE("color: gray scale is BT.601 luma", "[core][color]") {
  // one rounding of a product of about 100, half a unit in the last place: 1e-14
  CHECK_THAT(CColor(255, 0, 0).ToGrayScale(), Catch::WithinAbs(76.245, 1e-12));
  CHECK_THAT(CColor(0, 255, 0).ToGrayScale(), Catch::WithinAbs(149.685, 1e-12));
  CHECK_THAT(CColor(0, 0, 255).ToGrayScale(), Catch::WithinAbs(29.07, 1e-12));
  CHECK_THAT(CColor::WHITE.ToGrayScale(), Catch::WithinAbs(255.0, 1e-12));
}

TEST_CASE("color: blending weights by alpha and gives an opaque colour", "[core][color]") {
  const CColor under(0, 100, 200);
  CHECK(CColor(10, 20, 30, 255).Blend(under) == CColor(10, 20, 30));
  CHECK(CColor(10, 20, 30, 0).Blend(under) == CColor(0, 100, 200));
  // (255 * 51 + 0 * 204) / 255 = 51, (0 * 51 + 100 * 204) / 255 = 80, (0 + 200 * 204) / 255 = 160
  CHECK(CColor(255, 0, 0, 51).Blend(under) == CColor(51, 80, 160));
}

TEST_CASE("color: the integer form is R,G,B,A in memory order", "[core][color]") {
  CColor color(1, 2, 3, 4);
  const UInt32 value = color;
  UInt8 bytes[4];
  std::memcpy(bytes, &value, 4);
  CHECK(bytes[0] == 1);
  CHECK(bytes[1] == 2);
  CHECK(bytes[2] == 3);
  CHECK(bytes[3] == 4);
}

}  // namespace color_test
