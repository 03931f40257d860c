#include <argos3/core/utility/math/text_input.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <cctype>
#include <vector>

namespace argos {

namespace {

constexpr int kEndOfInput = std::istream::traits_type::eof();

int PeekOrEnd(std::istream& is) {
  return is.eof() ? kEndOfInput : is.peek();
}

int PeekPastBlanks(std::istream& is) {
  int next = PeekOrEnd(is);
  while (next != kEndOfInput && std::isspace(next) != 0) {
    is.get();
    next = PeekOrEnd(is);
  }
  return next;
}

}  // namespace

std::string QuoteInput(std::istream& is, std::streampos start) {
  if (start == std::streampos(-1)) {
    return "The text";
  }
  is.clear();
  is.seekg(start);
  std::string line;
  std::getline(is, line);
  return "\"" + line + "\"";
}

void ReadNumbers(std::istream& is, Real* buffer, UInt32 count, const std::string& what) {
  if (IsLooseParsing(is)) {
    ParseValues(is, count, buffer, ',');
    return;
  }
  const std::streampos start = is.tellg();
  const auto reject = [&](const std::string& reason) {
    THROW_ARGOSEXCEPTION(QuoteInput(is, start)
                         << " is not " << what << ": " << reason << "; expected " << count
                         << " numbers separated by ','.");
  };

  std::vector<Real> numbers(count);
  for (UInt32 i = 0; i < count; ++i) {
    if (i > 0) {
      if (PeekPastBlanks(is) == kEndOfInput) {
        reject("it has only " + std::to_string(i) + " fields");
      }
      if (is.peek() != ',') {
        reject("',' is missing after field " + std::to_string(i));
      }
      is.get();
    }
    if (!(is >> std::ws >> numbers[i])) {
      reject("field " + std::to_string(i + 1) + " is not a number");
    }
  }

  // the numbers must be followed by the end or a blank
  const int next = PeekOrEnd(is);
  if (next != kEndOfInput && next != ',' && std::isspace(next) == 0) {
    reject("field " + std::to_string(count) + " is not a number");
  }
  if (PeekPastBlanks(is) == ',') {
    reject("it has more fields");
  }
  for (UInt32 i = 0; i < count; ++i) {
    buffer[i] = numbers[i];
  }
}

}  // namespace argos
