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

std::map<std::string, SPluginText>& GetElementTexts() {
  static std::map<std::string, SPluginText> texts;
  return texts;
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

CElementText::CElementText(const std::string& tag, const std::string& author,
                           const std::string& brief, const std::string& manual) {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
  GetElementTexts()[tag] = {tag, author, "1.0", brief, manual, "Usable", GetLibraryOf(this)};
}

std::vector<SPluginText> CElementText::GetAll() {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
  std::vector<SPluginText> texts;
  for (const auto& [tag, text] : GetElementTexts()) {
    texts.push_back(text);
  }
  return texts;
}

}  // namespace argos
