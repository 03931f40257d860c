#include <argos3/campaign/report/series_times.h>

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/errors/argos_exception.h>

namespace argos {

Real FindTicksPerSecond(const SCampaign& campaign) {
  for (const SCombination& combination : campaign.Combinations) {
    for (const SSetting& setting : combination.Settings) {
      if (setting.Path.find("ticks_per_second") != std::string::npos) {
        return 0.0;
      }
    }
  }
  Real ticksPerSecond = 0.0;
  try {
    CConfigurationDocument document;
    document.Parse(campaign.ExperimentText, campaign.ExperimentFile);
    GetNodeAttributeOrDefault(GetNode(GetNode(document.GetRoot(), "framework"), "experiment"),
                              "ticks_per_second", ticksPerSecond, 0.0);
  } catch (const CARGoSException&) {
    // ticks remain
  }
  return ticksPerSecond;
}

std::string MakeTimeLabel(Real ticksPerSecond) {
  return ticksPerSecond > 0.0 ? "time (s)" : "time (ticks)";
}

}  // namespace argos
