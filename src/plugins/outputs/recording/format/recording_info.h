#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_RECORDING_INFO_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_RECORDING_INFO_H

#include <argos3/plugins/simulator/outputs/recording/format/pose_columns.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace argos {

/** What a recording says about the run that made it. */
struct SRecordingInfo {
  std::string ExperimentFile; /**< its name, for messages */
  std::string Experiment; /**< the XML as run, after overrides */
  std::vector<std::pair<std::string, std::string>> Overrides; /**< path and value */
  UInt32 Seed = 0;
  std::string Version; /**< version of the simulator */
  std::string Build; /**< says how it was built */
  std::string Date; /**< date of the start, UTC, ISO 8601 */
  Real TickLength = 0.1; /**< s */
  UInt32 Every = 1; /**< ticks from frame to frame, but for the last one */
  EPrecision Precision = EPrecision::Grid;
};

/** As bytes: pairs of a name and a text, of which a reader skips those that it does not know. */
std::string WriteInfo(const SRecordingInfo& info);
/** @throws CARGoSException */
SRecordingInfo ReadInfo(std::string_view bytes);

}  // namespace argos

#endif
