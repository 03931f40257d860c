#include <argos3/core/utility/plugins/registered_labels.h>

#include <argos3/core/utility/plugins/process_wide.h>
#include <argos3/core/utility/plugins/registration.h>

#include <mutex>

namespace argos {

namespace {

// guarded by the mutex of registrations
std::map<SPluginLabel, std::string>& Labels() {
  static std::map<SPluginLabel, std::string> labels;
  return labels;
}

thread_local bool isRegisteringLate = false;

}  // namespace

const std::map<SPluginLabel, std::string>& GetRegisteredLabels() {
  return Labels();
}

std::vector<SPluginLabel> ListLabelsOf(const std::string& libraryName) {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
  std::vector<SPluginLabel> labels;
  for (const auto& [label, library] : Labels()) {
    if (library.substr(library.rfind('/') + 1) == libraryName) {
      labels.push_back(label);
    }
  }
  return labels;
}

CLateRegistrations::CLateRegistrations() : m_wasLate(isRegisteringLate) {
  isRegisteringLate = true;
}

CLateRegistrations::~CLateRegistrations() {
  isRegisteringLate = m_wasLate;
}

void detail::NoteRegistration(const std::type_info& kind, const std::string& label,
                              const std::string& library) {
  const std::lock_guard<std::recursive_mutex> lock(GetRegistrationMutex());
  Labels()[{kind.name(), label}] = library;
}

bool detail::IsRegisteringLate() {
  return isRegisteringLate;
}

}  // namespace argos
