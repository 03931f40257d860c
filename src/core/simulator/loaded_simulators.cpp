#include <argos3/core/simulator/loaded_simulators.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

namespace argos {

namespace {

struct SLoadedSimulator {
  CSimulator* Simulator;
  CRandom::CRegistry* Registry;
};

struct SLoadedState {
  std::mutex Mutex;
  std::vector<SLoadedSimulator> All;
  std::atomic<CSimulator*> Only{nullptr};  // null if there is not exactly one
  std::atomic<bool> AreSeveral{false};

  /* To be called with the lock. */
  void Publish() {
    const bool isOnly = All.size() == 1;
    // the flag is set before the pointer is cleared, and cleared after the pointer is set: a reader
    // without the lock that sees neither has to look at the pointer once more
    if (All.size() > 1) {
      AreSeveral = true;
      Only = nullptr;
    } else {
      Only = isOnly ? All.front().Simulator : nullptr;
      AreSeveral = false;
    }
    CRandom::SetSharedRegistry(isOnly ? All.front().Registry : nullptr);
  }
};

// never deleted: threads of users may outlive static objects
SLoadedState& GetLoadedState() {
  static auto* const state = std::make_unique<SLoadedState>().release();
  return *state;
}

thread_local const CSimulator* loadedByThread = nullptr;  // compared only: it may be destroyed

auto FindLoaded(std::vector<SLoadedSimulator>& all, const CSimulator* simulator) {
  return std::ranges::find(all, simulator, &SLoadedSimulator::Simulator);
}

}  // namespace

void CLoadedSimulators::Add(CSimulator& simulator, CRandom::CRegistry& registry) {
  SLoadedState& state = GetLoadedState();
  const std::lock_guard<std::mutex> guard(state.Mutex);
  loadedByThread = &simulator;
  if (FindLoaded(state.All, &simulator) == state.All.end()) {
    state.All.push_back({&simulator, &registry});
    state.Publish();
  }
}

void CLoadedSimulators::Remove(const CSimulator& simulator) {
  SLoadedState& state = GetLoadedState();
  const std::lock_guard<std::mutex> guard(state.Mutex);
  const auto place = FindLoaded(state.All, &simulator);
  if (place != state.All.end()) {
    state.All.erase(place);
    state.Publish();
  }
}

CSimulator* CLoadedSimulators::FindForThisThread() {
  SLoadedState& state = GetLoadedState();
  if (CSimulator* const only = state.Only; only != nullptr) {
    return only;
  }
  if (!state.AreSeveral) {
    return state.Only;
  }
  const std::lock_guard<std::mutex> guard(state.Mutex);
  const auto place = FindLoaded(state.All, loadedByThread);
  if (place != state.All.end()) {
    return place->Simulator;
  }
  if (state.All.size() <= 1) {
    return state.Only;
  }
  THROW_ARGOSEXCEPTION(
      "CSimulator::GetInstance(): "
      << state.All.size()
      << " simulators of this process have an experiment, and this thread has loaded none of them: "
         "it must choose one by CSimulator::CScope");
}

}  // namespace argos
