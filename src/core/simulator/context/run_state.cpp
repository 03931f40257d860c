#include <argos3/core/simulator/context/run_state.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/errors/running_code.h>
#include <argos3/core/utility/logging/argos_log.h>

#include <algorithm>

namespace argos {

namespace {

constexpr char kOnlyBetweenTicks[] =
    "it is possible only between ticks; CSimulator::Terminate() ends the run after this tick";

const char* Describe(CRunState::EActivity activity) {
  switch (activity) {
    case CRunState::EActivity::Loading:
      return "the experiment is being loaded";
    case CRunState::EActivity::Hook:
      return "loop functions are called in a tick";
    case CRunState::EActivity::Phase:
      return "robots, engines or media are being updated";
    case CRunState::EActivity::Changing:
      return "entities are being added and removed";
    case CRunState::EActivity::Resetting:
      return "the experiment is being reset";
    case CRunState::EActivity::Destroying:
      return "the experiment is being destroyed";
    case CRunState::EActivity::None:
      break;
  }
  return "Execute() is running";
}

}  // namespace

void CRunState::CheckIsIdle(const char* call) const {
  if (m_activity != EActivity::None) {
    Refuse(call, kOnlyBetweenTicks);
  }
}

void CRunState::CheckIsIdleAndNotExecuting(const char* call) const {
  if (m_activity != EActivity::None || m_isExecuting) {
    Refuse(call, kOnlyBetweenTicks);
  }
}

void CRunState::CheckAllowsReset() const {
  if (m_activity != EActivity::None && m_activity != EActivity::Hook) {
    Refuse("CSimulator::Reset()", "it is possible between ticks and in PreStep() and PostStep()");
  }
}

void CRunState::CheckIsNotInPhase(const char* call, const char* hint) const {
  if (IsInPhase()) {
    Refuse(call, hint);
  }
}

void CRunState::Refuse(const char* call, const char* hint) const {
  const std::string caller = SRunningCode::OfThread().ToText();
  THROW_ARGOSEXCEPTION((caller.empty() ? "" : caller + ": ")
                       << call << " must not be called while " << Describe(m_activity) << "; "
                       << hint);
}

void CRunState::Defer(std::function<void()> change) {
  const std::string requester = SRunningCode::OfThread().ToText();
  const std::lock_guard<std::mutex> lock(m_mutex);
  m_changes.push_back({CARGoSLog::GetSequence(), requester, std::move(change)});
}

void CRunState::DeferRemoval(const void* entity, std::function<void()> change) {
  const std::string requester = SRunningCode::OfThread().ToText();
  const std::lock_guard<std::mutex> lock(m_mutex);
  const UInt64 place = CARGoSLog::GetSequence();
  if (!m_removals.emplace(std::hash<std::string>()(requester), entity).second) {
    THROW_ARGOSEXCEPTION((requester.empty() ? "" : requester + ": ")
                         << "the removal of an entity is requested twice; it is removed at the end "
                            "of the tick, not at once");
  }
  m_changes.push_back({place, requester, std::move(change)});
}

void CRunState::DeferComponentChange(std::function<void()> change) {
  const std::string requester = SRunningCode::OfThread().ToText();
  const std::lock_guard<std::mutex> lock(m_mutex);
  m_componentChanges.push_back({CARGoSLog::GetSequence(), requester, std::move(change)});
}

bool CRunState::Take(std::vector<SChange>& noted, std::vector<SChange>& changes) {
  const std::lock_guard<std::mutex> lock(m_mutex);
  changes.clear();
  changes.swap(noted);
  if (&noted == &m_changes) {
    m_removals.clear();
  }
  // the requests of one robot have one place, and come from one thread
  std::ranges::stable_sort(changes, {}, &SChange::Place);
  return !changes.empty();
}

// this loop applies what the changes request, too
void CRunState::Apply(std::vector<SChange>& noted) {
  std::vector<SChange> changes;
  while (Take(noted, changes)) {
    for (SChange& change : changes) {
      try {
        change.Apply();
      } catch (...) {
        DiscardChanges();
        if (change.Requester.empty()) {
          throw;
        }
        ThrowWithCause(change.Requester + " requested a change of the space that failed");
      }
    }
  }
}

void CRunState::ApplyChanges() {
  if (m_changes.empty() || DefersChanges()) {
    return;
  }
  const CScope scope(*this, EActivity::Changing);
  Apply(m_changes);
}

void CRunState::ApplyComponentChanges() {
  if (!m_componentChanges.empty()) {
    Apply(m_componentChanges);
  }
}

void CRunState::DiscardChanges() {
  std::vector<SChange> changes;
  Take(m_changes, changes);
  Take(m_componentChanges, changes);
}

}  // namespace argos
