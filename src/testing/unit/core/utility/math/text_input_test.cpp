#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/core/utility/math/text_input.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <catch2/catch.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <locale>
#include <sstream>

namespace text_input_test {

using namespace argos;

namespace {

// what reading a vector from a text does to the vector and the stream
struct SOutcome {
  std::string Error;
  std::array<UInt64, 3> Bits{};
  bool IsGood = false;
  bool IsAtEnd = false;
  std::string Rest;  // of the text
};

// strict: lists in plain form are read without the stream's conversion
SOutcome Read(const std::string& text, bool strict) {
  std::istringstream in(text);
  SetStrictParsing(in, strict);
  SOutcome outcome;
  std::array<Real, 3> numbers = {7.0, 8.0, 9.0};
  try {
    ReadNumbers(in, numbers.data(), 3, "a list");
    outcome.IsGood = in.good();
    outcome.IsAtEnd = in.eof();
    in.clear();
    std::getline(in, outcome.Rest, '\0');
  } catch (const CARGoSException& error) {
    outcome.Error = error.what();
  }
  std::memcpy(outcome.Bits.data(), numbers.data(), sizeof numbers);
  return outcome;
}

}  // namespace

TEST_CASE("text input: lists in plain form are read as by a stream", "[core][math]") {
  const std::string text = GENERATE(
      // in plain form
      as<std::string>(), "1,2,3", "-0.5,1e-3,2E2", "1.,2.,3.", "0,-0,0.0", "1e+5,2e-05,3.25e0",
      "007,08,9", "0.1,0.2,0.30000000000000004",
      "5e-324,1.7976931348623157e308,2.2250738585072014e-308", "123456789012345678901234567890,0,0",
      // valid, in another form
      " 1,2,3", "1 ,\t2,\n3", "1,2,3 ", "+1,2,3", ".5,-.5,1", "1e-400,0,0", "1,2,3 4,5,6",
      // not valid
      "", "1", "1,2", "1,2,", "1,2,3,4", "1,2,3x", "1,,3", ",1,2,3", "1;2;3", "inf,0,0", "-nan,0,0",
      "0x10,0,0", "1e400,0,0", "1e,2,3", "--1,2,3", "-,2,3", "1,2,3e", "1 2 3");
  CAPTURE(text);
  const SOutcome plain = Read(text, true);
  const SOutcome byStream = Read(text, false);
  CHECK(plain.Error == byStream.Error);
  CHECK(plain.Bits == byStream.Bits);
  CHECK(plain.IsGood == byStream.IsGood);
  CHECK(plain.IsAtEnd == byStream.IsAtEnd);
  CHECK(plain.Rest == byStream.Rest);
}

TEST_CASE("text input: the shortest text of a number reads back as that number", "[core][math]") {
  CRandomStream random(1, "test", "text_input", "numbers");
  for (int i = 0; i < 2000; ++i) {
    const Real number = random.Uniform(-50.0, 50.0) * std::pow(10.0, random.Uniform(-9.0, 9.0));
    std::array<char, 32> digits{};
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number);
    REQUIRE(error == std::errc());
    const std::string text(digits.data(), end);
    const SOutcome outcome = Read(text + ",1," + text, true);
    REQUIRE(outcome.Error.empty());
    UInt64 bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    REQUIRE(outcome.Bits[0] == bits);
    REQUIRE(outcome.Bits[2] == bits);
  }
}

TEST_CASE("text input: a stream with another decimal point is converted by its locale",
          "[core][math]") {
  struct SComma : std::numpunct<char> {
    char do_decimal_point() const override { return ';'; }
  };
  std::istringstream in("1;5,2,3");
  in.imbue(std::locale(std::locale::classic(), new SComma));
  SetStrictParsing(in, true);
  CVector3 vector;
  in >> vector;
  CHECK(vector == CVector3(1.5, 2.0, 3.0));
}

}  // namespace text_input_test
