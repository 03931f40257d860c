#include <argos3/core/simulator/simulator.h>
#include <argos3/plugins/simulator/outputs/recording/run_info.h>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

namespace argos {

SRecordingInfo MakeRunInfo(const CSimulator& simulator) {
  SRecordingInfo info;
  info.ExperimentFile = simulator.GetExperimentFileName();
  info.Experiment = simulator.GetExperimentText();
  info.Overrides = simulator.GetOverrides();
  info.Seed = simulator.GetRandomSeed();
  info.Version = ARGOS_VERSION "-" ARGOS_RELEASE;
  info.Build = ARGOS_BUILD_FLAGS;
  info.Date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  info.TickLength = simulator.GetTickLength();
  return info;
}

}  // namespace argos
