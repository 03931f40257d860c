#include <argos3/core/utility/string_utilities.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/support/shell_quoting.h>
#include <argos3/testing/support/invariants.h>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

namespace string_utilities_test {

using namespace argos;
using Catch::Contains;

namespace my_argos {
struct SThing {};
}  // namespace my_argos

namespace lab::argos {
struct SThing {};
}  // namespace lab::argos

namespace {

std::vector<std::string> Tokens(const std::string& text, const std::string& delimiters) {
  std::vector<std::string> tokens;
  Tokenize(text, tokens, delimiters);
  return tokens;
}

void ThrowUnlessPositive(int number) {
  if (number > 0) {
    return;
  } else
    THROW_ARGOSEXCEPTION("number " << number);
}

}  // namespace

// exceptions

TEST_CASE("exception: what() begins with the marker of an error", "[core][exception]") {
  CHECK(std::string(CARGoSException("broken").what()) == "[FATAL] broken");
}

TEST_CASE("exception: a nested one follows on the next line", "[core][exception]") {
  std::unique_ptr<CARGoSException> outer;
  {
    CARGoSException inner("inner");
    outer = std::make_unique<CARGoSException>("outer", &inner);
  }
  // the text was copied before the inner exception was destroyed
  CHECK(std::string(outer->what()) == "[FATAL] outer\n[FATAL] inner");
}

TEST_CASE("exception: macros take stream expressions, with and without semicolon",
          "[core][exception]") {
  CHECK_THROWS_WITH(ThrowUnlessPositive(-3), "[FATAL] number -3");
  CHECK_NOTHROW(ThrowUnlessPositive(1));
  const auto nest = [] {
    try {
      throw std::runtime_error("why");
    } catch (std::exception& ex) {
      THROW_ARGOSEXCEPTION_NESTED("what " << 1, ex)
    }
  };
  CHECK_THROWS_WITH(nest(), "[FATAL] what 1\n[FATAL] why");
}

TEST_CASE("exception: assertions throw in builds that check invariants", "[core][exception]") {
  const auto check = [](int number) {
    ARGOS_ASSERT(number > 0, "number is " << number)
    static_cast<void>(number);
  };
  CHECK_NOTHROW(check(1));
  if constexpr (kChecksInvariants) {
    CHECK_THROWS_WITH(check(0), "[FATAL] number is 0");
  } else {
    CHECK_NOTHROW(check(0));
  }
}

// values and texts

TEST_CASE("strings: values become texts and back", "[core][strings]") {
  CHECK(ToString(true) == "true");
  CHECK(ToString(1.5) == "1.5");
  CHECK(ToString(UInt8(65)) == "65");
  CHECK(ToString("text") == "text");
  CHECK(FromString<bool>("true"));
  CHECK_FALSE(FromString<bool>("false"));
  CHECK(FromString<int>("42 and more") == 42);
  CHECK(FromString<double>("no number") == 0.0);
}

TEST_CASE("numbers: the whole text must be the number", "[core][strings]") {
  double real = 7.0;
  CHECK(ParseNumber(" 1.5e3 ", real) == ENumberParsing::Ok);
  CHECK(real == 1500.0);
  CHECK(ParseNumber("+2", real) == ENumberParsing::Ok);
  CHECK(real == 2.0);
  CHECK(ParseNumber("-.5", real) == ENumberParsing::Ok);
  CHECK(real == -0.5);
  CHECK(ParseNumber("3 m", real) == ENumberParsing::TrailingText);
  CHECK(ParseNumber("3,0", real) == ENumberParsing::TrailingText);
  CHECK(ParseNumber("0x10", real) == ENumberParsing::TrailingText);
  CHECK(ParseNumber("1e999", real) == ENumberParsing::OutOfRange);
  for (const char* text : {"", "  ", "x", "inf", "nan", "-inf", "+-1", "--1", "+", "-", "."}) {
    CAPTURE(text);
    CHECK(ParseNumber(text, real) == ENumberParsing::NotANumber);
  }
  // on failure the value is unchanged
  CHECK(real == -0.5);
}

TEST_CASE("numbers: fractions and values out of range are refused for integers",
          "[core][strings]") {
  UInt32 number = 7;
  CHECK(ParseNumber("10.5", number) == ENumberParsing::NotWhole);
  CHECK(ParseNumber("1e-1", number) == ENumberParsing::NotWhole);
  CHECK(ParseNumber("1.0.0", number) == ENumberParsing::TrailingText);
  CHECK(ParseNumber("e", number) == ENumberParsing::NotANumber);
  CHECK(ParseNumber("-1", number) == ENumberParsing::OutOfRange);
  CHECK(ParseNumber("4294967296", number) == ENumberParsing::OutOfRange);
  CHECK(ParseNumber("", number) == ENumberParsing::NotANumber);
  CHECK(number == 7);
  CHECK(ParseNumber("-0", number) == ENumberParsing::Ok);
  CHECK(number == 0);
  CHECK(ParseNumber(" 4294967295", number) == ENumberParsing::Ok);
  CHECK(number == 4294967295U);
  SInt8 small = 0;
  CHECK(ParseNumber("-128", small) == ENumberParsing::Ok);
  CHECK(small == -128);
  CHECK(ParseNumber("128", small) == ENumberParsing::OutOfRange);
}

TEST_CASE("numbers: whole real numbers are integers", "[core][strings]") {
  UInt32 number = 0;
  CHECK(ParseNumber("25.0", number) == ENumberParsing::Ok);
  CHECK(number == 25);
  CHECK(ParseNumber(" +1e3 ", number) == ENumberParsing::Ok);
  CHECK(number == 1000);
  CHECK(ParseNumber("1.25E2", number) == ENumberParsing::Ok);
  CHECK(number == 125);
  CHECK(ParseNumber("-0.0", number) == ENumberParsing::Ok);
  CHECK(number == 0);
  CHECK(ParseNumber("4294967295.0", number) == ENumberParsing::Ok);
  CHECK(number == 4294967295U);
  CHECK(ParseNumber("4294967296.0", number) == ENumberParsing::OutOfRange);
  CHECK(ParseNumber("-1.0", number) == ENumberParsing::OutOfRange);
  SInt8 small = 0;
  CHECK(ParseNumber("-128.0", small) == ENumberParsing::Ok);
  CHECK(small == -128);
  CHECK(ParseNumber("-129.0", small) == ENumberParsing::OutOfRange);
  CHECK(ParseNumber("128.", small) == ENumberParsing::OutOfRange);
  UInt64 large = 0;
  CHECK(ParseNumber("1.8446744073709551616e19", large) == ENumberParsing::OutOfRange);
  CHECK(ParseNumber("9007199254740993.0", large) == ENumberParsing::Ok);
  CHECK(large == 9007199254740993U);
  UInt32 size[3];
  ParseValues<UInt32>("2,2.0,1e0", 3, size, ',');
  CHECK(size[2] == 1);
}

template <typename T>
void CheckLimits() {
  T value = T();
  CHECK(ParseNumber(std::to_string(std::numeric_limits<T>::max()), value) == ENumberParsing::Ok);
  CHECK(value == std::numeric_limits<T>::max());
  CHECK(ParseNumber(std::to_string(std::numeric_limits<T>::min()), value) == ENumberParsing::Ok);
  CHECK(value == std::numeric_limits<T>::min());
}

TEST_CASE("numbers: every integer type reads its limits", "[core][strings]") {
  CheckLimits<signed char>();
  CheckLimits<unsigned char>();
  CheckLimits<short>();
  CheckLimits<unsigned short>();
  CheckLimits<int>();
  CheckLimits<unsigned int>();
  CheckLimits<long>();
  CheckLimits<unsigned long>();
  CheckLimits<long long>();
  CheckLimits<unsigned long long>();
  float narrow = 0.0f;
  CHECK(ParseNumber("0.5", narrow) == ENumberParsing::Ok);
  CHECK(narrow == 0.5f);
  long double wide = 0.0L;
  CHECK(ParseNumber("0.25", wide) == ENumberParsing::Ok);
  CHECK(wide == 0.25L);
}

TEST_CASE("values: lists are read field by field", "[core][strings]") {
  double reals[3] = {9, 9, 9};
  ParseValues<double>("1, 2.5,-3", 3, reals, ',');
  CHECK(reals[0] == 1.0);
  CHECK(reals[1] == 2.5);
  CHECK(reals[2] == -3.0);
  // a field that is not a number gives 0, and further fields are ignored
  ParseValues<double>("x,2,3,4", 3, reals, ',');
  CHECK(reals[0] == 0.0);
  CHECK(reals[2] == 3.0);
  std::istringstream stream("7:8");
  UInt32 integers[2];
  ParseValues<UInt32>(stream, 2, integers, ':');
  CHECK(integers[1] == 8);
  CHECK_FALSE(stream.fail());
  ParseValues<UInt32>("1\n2", 2, integers);
  CHECK(integers[0] == 1);
}

TEST_CASE("values: too few fields are an error", "[core][strings]") {
  double reals[3];
  CHECK_THROWS_WITH(ParseValues<double>("1,2", 3, reals, ','),
                    Contains("found 2 values, expected 3 values separated by ','"));
  CHECK_THROWS_WITH(ParseValues<double>("", 1, reals),
                    Contains("found 0 values, expected 1 value separated by line breaks"));
}

TEST_CASE("values: a strict stream refuses malformed values and trailing text", "[core][strings]") {
  double reals[2];
  const auto parse = [&reals](const std::string& text) {
    std::istringstream stream(text);
    SetStrictParsing(stream, true);
    REQUIRE(IsStrictParsing(stream));
    ParseValues<double>(stream, 2, reals, ',');
  };
  CHECK_NOTHROW(parse(" 1 , 2 "));
  CHECK_THROWS_WITH(parse("1,x"), Contains("value number 2 is \"x\", which is not a valid value"));
  CHECK_THROWS_WITH(parse("1,2 m"), Contains("value number 2 is \"2 m\""));
  CHECK_THROWS_WITH(parse("1,2,3"), Contains("found more than the expected 2 values"));
  CHECK_THROWS_WITH(parse("1,2,"), Contains("found more than the expected 2 values"));
  CHECK_THROWS_WITH(parse("1"), Contains("found 1 value, expected 2 values"));
  std::istringstream words("a b,c");
  SetStrictParsing(words, true);
  std::string word[2];
  CHECK_THROWS_WITH(ParseValues<std::string>(words, 2, word, ','), Contains("\"a b\""));
}

TEST_CASE("strings: tokens are separated", "[core][strings]") {
  CHECK(Tokens("a b  c", " ") == std::vector<std::string>{"a", "b", "c"});
  CHECK(Tokens(",a;b,;c,", ",;") == std::vector<std::string>{"a", "b", "c"});
  CHECK(Tokens("", " ").empty());
  CHECK(Tokens("  ", " ").empty());
  std::vector<std::string> tokens = {"first"};
  Tokenize("second", tokens);
  CHECK(tokens == std::vector<std::string>{"first", "second"});
}

TEST_CASE("strings: letter case can be changed and text replaced", "[core][strings]") {
  CHECK(StringToUpperCase("aZ9-") == "AZ9-");
  CHECK(StringToLowerCase("aZ9-") == "az9-");
  std::string text = "a.b.c";
  Replace(text, ".", "..");
  CHECK(text == "a..b..c");
  Replace(text, "", "x");
  CHECK(text == "a..b..c");
  Replace(text, "a..", "");
  CHECK(text == "b..c");
}

TEST_CASE("strings: patterns are POSIX extended and match any part of a text", "[core][strings]") {
  CHECK(MatchPattern("foot-bot_12", "[0-9]+"));
  CHECK(MatchPattern("foot-bot_12", "^foot-(bot|car)"));
  CHECK_FALSE(MatchPattern("foot-bot_12", "^bot"));
  CHECK_FALSE(MatchPattern("anything", "("));
}

TEST_CASE("strings: environment variables are expanded", "[core][strings]") {
  setenv("ARGOS_TEST_VARIABLE", "value", 1);
  unsetenv("ARGOS_TEST_UNSET");
  std::string text = "$ARGOS_TEST_VARIABLE/x-$ARGOS_TEST_UNSET.$";
  CHECK(&ExpandEnvVariables(text) == &text);
  CHECK(text == "value/x-.$");
  std::string plain = "cost 5$ or $5";
  CHECK(ExpandEnvVariables(plain) == "cost 5$ or $5");
}

TEST_CASE("strings: type names are readable", "[core][strings]") {
  CHECK(DemangledName(typeid(int)) == "int");
  CHECK(DemangledName(typeid(CARGoSException)) == "CARGoSException");
  // also within names, but not the end of another name
  CHECK_THAT(DemangledName(typeid(std::vector<CARGoSException>)),
             Catch::StartsWith("std::vector<CARGoSException, "));
  CHECK_THAT(DemangledName(typeid(my_argos::SThing)), Catch::EndsWith("::my_argos::SThing"));
  CHECK_THAT(DemangledName(typeid(lab::argos::SThing)), Catch::EndsWith("::lab::argos::SThing"));
}

// nearest names

TEST_CASE("near names: misspellings are found, best first", "[core][strings]") {
  const std::vector<std::string> known = {"foot-bot", "e-puck", "box", "cylinder", "eye-bot"};
  CHECK(NearestNames("footbot", known) == "foot-bot");
  CHECK(NearestNames("FOOT-BOT", known) == "foot-bot");
  CHECK(NearestNames("bxo", known) == "box");
  CHECK(NearestNames("cilinder", known) == "cylinder");
  CHECK(NearestNames("quadrotor", known).empty());
  CHECK(NearestNames("", known).empty());
  CHECK(NearestNames("x", {}).empty());
}

TEST_CASE("near names: the list is limited and has no duplicates", "[core][strings]") {
  const std::vector<std::string> known = {"led4", "led2", "led1", "led3", "led1"};
  CHECK(NearestNames("led0", known) == "led1, led2, led3");
  CHECK(NearestNames("led0", known, 1) == "led1");
}

TEST_CASE("near names: a name is near to a part of it", "[core][strings]") {
  CHECK(NearestNames("proximity", {"footbot_proximity", "leds"}) == "footbot_proximity");
  CHECK(NearestNames("le", {"footbot_leds_x"}).empty());
}

TEST_CASE("near names: are listed at the end of an error message", "[core][strings]") {
  CHECK(DidYouMean("bos", {"box", "floor"}) == "; did you mean \"box\"?");
  CHECK(DidYouMean("led0", {"led1", "led2"}) == "; did you mean \"led1\" or \"led2\"?");
  CHECK(DidYouMean("quadrotor", {"box", "floor"}) == "; known: box, floor");
  CHECK(DidYouMean("quadrotor", {}) == "; known: none");
}

TEST_CASE("shell quoting: words with other signs than those of plain paths are quoted",
          "[core][strings]") {
  for (const std::string plain : {"abcxyzABCXYZ019", "_-+=:,./", "a/b-c_d.e"}) {
    CHECK(QuoteForShell(plain) == plain);
  }
  CHECK(QuoteForShell("") == "''");
  CHECK(QuoteForShell("it's") == "'it'\\''s'");
  for (const char c : std::string(" $`\"\\!*?[]{}()<>|&;~#\n\t%@^\xe4")) {
    const std::string word = "a" + std::string(1, c);
    CAPTURE(word);
    CHECK(QuoteForShell(word) == "'" + word + "'");
  }
}

}  // namespace string_utilities_test
