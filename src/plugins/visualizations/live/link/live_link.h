#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_LINK_LIVE_LINK_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_LINK_LIVE_LINK_H

#include <argos3/plugins/simulator/visualizations/live/link/live_messages.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace argos {

/**
 * What the run (the main thread) and the server (its thread) hand over to each other.
 *
 * The run looks here between ticks only, and takes no lock unless something waits for it or it has
 * something to say. Of states only the latest one waits; events and commands keep their order.
 */
class CLiveLink {
 public:
  using TClock = std::chrono::steady_clock;
  /** Events that wait, in bytes; more are dropped, and the number of these is said. */
  static constexpr size_t kMaxEventBytes = size_t(1) << 22;
  /** Commands of all viewers that wait. */
  static constexpr size_t kMaxCommands = 1024;

  // of the run

  bool HasViewers() const { return m_numViewers.load(std::memory_order_relaxed) > 0; }
  /** True once a viewer has been connected. */
  bool HadViewers() const { return m_hadViewers.load(std::memory_order_relaxed); }
  bool WantsState() const { return m_wantsState.load(std::memory_order_relaxed); }
  bool HasCommands() const { return m_hasCommands.load(std::memory_order_acquire); }
  /** An empty state, with the memory of one that was sent. */
  std::unique_ptr<SLiveState> MakeState();
  void PutState(std::unique_ptr<SLiveState> state);
  void PutEvent(SLiveEvent event);
  void PutStatus(const SLiveStatus& status);
  void TakeCommands(std::vector<SLiveCommand>& commands);
  /** Waits for a command, for a viewer that wants a state if @p hasState, or until the time. */
  void WaitUntil(TClock::time_point end, bool hasState);

  // of the server

  /** @param notify  called by the run when it has put something; empty: the server has ended. */
  void SetNotifier(std::function<void()> notify);
  void SetNumViewers(size_t number);
  void SetWantsState(bool wants);
  /** @return false if too many wait. */
  bool AddCommand(SLiveCommand command);
  /** @return null if there is none since the last call. */
  std::unique_ptr<SLiveState> TakeState();
  void GiveBack(std::unique_ptr<SLiveState> state);
  void TakeEvents(std::vector<SLiveEvent>& events);
  SLiveStatus GetStatus() const;

 private:
  void Notify();

  std::atomic<size_t> m_numViewers{0};
  std::atomic<bool> m_hadViewers{false};
  std::atomic<bool> m_wantsState{false};
  std::atomic<bool> m_hasCommands{false};

  mutable std::mutex m_mutex;  // guards what follows
  std::condition_variable m_isChanged;
  std::function<void()> m_notify;
  bool m_isNotified = false;
  std::unique_ptr<SLiveState> m_state;
  std::vector<std::unique_ptr<SLiveState>> m_free;
  std::vector<SLiveEvent> m_events;
  size_t m_eventBytes = 0;
  size_t m_numDropped = 0;  // events
  std::vector<SLiveCommand> m_commands;
  SLiveStatus m_status;
};

}  // namespace argos

#endif
