#include <argos3/run/run_status.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <array>
#include <cstddef>
#include <vector>

namespace argos {

namespace {

// has the order of ERunStatus
constexpr std::array<const char*, 7> kStatusWords = {
    "done", "robots_stopped", "failed", "crashed", "timeout", "out_of_memory", "interrupted"};

}  // namespace

const char* ToText(ERunStatus status) {
  return kStatusWords.at(static_cast<size_t>(status));
}

ERunStatus ToRunStatus(const std::string& text) {
  for (size_t i = 0; i < kStatusWords.size(); ++i) {
    if (text == kStatusWords[i]) {
      return static_cast<ERunStatus>(i);
    }
  }
  const std::vector<std::string> known(kStatusWords.begin(), kStatusWords.end());
  THROW_ARGOSEXCEPTION("there is no status \"" << text << "\" of runs" << DidYouMean(text, known));
}

}  // namespace argos
