#include <argos3/core/utility/plugins/plugin_kind.h>

#include <argos3/core/utility/plugins/process_wide.h>

#include <mutex>

namespace argos {

namespace {

// guarded by the mutex of registrations
std::map<std::string, CPluginKind::SKind>& GetKinds() {
  static std::map<std::string, CPluginKind::SKind> kinds;
  return kinds;
}

}  // namespace

CPluginKind::CPluginKind(const std::string& word, const std::string& of, const std::string& header,
                         TList* list) {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
  GetKinds()[word] = {of, header, list};
}

std::map<std::string, CPluginKind::SKind> CPluginKind::GetAll() {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
  return GetKinds();
}

}  // namespace argos
