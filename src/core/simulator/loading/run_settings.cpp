#include <argos3/core/simulator/loading/run_settings.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <chrono>
#include <cmath>
#include <limits>

namespace argos {

void SRunSettings::SetLength(Real seconds, Real tickLength) {
  if (!(seconds >= 0.0) || std::isinf(seconds)) {
    THROW_ARGOSEXCEPTION("the length of an experiment must be 0 (unlimited) or more seconds, got "
                         << seconds);
  }
  // tolerance for a whole number of ticks that the division rounds down
  const Real ticks = std::floor(seconds / tickLength + 1e-6);
  if (ticks > std::numeric_limits<UInt32>::max()) {
    THROW_ARGOSEXCEPTION("an experiment of " << seconds << " s has more ticks than can be counted");
  }
  Length = seconds;
  MaxClock = static_cast<UInt32>(ticks);
}

void SRunSettings::DrawSeedFromClock() {
  using namespace std::chrono;
  const auto now = duration_cast<microseconds>(system_clock::now().time_since_epoch()).count();
  Seed = static_cast<UInt32>(now);
}

void SRunSettings::ForgetWhatWasSet() {
  Overrides.clear();
  Outputs.clear();
  Visualization.reset();
  IsSeedSet = AreThreadsSet = IsLengthSet = false;
  IsSeedFromClock = true;
  IsRealTime = false;
}

}  // namespace argos
