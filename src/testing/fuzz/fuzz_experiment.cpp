// The input is an experiment file: it is loaded and runs for three ticks. Files that name others,
// and swarms that take long, are left out.

#include <argos3/testing/fuzz/fuzz_support.h>

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/configuration/configuration_document.h>

#include <cctype>
#include <string_view>

using namespace argos;

namespace {

// an experiment with such a number may take long or much memory: as many robots, as many pixels
constexpr int kMaxDigits = 3;

bool HasLongNumber(std::string_view text) {
  int digits = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool isDigit = std::isdigit(static_cast<unsigned char>(text[i])) != 0;
    const bool isExponent = digits > 0 && (text[i] == 'e' || text[i] == 'E');
    digits = isDigit ? digits + 1 : 0;
    if (digits > kMaxDigits || isExponent) {
      return true;
    }
  }
  return false;
}

bool NamesFile(std::string_view text) {
  for (const char* const name :
       {"library", "script", "file", "log", "path", "image", "visualization", "profiling"}) {
    if (text.find(name) != std::string_view::npos) {
      return true;
    }
  }
  return false;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (NamesFile(text) || HasLongNumber(text)) {
    return 0;
  }
  return RunFuzzInput([text] {
    CConfigurationDocument document;
    document.Parse(std::string(text), "fuzz");
    CSimulator simulator;
    simulator.Load(document, true);
    for (int tick = 0; tick < 3; ++tick) {
      simulator.UpdateSpace();
    }
    simulator.Reset();
    simulator.UpdateSpace();
  });
}
