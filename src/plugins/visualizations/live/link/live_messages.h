#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_LINK_LIVE_MESSAGES_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_LINK_LIVE_MESSAGES_H

#include <argos3/plugins/simulator/outputs/recording/format/recorded_frame.h>

#include <nlohmann/json.hpp>

#include <memory>
#include <string>
#include <vector>

namespace argos {

using TJson = nlohmann::json;

/** As text; bytes that are no UTF-8 are replaced. */
inline std::string ToText(const TJson& json) {
  return json.dump(-1, ' ', false, TJson::error_handler_t::replace);
}

/** All types and entities of a state; shared by states between which none comes or goes. */
struct SLiveTable {
  std::vector<SRecordedType> Types;
  std::vector<SRecordedEntity> Entities;
};

/** What pictures show of one tick. */
struct SLiveState {
  UInt64 Number = 0; /**< since the start; increases */
  SFrameUpdate Update; /**< its table is empty: see Table */
  std::shared_ptr<const SLiveTable> Table;
};

/** What the run does. */
struct SLiveStatus {
  std::string Run; /**< "playing", "paused" or "ended" */
  UInt32 Tick = 0;
  Real Speed = 1.0; /**< simulated seconds in a second; 0: as fast as it goes */
  Real RealTimeFactor = 0.0; /**< measured */

  bool operator==(const SLiveStatus&) const = default;
};

/** A text for viewers, never skipped. */
struct SLiveEvent {
  UInt32 Viewer = 0; /**< 0: all */
  std::string Text; /**< JSON */
  std::string Pinned = {}; /**< if set, only viewers that have pinned it get the event */
};

/** What a viewer wants of the run. */
struct SLiveCommand {
  UInt32 Viewer = 0;
  TJson Id; /**< the answer to the command repeats it */
  std::string Do;
  TJson Arguments; /**< an object */
};

}  // namespace argos

#endif
