#include <argos3/campaign/design/campaign.h>

namespace argos {

std::string SCombination::ComputeKey() const {
  std::string key;
  for (const SSetting& setting : Settings) {
    key += setting.Path;
    key += '=';
    for (const char c : setting.Value) {
      if (c == '\n') {
        key += "&#10;";
      } else {
        key += c;
      }
    }
    key += '\n';
  }
  return key;
}

std::vector<std::string> SCampaign::ListFactors() const {
  std::vector<std::string> names;
  for (const SFactor& factor : Factors) {
    names.push_back(factor.Name);
  }
  return names;
}

const std::vector<std::string>& ListBuiltInMetrics() {
  static const std::vector<std::string> kNames = {
      "dispersion",    "collisions", "messages",        "real_time_factor", "loop_wall_time",
      "loop_cpu_time", "speedup",    "resident_memory", "other_load"};
  return kNames;
}

}  // namespace argos
