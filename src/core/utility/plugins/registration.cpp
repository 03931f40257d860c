#include <argos3/core/utility/plugins/registration.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/plugins/process_wide.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <dlfcn.h>

#include <algorithm>

namespace argos {

namespace {

std::vector<std::string>& Problems() {
  // function-local, because registrations happen in static initialisers, possibly before this
  // file's
  static std::vector<std::string> problems;
  return problems;
}

void RecordOnce(const std::string& problem) {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
  std::vector<std::string>& problems = Problems();
  if (std::find(problems.begin(), problems.end(), problem) == problems.end()) {
    problems.push_back(problem);
  }
}

// the pairs of an id that are missing in the other
std::string Difference(const std::string& id, const std::string& other) {
  std::vector<std::string> pairs;
  std::vector<std::string> otherPairs;
  Tokenize(id, pairs, ";");
  Tokenize(other, otherPairs, ";");
  std::string difference;
  for (const std::string& pair : pairs) {
    if (std::find(otherPairs.begin(), otherPairs.end(), pair) == otherPairs.end()) {
      difference += (difference.empty() ? "" : ", ") + pair;
    }
  }
  return difference.empty() ? "nothing more" : difference;
}

}  // namespace

const char* GetCoreBuildId() {
  static const std::string id = ARGOS_BUILD_ID;
  return id.c_str();
}

std::string GetLibraryOf(const void* function) {
  Dl_info info;
  if (dladdr(function, &info) == 0 || info.dli_fname == nullptr) {
    return "(unknown)";
  }
  return info.dli_fname;
}

bool RecordIfBuildDiffers(const std::string& buildId, const std::string& library) {
  if (buildId == GetCoreBuildId()) {
    return false;
  }
  RecordOnce(
      "\"" + library + "\" was built against another version or with other options: it has " +
      Difference(buildId, GetCoreBuildId()) + ", the core has " +
      Difference(GetCoreBuildId(), buildId) + "; rebuild it against the headers of this core");
  return true;
}

void RecordDuplicateLabel(const std::string& label, const std::string& kind,
                          const std::string& firstLibrary, const std::string& secondLibrary) {
  if (firstLibrary == secondLibrary) {
    RecordOnce("label \"" + label + "\" of " + kind + " is registered twice by \"" + firstLibrary +
               "\"; labels must differ");
  } else {
    RecordOnce("label \"" + label + "\" of " + kind + " is registered by \"" + firstLibrary +
               "\" and by \"" + secondLibrary + "\"; load only one of them, or rename one label");
  }
}

void ThrowRegistrationProblems(const std::string& context) {
  std::vector<std::string> problems;
  {
    const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
    problems.swap(Problems());
  }
  if (problems.empty()) {
    return;
  }
  std::string text = context;
  for (const std::string& problem : problems) {
    text += "\n  " + problem;
  }
  throw CARGoSException(text);
}

namespace detail {

void ThrowUnknownLabel(const std::string& kind, const std::string& label,
                       const std::vector<std::string>& registered) {
  std::string paths;
  for (const std::string& path : GetPluginSearchPaths()) {
    paths += (paths.empty() ? "" : ", ") + path;
  }
  std::string all;
  for (const std::string& name : registered) {
    all += (all.empty() ? "" : ", ") + name;
  }
  const std::string near = NearestNames(label, registered);
  THROW_ARGOSEXCEPTION("No " << kind << " is registered under the label \"" << label << '"'
                             << (near.empty() ? "" : DidYouMean(label, registered))
                             << "; registered: " << (all.empty() ? "none" : all)
                             << "; libraries are searched in: " << paths);
}

}  // namespace detail

}  // namespace argos
