#include <argos3/plugins/simulator/visualizations/offscreen/glyph_atlas.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace glyph_atlas_test {

using namespace argos;

namespace {

SLabel MakeLabel(const std::string& text, const STextStyle& style = STextStyle()) {
  SLabel label;
  label.Text = text;
  label.Style = style;
  return label;
}

std::vector<SGlyphInstance> Set(CGlyphAtlas& atlas, const SLabel& label, double x = 100.0,
                                double y = 50.0, double scale = 1.0) {
  std::vector<SGlyphInstance> instances;
  atlas.Append(label, x, y, scale, instances);
  return instances;
}

float RightEnd(const std::vector<SGlyphInstance>& instances) {
  float end = -1e9f;
  for (const SGlyphInstance& instance : instances) {
    end = std::max(end, instance.Area[0] + instance.Area[2]);
  }
  return end;
}

}  // namespace

TEST_CASE("glyph atlas: a text is its contours, then its letters, from left to right",
          "[visualizations][offscreen][text]") {
  CGlyphAtlas atlas;
  const std::vector<SGlyphInstance> instances = Set(atlas, MakeLabel("a b"));
  // the blank has no picture
  REQUIRE(instances.size() == 4);
  CHECK(instances[0].Color.R == 255);
  CHECK(instances[2].Color.R == 0);
  CHECK(instances[2].Area[0] < instances[3].Area[0]);
  // the letter stands on the base line, within the contour
  CHECK(instances[2].Area[1] + instances[2].Area[3] <= 51.0f);
  CHECK(instances[2].Area[1] > 50.0f - 16.0f);
  CHECK(instances[0].Area[0] < instances[2].Area[0]);
  CHECK(instances[0].Area[2] > instances[2].Area[2]);
}

TEST_CASE("glyph atlas: letters that are drawn again are not stored again",
          "[visualizations][offscreen][text]") {
  CGlyphAtlas atlas;
  Set(atlas, MakeLabel("fb10"));
  const std::uint64_t version = atlas.GetVersion();
  Set(atlas, MakeLabel("01fb"));
  CHECK(atlas.GetVersion() == version);
  Set(atlas, MakeLabel("2"));
  CHECK(atlas.GetVersion() != version);
}

TEST_CASE("glyph atlas: texts are aligned at their position", "[visualizations][offscreen][text]") {
  CGlyphAtlas atlas;
  STextStyle style;
  const float left = Set(atlas, MakeLabel("swarm", style))[5].Area[0];
  const float width = RightEnd(Set(atlas, MakeLabel("swarm", style))) - left;
  style.Alignment = STextStyle::EAlignment::Center;
  const float centered = Set(atlas, MakeLabel("swarm", style))[5].Area[0];
  style.Alignment = STextStyle::EAlignment::Right;
  const float right = Set(atlas, MakeLabel("swarm", style))[5].Area[0];
  // letters begin at whole pixels, and a letter's picture is narrower than its room
  CHECK(std::abs(left - 100.0f) <= 2.0f);
  CHECK(std::abs(left - centered - 0.5f * width) <= 3.0f);
  CHECK(std::abs(left - right - width) <= 4.0f);
}

TEST_CASE("glyph atlas: size, weight and family change the letters",
          "[visualizations][offscreen][text]") {
  CGlyphAtlas atlas;
  const float plain = RightEnd(Set(atlas, MakeLabel("illiw")));
  STextStyle large;
  large.Size = 32.0;
  // twice the size, twice the width, up to rounding to pixels
  CHECK(std::abs(RightEnd(Set(atlas, MakeLabel("illiw", large))) - 100.0f -
                 2.0f * (plain - 100.0f)) < 6.0f);
  STextStyle bold;
  bold.IsBold = true;
  CHECK(RightEnd(Set(atlas, MakeLabel("illiw", bold))) > plain);
  // of a monospaced font all letters are equally wide
  STextStyle mono;
  mono.Family = "Courier New";
  const std::vector<SGlyphInstance> narrow = Set(atlas, MakeLabel("iii|", mono));
  const std::vector<SGlyphInstance> wide = Set(atlas, MakeLabel("www|", mono));
  CHECK(narrow.back().Area[0] == wide.back().Area[0]);
  CHECK(Set(atlas, MakeLabel("iii|")).back().Area[0] <
        Set(atlas, MakeLabel("www|")).back().Area[0]);
}

TEST_CASE("glyph atlas: names of families are those with, without serifs, and of typewriters",
          "[visualizations][offscreen][text]") {
  CGlyphAtlas atlas;
  const auto widthOf = [&atlas](const std::string& family) {
    STextStyle style;
    style.Family = family;
    return RightEnd(Set(atlas, MakeLabel("illiw", style)));
  };
  const float sans = widthOf("");
  const float serif = widthOf("DejaVu Serif");
  const float mono = widthOf("DejaVu Sans Mono");
  CHECK((sans != serif && sans != mono && serif != mono));
  for (const char* const family : {"Helvetica", "Sans Serif", "Arial"}) {
    CHECK(widthOf(family) == sans);
  }
  for (const char* const family : {"Times", "Times New Roman", "CMU roman", "serif"}) {
    CHECK(widthOf(family) == serif);
  }
  for (const char* const family : {"courier", "Consolas", "Lucida Typewriter"}) {
    CHECK(widthOf(family) == mono);
  }
}

TEST_CASE("glyph atlas: line feeds begin a line below, malformed UTF-8 is replaced",
          "[visualizations][offscreen][text]") {
  CGlyphAtlas atlas;
  const std::vector<SGlyphInstance> lines = Set(atlas, MakeLabel("a\na"));
  REQUIRE(lines.size() == 4);
  CHECK(lines[2].Area[0] == lines[3].Area[0]);
  CHECK(lines[3].Area[1] - lines[2].Area[1] > 16.0f);
  // one character in two bytes
  CHECK(Set(atlas, MakeLabel("\xC3\xBC")).size() == 2);
  CHECK(Set(atlas, MakeLabel("\xFF\xC3")).size() == 4);
  // a byte that begins no character, one beyond U+10FFFF, and a character that is cut by a letter
  const float replacement = RightEnd(Set(atlas, MakeLabel("\xEF\xBF\xBD")));
  CHECK(RightEnd(Set(atlas, MakeLabel("\x80"))) == replacement);
  CHECK(RightEnd(Set(atlas, MakeLabel("\xF5"))) == replacement);
  CHECK(RightEnd(Set(atlas, MakeLabel("\xC3w"))) ==
        RightEnd(Set(atlas, MakeLabel("\xEF\xBF\xBDw"))));
  CHECK(Set(atlas, MakeLabel("a\r\na")).size() == 4);
  CHECK(Set(atlas, MakeLabel("")).empty());
}

TEST_CASE("glyph atlas: bright text has a dark contour", "[visualizations][offscreen][text]") {
  CGlyphAtlas atlas;
  SLabel label = MakeLabel("x");
  label.Color = {255, 255, 0, 255};
  CHECK(Set(atlas, label)[0].Color.R < 50);
  label.Color = {0, 0, 160, 255};
  CHECK(Set(atlas, label)[0].Color.R > 200);
}

TEST_CASE("glyph atlas: sizes beyond all use are those of the smallest and the largest letters",
          "[visualizations][offscreen][text]") {
  CGlyphAtlas atlas;
  const auto areaOf = [&atlas](double size) {
    STextStyle style;
    style.Size = size;
    const std::vector<SGlyphInstance> instances = Set(atlas, MakeLabel("M", style));
    REQUIRE(instances.size() == 2);
    return instances[1].Area;
  };
  CHECK(areaOf(0.6) == areaOf(1.4));
  CHECK(areaOf(0.1) == areaOf(0.4));
  CHECK(areaOf(0.1)[2] > 0.0f);
  CHECK(areaOf(3000.0) == areaOf(2000.0));
  CHECK(areaOf(3000.0)[3] > 50.0f);
}

TEST_CASE("glyph atlas: characters of one to four bytes are one letter each",
          "[visualizations][offscreen][text]") {
  CGlyphAtlas atlas;
  // two instances for each letter: its contour and itself
  CHECK(Set(atlas, MakeLabel("A")).size() == 2);
  CHECK(Set(atlas, MakeLabel("\u00e4x")).size() == 4);
  CHECK(Set(atlas, MakeLabel("\u20acx")).size() == 4);
  CHECK(Set(atlas, MakeLabel("\U0001d11ex")).size() == 4);
}

TEST_CASE("glyph atlas: a contour covers its letter and the pixels around it",
          "[visualizations][offscreen][text]") {
  CGlyphAtlas atlas;
  STextStyle style;
  style.Size = GENERATE(6.0, 16.0, 40.0);
  CAPTURE(style.Size);
  const std::vector<SGlyphInstance> instances = Set(atlas, MakeLabel("g", style));
  REQUIRE(instances.size() == 2);
  const SGlyphInstance& contour = instances[0];
  const SGlyphInstance& letter = instances[1];
  const auto pixelOf = [&atlas](const SGlyphInstance& instance, int x, int y) {
    const int column = static_cast<int>(instance.Texel[0]) + x;
    const int row = static_cast<int>(instance.Texel[1]) + y;
    return int(atlas.GetPixels()[static_cast<std::size_t>(row * atlas.GetWidth() + column)]);
  };
  const int width = static_cast<int>(letter.Area[2]);
  const int height = static_cast<int>(letter.Area[3]);
  const int margin = (static_cast<int>(contour.Area[2]) - width) / 2;
  REQUIRE(margin >= 1);
  CHECK(contour.Area[0] == letter.Area[0] - static_cast<float>(margin));
  CHECK(contour.Area[1] == letter.Area[1] - static_cast<float>(margin));
  int darkest = 0;
  bool isCovered = true;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      darkest = std::max(darkest, pixelOf(letter, x, y));
      isCovered = isCovered && pixelOf(contour, x + margin, y + margin) >= pixelOf(letter, x, y);
    }
  }
  CHECK(isCovered);
  CHECK(darkest > 150);
  // beside the outermost pixels of the letter
  int darkestBeside = 0;
  for (int y = 0; y < height; ++y) {
    darkestBeside = std::max(darkestBeside, pixelOf(contour, margin - 1, y + margin));
  }
  CHECK(darkestBeside > 20);
}

TEST_CASE("glyph atlas: letters of all sizes have places of their own",
          "[visualizations][offscreen][text]") {
  CGlyphAtlas atlas;
  std::vector<SGlyphInstance> all;
  for (const double size : {40.0, 9.0, 120.0, 23.0, 200.0, 12.0}) {
    STextStyle style;
    style.Size = size;
    for (const SGlyphInstance& instance : Set(atlas, MakeLabel("aW.jM|", style))) {
      all.push_back(instance);
    }
  }
  REQUIRE(all.size() == 6 * 12);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& [texel, area] = std::pair(all[i].Texel, all[i].Area);
    CHECK(texel[0] + area[2] <= static_cast<float>(atlas.GetWidth()));
    CHECK(texel[1] + area[3] <= static_cast<float>(atlas.GetHeight()));
    for (std::size_t k = 0; k < i; ++k) {
      const SGlyphInstance& other = all[k];
      const bool areApart =
          texel[0] >= other.Texel[0] + other.Area[2] || other.Texel[0] >= texel[0] + area[2] ||
          texel[1] >= other.Texel[1] + other.Area[3] || other.Texel[1] >= texel[1] + area[3];
      CHECK(areApart);
    }
  }
}

TEST_CASE(
    "glyph atlas: more letters than the atlas has room for are an error, up to the next picture",
    "[visualizations][offscreen][text]") {
  CGlyphAtlas atlas;
  const auto fill = [&atlas] {
    for (int size = 200; size > 100; --size) {
      STextStyle style;
      style.Size = size;
      Set(atlas, MakeLabel("ABCDEFGHKMNOPQRSTUVWXYZ", style));
    }
  };
  CHECK_THROWS_WITH(fill(), Catch::Contains("too many letters"));
  CHECK(atlas.GetHeight() <= 8192);
  atlas.BeginPicture();
  CHECK(Set(atlas, MakeLabel("a")).size() == 2);
}

}  // namespace glyph_atlas_test
