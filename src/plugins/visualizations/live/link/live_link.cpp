#include <argos3/plugins/simulator/visualizations/live/link/live_link.h>

#include <utility>

namespace argos {

namespace {

constexpr size_t kMaxFree = 2;

}  // namespace

std::unique_ptr<SLiveState> CLiveLink::MakeState() {
  const std::lock_guard<std::mutex> lock(m_mutex);
  if (m_free.empty()) {
    return std::make_unique<SLiveState>();
  }
  std::unique_ptr<SLiveState> state = std::move(m_free.back());
  m_free.pop_back();
  return state;
}

void CLiveLink::PutState(std::unique_ptr<SLiveState> state) {
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    std::swap(m_state, state);
    m_wantsState.store(false, std::memory_order_relaxed);
  }
  if (state != nullptr) {
    GiveBack(std::move(state));
  }
  Notify();
}

void CLiveLink::PutEvent(SLiveEvent event) {
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if (m_eventBytes + event.Text.size() > kMaxEventBytes) {
      ++m_numDropped;
    } else {
      m_eventBytes += event.Text.size();
      m_events.push_back(std::move(event));
    }
  }
  Notify();
}

void CLiveLink::PutStatus(const SLiveStatus& status) {
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if (m_status == status) {
      return;
    }
    m_status = status;
  }
  Notify();
}

void CLiveLink::TakeCommands(std::vector<SLiveCommand>& commands) {
  commands.clear();
  const std::lock_guard<std::mutex> lock(m_mutex);
  commands.swap(m_commands);
  m_hasCommands.store(false, std::memory_order_release);
}

void CLiveLink::WaitUntil(TClock::time_point end, bool hasState) {
  std::unique_lock<std::mutex> lock(m_mutex);
  m_isChanged.wait_until(lock, end,
                         [&] { return !m_commands.empty() || (hasState && m_wantsState.load()); });
}

void CLiveLink::SetNotifier(std::function<void()> notify) {
  const std::lock_guard<std::mutex> lock(m_mutex);
  m_notify = std::move(notify);
}

// the server is called once for all that waits
void CLiveLink::Notify() {
  const std::lock_guard<std::mutex> lock(m_mutex);
  if (m_notify && !std::exchange(m_isNotified, true)) {
    m_notify();
  }
}

void CLiveLink::SetNumViewers(size_t number) {
  m_numViewers.store(number, std::memory_order_relaxed);
  if (number > 0) {
    m_hadViewers.store(true, std::memory_order_relaxed);
  }
}

void CLiveLink::SetWantsState(bool wants) {
  if (m_wantsState.load(std::memory_order_relaxed) == wants) {
    return;
  }
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    // a state that waits is the answer
    m_wantsState.store(wants && m_state == nullptr, std::memory_order_relaxed);
  }
  m_isChanged.notify_one();
}

bool CLiveLink::AddCommand(SLiveCommand command) {
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if (m_commands.size() >= kMaxCommands) {
      return false;
    }
    m_commands.push_back(std::move(command));
    m_hasCommands.store(true, std::memory_order_release);
  }
  m_isChanged.notify_one();
  return true;
}

std::unique_ptr<SLiveState> CLiveLink::TakeState() {
  const std::lock_guard<std::mutex> lock(m_mutex);
  m_isNotified = false;
  return std::move(m_state);
}

void CLiveLink::GiveBack(std::unique_ptr<SLiveState> state) {
  state->Update.Clear();
  state->Table.reset();
  const std::lock_guard<std::mutex> lock(m_mutex);
  if (m_free.size() < kMaxFree) {
    m_free.push_back(std::move(state));
  }
}

void CLiveLink::TakeEvents(std::vector<SLiveEvent>& events) {
  events.clear();
  size_t numDropped = 0;
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_isNotified = false;
    events.swap(m_events);
    m_eventBytes = 0;
    numDropped = std::exchange(m_numDropped, 0);
  }
  if (numDropped > 0) {
    const TJson line = {
        {"level", "warning"},
        {"text", std::to_string(numDropped) + " messages of the run were too many"}};
    events.push_back({0, ToText({{"log", TJson::array({line})}})});
  }
}

SLiveStatus CLiveLink::GetStatus() const {
  const std::lock_guard<std::mutex> lock(m_mutex);
  return m_status;
}

}  // namespace argos
