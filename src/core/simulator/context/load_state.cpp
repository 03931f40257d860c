#include <argos3/core/simulator/context/load_state.h>

#include <argos3/core/utility/text/string_utilities.h>

namespace argos {

void CLoadState::Begin() {
  *this = CLoadState();
  m_loading = true;
}

void CLoadState::AddController(const std::string& id, TConfigurationNode& node) {
  const auto [other, inserted] =
      m_controllers.emplace(id, SControllerSetup{id, &node, std::nullopt, false});
  if (!inserted) {
    THROW_ARGOSEXCEPTION(node.GetLocation()
                         << ": there is already a controller with id \"" << id << "\" at "
                         << other->second.Node->GetLocation() << "; ids must be unique");
  }
  const std::optional<EOnError> own = ReadOnError(node);
  other->second.OnError = own ? own : m_onError;
}

const SControllerSetup& CLoadState::GetSetup(const std::string& id) const {
  ThrowIfBroken(id);
  const auto found = m_controllers.find(id);
  if (found == m_controllers.end()) {
    std::vector<std::string> known;
    for (const auto& entry : m_controllers) {
      known.push_back(entry.first);
    }
    THROW_ARGOSEXCEPTION("there is no controller with id \"" << id << "\" in <controllers>"
                                                             << DidYouMean(id, known));
  }
  return found->second;
}

std::vector<const SControllerSetup*> CLoadState::ListUnusedControllers() const {
  std::vector<const SControllerSetup*> unused;
  for (const auto& [id, setup] : m_controllers) {
    if (!setup.IsUsed) {
      unused.push_back(&setup);
    }
  }
  return unused;
}

void CLoadState::MarkBroken(const std::string& id) {
  if (m_loading) {
    m_broken.insert(id);
  }
}

void CLoadState::ThrowIfBroken(const std::string& id) const {
  if (m_broken.count(id) > 0) {
    throw CAlreadyReported("\"" + id + "\" could not be loaded");
  }
}

void CLoadState::CheckWhenLoaded(std::function<void()> check) {
  if (m_loading) {
    m_checks.push_back(std::move(check));
  } else {
    check();
  }
}

void CLoadState::RunChecks(CLoadErrors& errors) {
  for (const std::function<void()>& check : m_checks) {
    errors.Try("", check);
  }
  m_checks.clear();
}

}  // namespace argos
