// That viewers do not change runs of several experiments, and what comes with each state.

#include "live_viewer.h"

#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/temporary_folder.h>

#include <catch2/catch.hpp>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace live_states_test {

using namespace argos;

namespace {

/* An experiment of the tree. */
struct SSubject {
  std::string Name;
  Real Seconds;
  std::string Pinned; /**< id of an entity */
};

std::function<void(CSimulator&)> LoadingSubject(const SSubject& subject,
                                                const CTemporaryFolder& folder) {
  return [subject, data = folder.Path("data.csv")](CSimulator& simulator) {
    simulator.SetLength(subject.Seconds);
    if (subject.Name == "foraging") {
      simulator.AddOverride("/loop_functions/foraging/@output", data);
    }
    simulator.SetExperimentFileName(InSourceTree("experiments/" + subject.Name + ".argos"));
    simulator.LoadExperiment(true);
  };
}

}  // namespace

TEST_CASE("live view: six experiments are the same with 0, 1 and 8 viewers", "[live]") {
  // cameras and light; a floor that is read, and loop functions; grips; messages; flight; Lua on a
  // torus
  const SSubject subject = GENERATE(values<SSubject>({{"flocking", 10.0, "fb0"},
                                                      {"foraging", 10.0, "fb0"},
                                                      {"gripping", 15.0, "fb"},
                                                      {"rab_chat", 5.0, "eb0"},
                                                      {"eyebot_flocking", 10.0, "eb0"},
                                                      {"vicsek_lua", 5.0, "ep0"}}));
  CAPTURE(subject.Name);
  const CTemporaryFolder folder;
  const UInt64 expected = RunHeadless(LoadingSubject(subject, folder));
  for (const size_t numViewers : {size_t(0), size_t(1), size_t(8)}) {
    CAPTURE(numViewers);
    CLiveWorld world(numViewers == 0 ? kPlays : kWaits, LoadingSubject(subject, folder));
    std::vector<std::unique_ptr<CLiveClient>> viewers;
    while (viewers.size() < numViewers) {
      viewers.push_back(Join(world));
      CHECK(IsOk(viewers.back()->Do("pin", {{"entity", subject.Pinned}})));
      CHECK(viewers.back()->WaitFor("values")["entity"] == subject.Pinned);
    }
    if (numViewers > 0) {
      PlayToEnd(*viewers.front());
      CHECK(viewers.front()->CountFrames() > 1);
      CHECK(IsOk(viewers.front()->Do("end")));
    }
    CHECK(world.Finish() == expected);
  }
}

TEST_CASE("live view: what a pinned robot perceives comes before the state of its tick", "[live]") {
  const CTemporaryFolder folder;
  CLiveWorld world({{"speed", "10"}, {"fps", "25"}},
                   LoadingSubject({"flocking", 20.0, "fb0"}, folder));
  auto viewer = Join(world);
  viewer->ReceiveUntil([&] { return viewer->CountFrames() > 0; });
  CHECK(IsOk(viewer->Do("pin", {{"entity", "fb0"}})));
  std::set<UInt32> perceived;
  size_t numMarks = 0;
  UInt32 numStates = 0;
  const UInt32 numBefore = viewer->CountFrames();
  CHECK(IsOk(viewer->Do("play")));
  viewer->ReceiveUntil([&] {
    const TJson& text = viewer->GetText();
    if (text.is_object() && text.contains("perceived")) {
      const TJson& message = text["perceived"];
      CHECK(message["entity"] == "fb0");
      CHECK(message["light"].size() == 24);
      perceived.insert(message["tick"].get<UInt32>());
      numMarks += message["marks"].size();
    } else if (text.is_null() && viewer->CountFrames() > numBefore) {
      ++numStates;
      CAPTURE(viewer->GetFrame().Tick);
      CHECK(perceived.count(viewer->GetFrame().Tick) == 1);
    }
    return viewer->GetStatus().value("run", "") == "ended";
  });
  // two seconds: about 50 states; it sees other robots in nearly each
  CHECK(numStates > 10);
  CHECK(numMarks > numStates);
  CHECK(IsOk(viewer->Do("end")));
  world.Finish();
}

}  // namespace live_states_test
