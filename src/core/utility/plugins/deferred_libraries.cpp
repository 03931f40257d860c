#include <argos3/core/utility/plugins/deferred_libraries.h>

#include <argos3/core/utility/plugins/process_wide.h>
#include <argos3/core/utility/plugins/registered_labels.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>

namespace argos {

namespace {

struct SDeferredLibrary {
  std::string Path;
  std::vector<SPluginLabel> Labels;
};

// has the order of Add(); guarded by the mutex of registrations
std::vector<SDeferredLibrary>& Libraries() {
  static std::vector<SDeferredLibrary> libraries;
  return libraries;
}

std::string FileName(const std::string& path) {
  return path.substr(path.rfind('/') + 1);
}

// removes the libraries that fulfil a condition, @return their paths
template <typename CONDITION>
std::vector<std::string> TakeIf(const CONDITION& condition) {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
  std::vector<SDeferredLibrary>& libraries = Libraries();
  std::vector<std::string> taken;
  for (const SDeferredLibrary& library : libraries) {
    if (condition(library)) {
      taken.push_back(library.Path);
    }
  }
  std::erase_if(libraries, condition);
  return taken;
}

// the same for libraries with a label that fulfils a condition
template <typename CONDITION>
std::vector<std::string> TakeIfAnyLabel(const CONDITION& condition) {
  return TakeIf([&condition](const SDeferredLibrary& library) {
    return std::any_of(library.Labels.begin(), library.Labels.end(), condition);
  });
}

// tells if a library with another file name has registered one of the labels
bool IsContested(const SDeferredLibrary& library) {
  const std::map<SPluginLabel, std::string>& registered = GetRegisteredLabels();
  return std::any_of(library.Labels.begin(), library.Labels.end(), [&](const SPluginLabel& label) {
    const auto found = registered.find(label);
    return found != registered.end() && FileName(found->second) != FileName(library.Path);
  });
}

}  // namespace

bool CDeferredLibraries::Add(const std::string& path) {
  std::optional<std::vector<SPluginLabel>> labels = ReadLabelIndex(path);
  if (!labels) {
    return false;
  }
  const SDeferredLibrary added{path, std::move(*labels)};
  const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
  if (IsContested(added)) {
    return false;
  }
  std::vector<SDeferredLibrary>& libraries = Libraries();
  if (std::ranges::find(libraries, path, &SDeferredLibrary::Path) == libraries.end()) {
    libraries.push_back(added);
  }
  return true;
}

std::vector<std::string> CDeferredLibraries::Take(const std::type_info& kind,
                                                  const std::string& label) {
  return TakeIfAnyLabel(
      [&](const SPluginLabel& other) { return other.Label == label && other.Kind == kind.name(); });
}

std::vector<std::string> CDeferredLibraries::TakeKind(const std::type_info& kind) {
  return TakeIfAnyLabel([&kind](const SPluginLabel& label) { return label.Kind == kind.name(); });
}

std::vector<std::string> CDeferredLibraries::TakeLabels(const std::set<std::string>& labels) {
  return TakeIfAnyLabel(
      [&labels](const SPluginLabel& label) { return labels.count(label.Label) > 0; });
}

std::vector<std::string> CDeferredLibraries::TakeFile(const std::string& name) {
  return TakeIf(
      [&name](const SDeferredLibrary& library) { return FileName(library.Path) == name; });
}

std::string CDeferredLibraries::TakeFirst() {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
  std::vector<SDeferredLibrary>& libraries = Libraries();
  if (libraries.empty()) {
    return "";
  }
  std::string path = libraries.front().Path;
  libraries.erase(libraries.begin());
  return path;
}

std::vector<std::string> CDeferredLibraries::TakeAll() {
  return TakeIf([](const SDeferredLibrary&) { return true; });
}

std::vector<std::string> CDeferredLibraries::TakeContested() {
  return TakeIf(&IsContested);
}

std::vector<std::string> CDeferredLibraries::ListLabels(const std::type_info& kind) {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
  std::vector<std::string> labels;
  for (const SDeferredLibrary& library : Libraries()) {
    for (const SPluginLabel& label : library.Labels) {
      if (label.Kind == kind.name()) {
        labels.push_back(label.Label);
      }
    }
  }
  return labels;
}

void CDeferredLibraries::Forget(const std::type_info& kind) {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
  for (SDeferredLibrary& library : Libraries()) {
    std::erase_if(library.Labels,
                  [&kind](const SPluginLabel& label) { return label.Kind == kind.name(); });
  }
}

}  // namespace argos
