#include "live_viewer.h"

#include <argos3/core/utility/configuration/configuration_document.h>

#include <catch2/catch.hpp>

#include <stdexcept>

namespace argos {

std::unique_ptr<CLiveClient> Join(const CLiveWorld& world) {
  auto viewer = std::make_unique<CLiveClient>(world.GetURL());
  viewer->Hello();
  viewer->WaitFor("welcome");
  return viewer;
}

bool IsOk(const TJson& answer) {
  return answer.is_object() && answer.value("ok", false);
}

std::string GetError(const TJson& answer) {
  const std::string error = answer.is_object() ? answer.value("error", "") : "closed";
  // which only logs have
  CHECK(error.find("[FATAL]") == std::string::npos);
  return error;
}

void PlayToEnd(CLiveClient& viewer) {
  CHECK(IsOk(viewer.Do("play")));
  viewer.ReceiveUntil([&] { return viewer.GetStatus().value("run", "") == "ended"; });
  const UInt32 last = viewer.GetStatus()["tick"];
  if (viewer.GetFrame().Tick != last) {
    viewer.ReceiveUntil([&] { return viewer.GetFrame().Tick == last; });
  }
}

void StepTicks(CLiveClient& viewer, UInt32 ticks) {
  const UInt32 last = viewer.GetFrame().Tick + ticks;
  CHECK(IsOk(viewer.Do("step", {{"n", ticks}})));
  viewer.ReceiveUntil([&] { return viewer.GetFrame().Tick == last; });
}

const SBodyPose& GetPose(const SRecordedFrame& frame, const std::string& id) {
  size_t place = 0;
  for (const SRecordedEntity& entity : frame.Entities) {
    if (entity.Id == id) {
      return frame.Poses.at(place);
    }
    place += frame.Types.at(entity.Type).GetNumPoses();
  }
  throw std::runtime_error("the state has no " + id);
}

std::function<void(CSimulator&)> Loading(const std::string& xml) {
  auto document = std::make_shared<CConfigurationDocument>();
  document->Parse(xml, "test");
  return [document](CSimulator& simulator) { simulator.Load(*document); };
}

}  // namespace argos
