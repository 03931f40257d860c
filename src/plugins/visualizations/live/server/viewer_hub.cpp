#include <argos3/plugins/simulator/visualizations/live/server/viewer_hub.h>

#include <algorithm>
#include <set>
#include <utility>

namespace argos {

namespace {

constexpr Real kMinRate = 0.1;  // states a second
constexpr Real kMaxRate = 100.0;
constexpr size_t kMaxIdBytes = 256;

// commands that need no control
const std::set<std::string>& FreeCommands() {
  static const std::set<std::string> free = {"pin", "unpin", "rate", "ask_control", "parameters"};
  return free;
}

TLiveText Share(std::string text) {
  return std::make_shared<const std::string>(std::move(text));
}

}  // namespace

UInt32 CViewerHub::Add(std::shared_ptr<CViewerConnection> viewer) {
  if (m_viewers.size() >= kMaxViewers) {
    return 0;
  }
  m_viewers[++m_lastNumber] = std::move(viewer);
  if (m_control == 0 && m_hasControl) {
    m_control = m_lastNumber;
  }
  m_link.SetNumViewers(m_viewers.size());
  return m_lastNumber;
}

void CViewerHub::Welcome(CViewerConnection& viewer) {
  TJson welcome = m_show.Welcome;
  welcome["viewer"] = viewer.GetNumber();
  viewer.Send(Share(ToText({{"welcome", welcome}})));
  viewer.Send(Share(m_show.Info), true);
  for (const TLiveText& line : m_history) {
    viewer.Send(line);
  }
  SendStatus();
  OnReady();
}

void CViewerHub::Remove(CViewerConnection& viewer) {
  const auto found = m_viewers.find(viewer.GetNumber());
  if (found == m_viewers.end() || found->second.get() != &viewer) {
    return;
  }
  const std::shared_ptr<CViewerConnection> kept = std::move(found->second);
  m_viewers.erase(found);
  m_asking.erase(std::remove(m_asking.begin(), m_asking.end(), viewer.GetNumber()), m_asking.end());
  m_link.SetNumViewers(m_viewers.size());
  if (!viewer.GetPinned().empty()) {
    UpdatePinned();
  }
  if (m_viewers.empty()) {
    // the next viewer is not to see an old state, but the present one, also of a run that waits
    m_state.reset();
    m_link.AddCommand({0, TJson(), "left", TJson::object()});
  }
  ChooseControl();
  SendStatus();
  OnReady();
}

void CViewerHub::ChooseControl() {
  if (!m_hasControl || m_viewers.count(m_control) > 0) {
    return;
  }
  UInt32 next = m_viewers.empty() ? 0 : m_viewers.begin()->first;
  if (!m_asking.empty()) {
    next = m_asking.front();
    m_asking.pop_front();
  }
  SetControl(next);
}

// Gives a viewer control; the run releases the keys that the viewer before it holds.
void CViewerHub::SetControl(UInt32 viewer) {
  if (viewer != m_control) {
    m_control = viewer;
    m_link.AddCommand({0, TJson(), "release", TJson::object()});
  }
}

void CViewerHub::Answer(CViewerConnection& viewer, const TJson& id, const std::string& error) {
  TJson answer = {{"re", id}};
  if (error.empty()) {
    answer["ok"] = true;
  } else {
    answer["error"] = error;
  }
  viewer.Send(Share(ToText(answer)));
}

void CViewerHub::OnMessage(CViewerConnection& viewer, const TJson& message) {
  const auto name = message.find("do");
  if (name == message.end()) {
    // an acknowledgement of nothing, or of a later protocol
    return;
  }
  const auto id = message.find("id");
  if (!name->is_string() || id == message.end() || !id->is_number_integer()) {
    Answer(viewer, TJson(), "a command has a number \"id\" and a name \"do\"");
    return;
  }
  OnCommand(viewer, message);
}

void CViewerHub::OnCommand(CViewerConnection& viewer, const TJson& message) {
  const std::string name = message["do"].get<std::string>();
  if (!m_hasControl && (name == "ask_control" || FreeCommands().count(name) == 0)) {
    Answer(viewer, message["id"], "this run can only be watched: <live control=\"false\">");
    return;
  }
  if (m_control != viewer.GetNumber() && FreeCommands().count(name) == 0) {
    Answer(viewer, message["id"],
           "another viewer has control: ask for it, and wait until it is given to you");
    return;
  }
  bool isForRun = false;
  const std::string error = ChangeViewer(viewer, name, message, isForRun);
  if (isForRun && error.empty()) {
    if (!m_link.AddCommand({viewer.GetNumber(), message["id"], name, message})) {
      Answer(viewer, message["id"], "too many commands wait for the end of the tick");
    }
    return;
  }
  Answer(viewer, message["id"], error);
}

// Does the part of a command that concerns viewers alone; isForRun: the run does the rest.
std::string CViewerHub::ChangeViewer(CViewerConnection& viewer, const std::string& name,
                                     const TJson& message, bool& isForRun) {
  if (name == "rate") {
    const auto fps = message.find("fps");
    if (fps == message.end() || !fps->is_number() || !(fps->get<Real>() >= kMinRate) ||
        !(fps->get<Real>() <= kMaxRate)) {
      return "\"fps\" is a number from 0.1 to 100";
    }
    viewer.SetRate(fps->get<Real>());
    return "";
  }
  if (name == "ask_control") {
    if (m_control != viewer.GetNumber() &&
        std::find(m_asking.begin(), m_asking.end(), viewer.GetNumber()) == m_asking.end()) {
      m_asking.push_back(viewer.GetNumber());
      SendStatus();
    }
    return "";
  }
  if (name == "give_control") {
    return GiveControl(message);
  }
  if (name == "pin" || name == "unpin") {
    return Pin(viewer, message, name == "pin");
  }
  isForRun = true;
  return "";
}

std::string CViewerHub::GiveControl(const TJson& message) {
  const auto other = message.find("viewer");
  if (other == message.end() || !other->is_number_unsigned() ||
      m_viewers.count(other->get<UInt32>()) == 0) {
    return "there is no such viewer";
  }
  SetControl(other->get<UInt32>());
  m_asking.erase(std::remove(m_asking.begin(), m_asking.end(), m_control), m_asking.end());
  SendStatus();
  return "";
}

std::string CViewerHub::Pin(CViewerConnection& viewer, const TJson& message, bool pins) {
  const auto entity = message.find("entity");
  if (entity == message.end() || !entity->is_string()) {
    return "\"entity\" is the id of an entity";
  }
  const auto& id = entity->get_ref<const std::string&>();
  if (id.size() > kMaxIdBytes) {
    return "there is no such entity";
  }
  if (!pins) {
    viewer.GetPinned().erase(id);
  } else if (viewer.GetPinned().size() >= kMaxPinned && viewer.GetPinned().count(id) == 0) {
    return "at most 16 entities can be pinned";
  } else {
    viewer.GetPinned().insert(id);
  }
  UpdatePinned();
  return "";
}

// the run computes the values of each pinned entity once
void CViewerHub::UpdatePinned() {
  std::set<std::string> pinned;
  for (const auto& [number, viewer] : m_viewers) {
    pinned.insert(viewer->GetPinned().begin(), viewer->GetPinned().end());
  }
  m_link.AddCommand({0, TJson(), "pinned", {{"entities", pinned}}});
}

// a viewer that is too slow is removed meanwhile
void CViewerHub::SendToAll(const std::string& text) {
  const TLiveText shared = Share(text);
  const auto viewers = m_viewers;
  for (const auto& [number, viewer] : viewers) {
    viewer->Send(shared);
  }
}

void CViewerHub::SendToPinning(const SLiveEvent& event) {
  const TLiveText shared = Share(event.Text);
  const auto viewers = m_viewers;
  for (const auto& [number, viewer] : viewers) {
    if (viewer->GetPinned().count(event.Pinned) > 0) {
      viewer->Send(shared);
    }
  }
}

void CViewerHub::SendEvent(const SLiveEvent& event) {
  if (event.Viewer != 0) {
    const auto found = m_viewers.find(event.Viewer);
    if (found != m_viewers.end()) {
      const std::shared_ptr<CViewerConnection> viewer = found->second;
      viewer->Send(Share(event.Text));
    }
    return;
  }
  if (!event.Pinned.empty()) {
    SendToPinning(event);
    return;
  }
  constexpr std::string_view kLog = "{\"log\":";
  if (event.Text.compare(0, kLog.size(), kLog) == 0) {
    m_history.push_back(Share(event.Text));
    m_historyBytes += event.Text.size();
    while (m_historyBytes > kMaxHistoryBytes) {
      m_historyBytes -= m_history.front()->size();
      m_history.pop_front();
    }
  }
  SendToAll(event.Text);
}

void CViewerHub::OnRun() {
  if (std::unique_ptr<SLiveState> state = m_link.TakeState()) {
    std::swap(m_state, state);
    if (state != nullptr) {
      m_link.GiveBack(std::move(state));
    }
  }
  m_link.TakeEvents(m_events);
  for (const SLiveEvent& event : m_events) {
    SendEvent(event);
  }
  if (m_link.GetStatus() != m_status) {
    SendStatus();
  }
  OnReady();
}

void CViewerHub::OnReady() {
  const TClock::time_point now = TClock::now();
  bool wants = false;
  const auto viewers = m_viewers;
  for (const auto& [number, viewer] : viewers) {
    if (viewer->IsReadyForState(now)) {
      wants = m_state == nullptr || !viewer->SendState(*m_state, m_packer, now) || wants;
    }
  }
  m_link.SetWantsState(wants);
  m_onReady();
}

std::optional<CViewerHub::TClock::time_point> CViewerHub::GetNextDueTime() const {
  std::optional<TClock::time_point> next;
  const TClock::time_point now = TClock::now();
  for (const auto& [number, viewer] : m_viewers) {
    if (viewer->GetDueTime() > now && viewer->IsReadyForState(viewer->GetDueTime())) {
      next = next ? std::min(*next, viewer->GetDueTime()) : viewer->GetDueTime();
    }
  }
  return next;
}

void CViewerHub::SendStatus() {
  if (m_viewers.empty()) {
    return;
  }
  m_status = m_link.GetStatus();
  const SLiveStatus& status = m_status;
  TJson viewers = TJson::array();
  for (const auto& [number, viewer] : m_viewers) {
    viewers.push_back(
        {{"id", number},
         {"name", viewer->GetName()},
         {"asks", std::find(m_asking.begin(), m_asking.end(), number) != m_asking.end()}});
  }
  SendToAll(ToText({{"status",
                     {{"run", status.Run},
                      {"tick", status.Tick},
                      {"speed", status.Speed},
                      {"real_time_factor", status.RealTimeFactor},
                      {"control", m_control},
                      {"viewers", viewers}}}}));
}

void CViewerHub::CloseAll(const std::string& reason) {
  const auto viewers = m_viewers;
  for (const auto& [number, viewer] : viewers) {
    viewer->Close(reason);
  }
}

}  // namespace argos
