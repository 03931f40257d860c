#include <argos3/core/simulator/replay/replay.h>

#include <argos3/core/utility/text/string_utilities.h>

namespace argos {

std::optional<SReplayTime> ParseReplayTime(const std::string& text) {
  if (!text.empty() && text.back() == 's') {
    Real seconds = 0.0;
    const ENumberParsing result = ParseNumber(text.substr(0, text.size() - 1), seconds);
    return result == ENumberParsing::Ok && seconds >= 0.0
               ? std::optional<SReplayTime>({seconds, true})
               : std::nullopt;
  }
  UInt32 tick = 0;
  return ParseNumber(text, tick) == ENumberParsing::Ok
             ? std::optional<SReplayTime>({Real(tick), false})
             : std::nullopt;
}

}  // namespace argos
