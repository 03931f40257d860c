#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_RUN_INFO_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_RUN_INFO_H

#include <argos3/plugins/simulator/outputs/recording/format/recording_info.h>

namespace argos {

class CSimulator;

/** What a recording, or a live view, says about the run of a loaded experiment; dated now. */
SRecordingInfo MakeRunInfo(const CSimulator& simulator);

}  // namespace argos

#endif
