#include <argos3/core/utility/text/utf8.h>

#include <catch2/catch.hpp>

namespace utf8_test {

using namespace argos;

TEST_CASE("utf8: a character has the bytes that its first byte says", "[core][text]") {
  CHECK(CountUtf8Bytes("a") == 1);
  CHECK(CountUtf8Bytes("\x7F") == 1);
  CHECK(CountUtf8Bytes("\xC3\xA4x") == 2);
  CHECK(CountUtf8Bytes("\xE2\x82\xAC") == 3);
  CHECK(CountUtf8Bytes("\xF0\x9F\x98\x80") == 4);
}

// Source: RFC 3629, section 4
TEST_CASE("utf8: what is no character has no bytes", "[core][text]") {
  for (const char* const text :
       {"", "\x80", "\xC0\x80", "\xC1\xBF", "\xC3", "\xC3x", "\xE2\x82", "\xE0\x80\x80",
        "\xED\xA0\x80", "\xF0\x80\x80\x80", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF"}) {
    CHECK(CountUtf8Bytes(text) == 0);
  }
}

TEST_CASE("utf8: a text is cut between characters", "[core][text]") {
  const std::string_view text = "a\xC3\xA4\xE2\x82\xACz";
  const std::size_t ends[] = {0, 1, 1, 3, 3, 3, 6, 7, 7};
  for (std::size_t bytes = 0; bytes < 9; ++bytes) {
    CHECK(CutUtf8(text, bytes) == text.substr(0, ends[bytes]));
  }
  CHECK(CutUtf8("", 3) == "");
  // bytes that begin no character have no end to wait for
  CHECK(CutUtf8("\x80\x80\x80", 2) == "");
}

}  // namespace utf8_test
