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

}  // namespace utf8_test
