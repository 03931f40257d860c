#include <argos3/core/utility/math/text_input.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <locale>
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

// Most lists are written "1,-2.5,3e-4": without blanks, and each number in its plain form. Reads
// the numbers of such a list in [begin, end), the whole text, as a stream does.
// @return false for a list of any other form.
bool ReadPlainList(const char* begin, const char* end, Real* numbers, UInt32 count) {
  const char* next = begin;
  for (UInt32 i = 0; i < count; ++i) {
    if (i > 0) {
      if (next == end || *next != ',') {
        return false;
      }
      ++next;
    }
    const char* const digits = next != end && *next == '-' ? next + 1 : next;
    // from_chars() takes "inf" and "nan" as well
    if (digits == end || (std::isdigit(static_cast<unsigned char>(*digits)) == 0)) {
      return false;
    }
    const auto [last, error] = std::from_chars(next, end, numbers[i]);
    if (error != std::errc()) {
      return false;
    }
    next = last;
  }
  return next == end;
}

// The same for a stream whose buffer contains the rest of its text: those with strict parsing.
// @return false if nothing was read.
bool ReadPlainList(std::istream& is, Real* numbers, UInt32 count) {
  constexpr UInt32 kMaxPlainValues = 4;
  std::array<char, 128> text;
  std::streambuf& buffer = *is.rdbuf();
  const std::streamsize length = buffer.in_avail();
  if (count > kMaxPlainValues || !IsStrictParsing(is) || length <= 0 ||
      length > std::streamsize(text.size()) || !is.good() ||
      is.getloc() != std::locale::classic()) {
    return false;
  }
  buffer.sgetn(text.data(), length);
  std::array<Real, kMaxPlainValues> read;
  if (ReadPlainList(text.data(), text.data() + length, read.data(), count)) {
    std::copy_n(read.begin(), count, numbers);
    return true;
  }
  for (std::streamsize i = 0; i < length; ++i) {
    buffer.sungetc();
  }
  return false;
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
  if (ReadPlainList(is, buffer, count)) {
    is.peek();  // notices the end, as reading the last number does
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
