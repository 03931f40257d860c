// Manuals of plug-ins for programs and for terminals.

#include <argos3/program/catalogue/manual.h>
#include <argos3/program/catalogue/text_layout.h>
#include <argos3/support/json_quoting.h>

#include <catch2/catch.hpp>

namespace manual_test {

using namespace argos;

namespace {

constexpr const char* kManual = R"(Prose, <b> and so on.

REQUIRED XML

  <controllers>
    <my_controller id="c1" />
  </controllers>

with dots:

  <arena ...>
  </arena>

or

    <floor id="a" />
    <floor id="b" />

  size, width  m, default 1: of the
               whole.
  cap@size     of the cap only.
  , @colour    of the cap, too.
  not a row
)";

}  // namespace

TEST_CASE("manuals: examples are their well-formed XML", "[core][catalogue]") {
  const CManual manual(kManual);
  REQUIRE(manual.GetExamples().size() == 3);
  CHECK(manual.GetExamples()[0].Value() == "controllers");
  CHECK(manual.GetExamples()[1].Value() == "floor");
  CHECK(manual.GetExamples()[2].GetAttribute("id") == "b");
}

TEST_CASE("manuals: rows of tables describe attributes", "[core][catalogue]") {
  const CManual manual(kManual);
  CHECK(manual.TextOf("body", "size").Text == "m, default 1: of the whole.");
  CHECK(manual.TextOf("body", "width").Text == "m, default 1: of the whole.");
  CHECK(manual.TextOf("cap", "size").Text == "of the cap only.");
  CHECK(manual.TextOf("body", "colour").Text.empty());
}

TEST_CASE("manuals: rows of an element describe the attributes that they mention",
          "[core][catalogue]") {
  const CManual manual(
      "  <top><ring radius=\"1\" /></top>\n\n"
      "  drive       how it moves:\n  drive       two wheels; speed: m/s.\n"
      "  ring@shape  \"disc\" (radius).\n  top/lid     colour: black.\n  depth       m\n");
  CHECK(manual.TextOf("drive", "speed").Text == "two wheels; speed: m/s.");
  CHECK(manual.TextOf("ring", "radius").Text == "\"disc\" (radius).");
  CHECK(manual.TextOf("lid", "colour").Text == "colour: black.");
  CHECK(manual.TextOf("ring", "speed").Text.empty());
  CHECK(manual.TextOf("ring", "depth").Text == "m");
  CHECK(manual.TextOfTag("ring", "depth").Text.empty());
  CHECK(manual.HasExampleOf("ring"));
  CHECK_FALSE(manual.HasExampleOf("drive"));
}

TEST_CASE("manuals: lines that are indented by less than two columns are no rows",
          "[core][catalogue]") {
  const CManual manual(
      "ATTRIBUTES\n  mass  kg, > 0\nAnd then\n radius  of nothing\n  depth  m\nEnd.\n");
  CHECK(manual.TextOf("body", "mass").Text == "kg, > 0");
  CHECK(manual.TextOf("body", "radius").Text.empty());
  CHECK(manual.TextOf("body", "depth").Text == "m");
}

TEST_CASE("manuals: rows state units and defaults", "[core][catalogue]") {
  const auto read = [](const std::string& row) {
    return CManual("  name  " + row + '\n').TextOf("tag", "name");
  };
  const struct {
    const char* Row;
    const char* Unit;
    const char* Default;
  } rows[] = {{"m, >= 0, default 0.05: largest distance.", "m", "0.05"},
              {"\"x,y,z\", m, default \"0,0,0\": of the centre.", "m", "0,0,0"},
              {"kg, > 0, required.", "kg", ""},
              {"degrees/s, > 0; without it, angles change at once.", "degrees/s", ""},
              {"N m s or N s, >= 0, required", "N m s or N s", ""},
              {"m/s per N, in [1e-10,1], default 1e-5: how soft.", "m/s per N", "1e-5"},
              {"WxH, pixels, each from 16 to 16384. Default: 1280x960", "", "1280x960"},
              {"\"true\" (default) or \"false\": if true.", "", "true"},
              {"true or false, the default: whether.", "", "false"},
              {"text, required: the id of a medium.", "", ""},
              {"N, >= 0, default 1.49.", "N", "1.49"}};
  for (const auto& row : rows) {
    CAPTURE(row.Row);
    CHECK(read(row.Row).Unit == row.Unit);
    CHECK(read(row.Row).Default == row.Default);
    CHECK(read(row.Row).Text == row.Row);
  }
}

TEST_CASE("text layout: paragraphs and tables have 80 columns, XML stays", "[core][catalogue]") {
  const std::string words(120, 'x');
  const std::string xml = "  <a b=\"" + words + "\" />\n";
  CHECK(WrappedManual(xml) == xml);
  CHECK(WrappedManual("short\nlines\n") == "short\nlines\n");
  const std::string ten = "0123456789";
  std::string line = ten;
  for (int i = 0; i < 8; ++i) {
    line += ' ' + ten;
  }
  // seven words of ten letters and six blanks: 76 columns
  CHECK(WrappedManual(line + '\n') == line.substr(0, 76) + '\n' + line.substr(77) + '\n');
  // the texts of a table stay in their column
  CHECK(WrappedManual("  name  " + line + '\n') ==
        "  name  " + line.substr(0, 65) + "\n        " + line.substr(66) + '\n');
}

TEST_CASE("JSON: texts are escaped", "[core][catalogue]") {
  CHECK(QuoteForJson("\"\\\n\t\x01 \xc3\xa4 \xff") ==
        "\"\\\"\\\\\\n\\u0009\\u0001 \xc3\xa4 \\ufffd\"");
}

}  // namespace manual_test
