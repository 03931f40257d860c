#ifndef ARGOS3_TESTING_SCENARIO_LIVE_LIVE_VIEWER_H
#define ARGOS3_TESTING_SCENARIO_LIVE_LIVE_VIEWER_H

#include "live_client.h"
#include "live_world.h"

#include <memory>
#include <string>

namespace argos {

// Attributes of <live>.
inline const CLiveWorld::TAttributes kPlays = {{"play", "true"}, {"speed", "0"}};
inline const CLiveWorld::TAttributes kWaits = {{"speed", "0"}};

/** A viewer that was welcomed. */
std::unique_ptr<CLiveClient> Join(const CLiveWorld& world);

bool IsOk(const TJson& answer);
/** Empty if there is none; "closed" if the connection is. */
std::string GetError(const TJson& answer);

/** Plays to the end, and sees the last state. */
void PlayToEnd(CLiveClient& viewer);
/** Does a number of ticks after the state that the viewer has, and sees the last one. */
void StepTicks(CLiveClient& viewer, UInt32 ticks);

/** The first pose of an entity. @throws std::runtime_error if the state does not have it. */
const SBodyPose& GetPose(const SRecordedFrame& frame, const std::string& id);

/** Loads an experiment from a text. */
std::function<void(CSimulator&)> Loading(const std::string& xml);

}  // namespace argos

#endif
