#include <argos3/core/utility/plugins/registration.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/plugins/process_wide.h>
#include <argos3/core/utility/plugins/registered_labels.h>
#include <argos3/core/utility/plugins/unknown_label.h>
#include <argos3/core/utility/text/lists.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <dlfcn.h>

// the macro exists since glibc 2.35
#ifdef DLFO_STRUCT_HAS_EH_DBASE
#define ARGOS_HAS_DL_FIND_OBJECT
#endif
#ifdef __GLIBC__
#include <link.h>
#endif

#include <algorithm>
#include <cstring>
#include <map>
#include <utility>

namespace argos {

namespace {

struct SRecords {
  std::vector<std::string> Problems;
  std::vector<std::string> Warnings;
  std::vector<SRegisteredClass> Classes;  // classes of all libraries
};

SRecords& Records() {
  // function-local, because registrations happen in static initialisers, possibly before this
  // file's
  static SRecords records;
  return records;
}

void RecordOnce(std::vector<std::string> SRecords::*list, const std::string& text) {
  const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
  std::vector<std::string>& texts = Records().*list;
  if (std::find(texts.begin(), texts.end(), text) == texts.end()) {
    texts.push_back(text);
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
      AppendItem(difference, pair);
    }
  }
  return difference.empty() ? "nothing more" : difference;
}

// users name the classes of a base class so
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

// Programs have copies of data of libraries that they refer to, such as tables of virtual
// functions.
bool IsInProgram([[maybe_unused]] const void* address) {
#ifdef __GLIBC__
  Dl_info info;
  link_map* map = nullptr;
  return dladdr1(address, &info, reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP) != 0 &&
         map != nullptr && map->l_name[0] == '\0';
#else
  return false;
#endif
}

// The library whose class the dynamic linker has chosen in place of one of the same name in the
// given library, by their virtual functions; "" if it has not.
std::string FindReplacement(const std::type_info& type, const std::string& library) {
  // nearly all classes need no look-up by name
  if (GetLibraryOf(&type) == library) {
    return "";
  }
  // it is loaded
  void* const handle = dlopen(library.c_str(), RTLD_LAZY | RTLD_NOLOAD);
  if (handle == nullptr) {
    return "";
  }
  const std::string functions = std::string("_ZTV") + type.name();
  const void* const own = dlsym(handle, functions.c_str());
  const void* const chosen = dlsym(RTLD_DEFAULT, functions.c_str());
  const bool isReplaced = own != nullptr && chosen != nullptr && own != chosen &&
                          GetLibraryOf(own) == library && !IsInProgram(chosen);
  return isReplaced ? GetLibraryOf(chosen) : "";
}

std::string NameOf(const SRegisteredClass& registered) {
  return registered.Type == nullptr ? "(unknown)" : DemangledName(*registered.Type);
}

}  // namespace

const char* GetCoreBuildId() {
  static const std::string id = ARGOS_BUILD_ID;
  return id.c_str();
}

std::string GetLibraryOf(const void* address) {
#ifdef ARGOS_HAS_DL_FIND_OBJECT
  // dladdr() also searches the nearest symbol: for all registrations, half a millisecond of a start
  dl_find_object object;
  if (_dl_find_object(const_cast<void*>(address), &object) == 0 &&
      object.dlfo_link_map->l_name[0] != '\0') {
    return object.dlfo_link_map->l_name;
  }
#endif
  Dl_info info;
  if (dladdr(address, &info) == 0 || info.dli_fname == nullptr) {
    return "(unknown)";
  }
  return info.dli_fname;
}

bool RecordIfBuildDiffers(const std::string& buildId, const std::string& library) {
  if (buildId == GetCoreBuildId()) {
    return false;
  }
  RecordOnce(
      &SRecords::Problems,
      "\"" + library + "\" was built against another version or with other options: it has " +
          Difference(buildId, GetCoreBuildId()) + ", the core has " +
          Difference(GetCoreBuildId(), buildId) + "; rebuild it against the headers of this core");
  return true;
}

bool SRegisteredClass::operator==(const SRegisteredClass& other) const {
  return Type != nullptr && other.Type != nullptr && Size == other.Size &&
         std::strcmp(Type->name(), other.Type->name()) == 0;
}

void RecordDuplicateLabel(const std::string& label, const std::string& kind,
                          const SRegistration& first, const SRegistration& second) {
  const std::string text = "label \"" + label + "\" of " + kind + " is registered " +
                           (first.Library == second.Library
                                ? "twice by \"" + first.Library + '"'
                                : "by \"" + first.Library + "\" and by \"" + second.Library + '"');
  const std::string firstName = NameOf(first.Class);
  const std::string secondName = NameOf(second.Class);
  if (first.Class == second.Class) {
    RecordOnce(&SRecords::Warnings,
               "The " + text + ", with the same class " + secondName +
                   ": the last one counts. Compile its source into one library, with which the "
                   "others are linked");
  } else if (firstName == secondName) {
    RecordOnce(&SRecords::Problems, text + ", with two versions of the class " + secondName +
                                        "; build both from the same sources");
  } else {
    RecordOnce(&SRecords::Problems, text + ", with the classes " + firstName + " and " +
                                        secondName +
                                        "; load only one of them, or rename one label");
  }
}

void RecordIfOfOtherLibrary(const std::string& label, const SRegistration& registration) {
  const SRegisteredClass& registered = registration.Class;
  // calls the dynamic linker, so before the lock
  const std::string replacement =
      registered.Type == nullptr ? "" : FindReplacement(*registered.Type, registration.Library);
  SRegisteredClass first;
  {
    const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
    std::vector<SRegisteredClass>& classes = Records().Classes;
    const auto known = std::ranges::find(classes, registered.Type, &SRegisteredClass::Type);
    if (known != classes.end()) {
      first = *known;
    }
    classes.push_back(registered);
  }
  if (replacement.empty()) {
    return;
  }
  std::string text = "the class " + NameOf(registered) + " of label \"" + label + "\" in \"" +
                     registration.Library + "\" has the name of a class in \"" + replacement +
                     "\", whose functions the dynamic linker gives it";
  const char* const wayOut = ". Rename one, or put it into a namespace";
  if (first.Type != nullptr && first.Size != registered.Size) {
    RecordOnce(&SRecords::Problems, text + wayOut);
  } else {
    text.front() = 'T';
    RecordOnce(&SRecords::Warnings, text + wayOut + ", unless both are the same");
  }
}

void ThrowRegistrationProblems(const std::string& context) {
  SRecords records;
  {
    const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
    records.Problems.swap(Records().Problems);
    records.Warnings.swap(Records().Warnings);
  }
  for (const std::string& warning : records.Warnings) {
    LOGERR << "[WARNING] " << warning << std::endl;
  }
  const std::vector<std::string>& problems = records.Problems;
  if (problems.empty()) {
    return;
  }
  std::string text = context;
  for (const std::string& problem : problems) {
    text += "\n  " + problem;
  }
  throw CARGoSException(text);
}

namespace {

thread_local std::string g_namedLibrary;  // see NoteNamedLibrary()

std::string DescribeNamedLibrary() {
  const std::string name = g_namedLibrary.substr(g_namedLibrary.rfind('/') + 1);
  std::string labels;
  for (const SPluginLabel& label : ListLabelsOf(name)) {
    AppendItem(labels, label.Label);
  }
  return "\n\"" + name + "\" is loaded and registers " +
         (labels.empty() ? "nothing: is a REGISTER_ macro missing in its sources?" : labels);
}

}  // namespace

void NoteNamedLibrary(const std::string& path) {
  g_namedLibrary = path;
}

std::string DescribeUnknownLabel(const std::string& label,
                                 const std::vector<std::string>& registered) {
  if (!g_namedLibrary.empty()) {
    return DidYouMean(label, registered) + DescribeNamedLibrary();
  }
  return DidYouMean(label, registered) +
         "\nIf a library of yours has it: name the library, with library=\"PATH\" in this element, "
         "or put its folder into ARGOS_PLUGIN_PATH; searched in: " +
         JoinItems(GetPluginSearchPaths());
}

namespace detail {

void ThrowUnknownLabel(const std::string& kind, const std::string& label,
                       const std::vector<std::string>& registered) {
  THROW_ARGOSEXCEPTION("there is no " << NameOfKind(kind) << " \"" << label << '"'
                                      << DescribeUnknownLabel(label, registered));
}

}  // namespace detail

}  // namespace argos
