#include <argos3/core/utility/plugins/registration.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/plugins/process_wide.h>
#include <argos3/core/utility/plugins/unknown_label.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <dlfcn.h>

#include <algorithm>
#include <map>

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

// what users call the classes of a base class
std::string NameOfKind(const std::string& baseClass) {
  static const std::map<std::string, std::string> names = {
      {"CCI_Controller", "controller"},
      {"CEntity", "entity"},
      {"CLoopFunctions", "class of loop functions"},
      {"CMedium", "medium"},
      {"CPhysicsEngine", "physics engine"},
      {"CRunOutput", "output"},
      {"CSimulatedActuator", "actuator"},
      {"CSimulatedSensor", "sensor"},
      {"CVisualization", "visualization"}};
  const auto name = names.find(baseClass);
  return name == names.end() ? baseClass : name->second;
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

std::string DescribeUnknownLabel(const std::string& label,
                                 const std::vector<std::string>& registered) {
  std::string folders;
  for (const std::string& folder : GetPluginSearchPaths()) {
    folders += (folders.empty() ? "" : ", ") + folder;
  }
  return DidYouMean(label, registered) +
         "\nIf a library of yours has it: name the library, with library=\"PATH\" in this element, "
         "or put its folder into ARGOS_PLUGIN_PATH; searched in: " +
         folders;
}

namespace detail {

void ThrowUnknownLabel(const std::string& kind, const std::string& label,
                       const std::vector<std::string>& registered) {
  THROW_ARGOSEXCEPTION("there is no " << NameOfKind(kind) << " \"" << label << '"'
                                      << DescribeUnknownLabel(label, registered));
}

}  // namespace detail

}  // namespace argos
