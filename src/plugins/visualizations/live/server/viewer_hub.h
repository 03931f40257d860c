#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_SERVER_VIEWER_HUB_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_SERVER_VIEWER_HUB_H

#include <argos3/plugins/simulator/visualizations/live/link/live_link.h>
#include <argos3/plugins/simulator/visualizations/live/server/request_checks.h>
#include <argos3/plugins/simulator/visualizations/live/server/viewer_connection.h>

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace argos {

/** The sub-protocol of the WebSocket. */
constexpr char kLiveProtocol[] = "argos-live.1";

/** What the server shows besides the states. */
struct SLiveShow {
  std::string Info; /**< block of a recording */
  TJson Welcome; /**< without the viewer's number */
};

/**
 * All viewers of a run: who has control, and who gets what. Thread of the server only.
 *
 * One viewer has control: the first one, until it gives control to another. When the viewer with
 * control leaves, the viewer that has asked first gets it; if none has asked, the one that came
 * next. The others look, and may ask for control.
 */
class CViewerHub {
 public:
  using TClock = CViewerConnection::TClock;
  static constexpr size_t kMaxViewers = 64;
  /** Of the last lines of the log that a new viewer gets, bytes. */
  static constexpr size_t kMaxHistoryBytes = size_t(1) << 16;
  static constexpr size_t kMaxPinned = 16;

  CViewerHub(SLiveAccess access, Real statesPerSecond, CLiveLink& link)
      : m_access(std::move(access)),
        m_statesPerSecond(statesPerSecond),
        m_link(link),
        m_packer(1) {}

  /** @param handler  called when GetNextDueTime() may have changed. */
  void SetReadyHandler(std::function<void()> handler) { m_onReady = std::move(handler); }
  /** @param hasControl  one of the viewers can have it; otherwise all only look. */
  void SetHasControl(bool hasControl) { m_hasControl = hasControl; }
  void SetShow(SLiveShow show) { m_show = std::move(show); }
  const SLiveAccess& GetAccess() const { return m_access; }
  Real GetStatesPerSecond() const { return m_statesPerSecond; }
  bool IsToken(const std::string& token) const { return IsSameToken(token, m_access.Token); }

  /** Held by each connection, so that they can be counted. */
  std::shared_ptr<const int> GetConnectionMark() const { return m_mark; }
  size_t CountConnections() const { return static_cast<size_t>(m_mark.use_count()) - 1; }

  /** @return its number, from 1 on; 0: there are too many. */
  UInt32 Add(std::shared_ptr<CViewerConnection> viewer);
  void Welcome(CViewerConnection& viewer);
  /** Does nothing if it is not one of them. */
  void Remove(CViewerConnection& viewer);
  void OnMessage(CViewerConnection& viewer, const TJson& message);
  /** A viewer may now take another state. */
  void OnReady();
  /** Sends what the run has put into the link. */
  void OnRun();
  /** To be called once a second. */
  void SendStatus();
  /** When to call OnReady(), because of the viewers' rates; nothing: not before something happens.
   */
  std::optional<TClock::time_point> GetNextDueTime() const;
  void CloseAll(const std::string& reason);

 private:
  void SendToAll(const std::string& text);
  void SendToPinning(const SLiveEvent& event);
  void SendEvent(const SLiveEvent& event);
  void Answer(CViewerConnection& viewer, const TJson& id, const std::string& error);
  void OnCommand(CViewerConnection& viewer, const TJson& message);
  std::string ChangeViewer(CViewerConnection& viewer, const std::string& name, const TJson& message,
                           bool& isForRun);
  std::string Pin(CViewerConnection& viewer, const TJson& message, bool pins);
  std::string GiveControl(const TJson& message);
  void ChooseControl();
  void SetControl(UInt32 viewer);
  void UpdatePinned();

  SLiveAccess m_access;
  Real m_statesPerSecond;
  std::function<void()> m_onReady;
  std::shared_ptr<const int> m_mark = std::make_shared<const int>(0);
  CLiveLink& m_link;
  SLiveShow m_show;
  CBlockPacker m_packer;
  std::map<UInt32, std::shared_ptr<CViewerConnection>> m_viewers;  // by number
  UInt32 m_lastNumber = 0;
  bool m_hasControl = true;
  UInt32 m_control = 0;  // number of the viewer that has it; 0: none
  std::deque<UInt32> m_asking;  // numbers of viewers that ask for control
  std::unique_ptr<SLiveState> m_state;  // the last one; null: none since there are viewers
  std::deque<TLiveText> m_history;  // lines of the log
  size_t m_historyBytes = 0;
  std::vector<SLiveEvent> m_events;  // reused
  SLiveStatus m_status;  // the last one that was sent
};

}  // namespace argos

#endif
