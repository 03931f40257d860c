#ifndef ARGOS3_CORE_UTILITY_PLUGINS_FACTORY_H
#define ARGOS3_CORE_UTILITY_PLUGINS_FACTORY_H

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/plugins/process_wide.h>
#include <argos3/core/utility/plugins/registration.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <typeinfo>
#include <vector>

namespace argos {

/**
 * Creates objects of registered classes by label.
 *
 * The whole process has one table per base class TYPE, shared by all libraries.
 *
 * Several threads may register, look up and create objects at the same time, also while libraries
 * are loaded. Only GetTypeMap() requires that nothing is being registered.
 */
template <typename TYPE>
class CFactory {
 public:
  /** Creates an object on the heap; the caller owns it. */
  typedef TYPE* TCreator();

  /** Description of a registered class. */
  struct STypeInfo {
    TCreator* Creator;
    std::string Author;
    std::string Version;
    std::string BriefDescription;
    std::string LongDescription;
    std::string Status;
    /** The library, or the program, that contains the class. */
    std::string Library;
    SRegisteredClass Class = {};
  };

  /** By label, in alphabetical order. */
  typedef std::map<std::string, STypeInfo*> TTypeMap;

  /** The table, with all libraries that have such labels opened. Not thread safe; GetTypes() is. */
  static TTypeMap& GetTypeMap() {
    detail::LoadPluginsOfKind(typeid(TYPE));
    return Types();
  }

  /** Registers a class; replaces an earlier registration of the label. */
  static void Register(const std::string& label, const std::string& author,
                       const std::string& version, const std::string& briefDescription,
                       const std::string& longDescription, const std::string& status,
                       TCreator* creator) {
    // the lock comes later, because this calls the dynamic linker
    const std::string library = GetLibraryOf(reinterpret_cast<const void*>(creator));
    const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
    STypeInfo*& info = Types()[label];
    delete info;
    info =
        new STypeInfo{creator, author, version, briefDescription, longDescription, status, library};
  }

  /**
   * Registers a class unless the label is taken by another class. If the label has the same class
   * already, because two libraries contain its source, this registration replaces the earlier one,
   * unless it comes from a library that is opened late.
   * @return the replaced or, if the classes differ, the kept registration; null if the label was
   *   free.
   */
  static std::unique_ptr<const STypeInfo> RegisterUnlessTaken(const std::string& label,
                                                              const STypeInfo& info) {
    const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
    STypeInfo*& known = Types()[label];
    if (known == nullptr) {
      known = new STypeInfo(info);
      return nullptr;
    }
    auto earlier = std::make_unique<const STypeInfo>(*known);
    if (info.Class == earlier->Class && !detail::IsRegisteringLate()) {
      *known = info;
    }
    return earlier;
  }

  /**
   * Creates an object; the caller owns it.
   * @throws CARGoSException if the label is not registered: the text lists the nearest labels, or
   *   all, and the search paths of libraries.
   */
  static TYPE* New(const std::string& label) {
    TCreator* const creator = FindCreator(label);
    if (creator == nullptr) {
      detail::ThrowUnknownLabel(DemangledName(typeid(TYPE)), label, GetLabels());
    }
    return creator();
  }

  static bool Exists(const std::string& label) { return FindCreator(label) != nullptr; }

  /** All labels, in alphabetical order, also those of libraries that are not open yet. */
  static std::vector<std::string> GetLabels() {
    const detail::CLookUpLock lock;
    std::vector<std::string> labels = detail::ListUnopenedLabels(typeid(TYPE));
    for (const auto& type : Types()) {
      labels.push_back(type.first);
    }
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
    return labels;
  }

  /** A copy of all registrations, by label; opens all libraries that have such labels. */
  static std::map<std::string, STypeInfo> GetTypes() {
    detail::LoadPluginsOfKind(typeid(TYPE));
    const detail::CLookUpLock lock;
    std::map<std::string, STypeInfo> types;
    for (const auto& type : Types()) {
      types.emplace(type.first, *type.second);
    }
    return types;
  }

  /** Lists labels and brief descriptions. */
  static void Print(std::ostream& stream) {
    for (const auto& type : GetTypes()) {
      stream << "   [ " << type.first << " ]\n      " << type.second.BriefDescription << "\n\n";
    }
  }

  /** Removes every registration. Loading a library again does not register its labels again. */
  static void Destroy() {
    const detail::CLookUpLock lock;
    detail::ForgetUnopenedLabels(typeid(TYPE));
    Clear(Types());
  }

 private:
  // the infos are deleted with the map, at the end of the process
  struct SOwner {
    TTypeMap Types;
    SOwner() = default;
    SOwner(const SOwner&) = delete;
    SOwner& operator=(const SOwner&) = delete;
    ~SOwner() { Clear(Types); }
  };

  static TTypeMap& Types() { return detail::GetProcessWide<SOwner>().Types; }

  // null if there is none; may load plug-ins
  static TCreator* FindCreator(const std::string& label) {
    TCreator* const creator = FindRegistered(label);
    if (creator != nullptr) {
      return creator;
    }
    detail::LoadPluginsFor(typeid(TYPE), label);
    return FindRegistered(label);
  }

  static TCreator* FindRegistered(const std::string& label) {
    const detail::CLookUpLock lock;
    const TTypeMap& types = Types();
    const auto type = types.find(label);
    return type == types.end() ? nullptr : type->second->Creator;
  }

  static void Clear(TTypeMap& types) {
    for (auto& type : types) {
      delete type.second;
    }
    types.clear();
  }
};

/**
 * Registers a class on behalf of a REGISTER_* macro.
 *
 * A class from a library with another build id, or with a label that another class has registered,
 * is rejected; the problem is recorded, and CDynamicLoading::LoadLibrary() throws it. A class that
 * is registered again, by a second library that contains its source, replaces the first
 * registration; LoadLibrary() warns of it, and of a class whose name a class of another library
 * has.
 *
 * @param buildId  ARGOS_BUILD_ID when the library was compiled.
 * @param registered  type and size of the class.
 */
template <typename TYPE>
void RegisterSymbol(const std::string& buildId, const std::string& label, const std::string& author,
                    const std::string& version, const std::string& briefDescription,
                    const std::string& longDescription, const std::string& status,
                    typename CFactory<TYPE>::TCreator* creator,
                    const SRegisteredClass& registered) {
  const std::string library = GetLibraryOf(reinterpret_cast<const void*>(creator));
  if (RecordIfBuildDiffers(buildId, library)) {
    return;
  }
  detail::NoteRegistration(typeid(TYPE), label, library);
  const auto other = CFactory<TYPE>::RegisterUnlessTaken(
      label,
      {creator, author, version, briefDescription, longDescription, status, library, registered});
  if (other != nullptr) {
    const SRegistration known{other->Library, other->Class};
    const SRegistration added{library, registered};
    const bool isLate = detail::IsRegisteringLate();
    RecordDuplicateLabel(label, DemangledName(typeid(TYPE)), isLate ? added : known,
                         isLate ? known : added);
  } else {
    RecordIfOfOtherLibrary(label, {library, registered});
  }
}

/** Runs a registration in its constructor; REGISTER_* macros define one such object. */
class CSymbolRegistrar {
 public:
  template <typename FUNCTION>
  explicit CSymbolRegistrar(FUNCTION registration) {
    registration();
  }
};

}  // namespace argos

#define ARGOS_JOIN_EXPANDED_(A, B) A##B
#define ARGOS_JOIN_(A, B) ARGOS_JOIN_EXPANDED_(A, B)

/**
 * Registers a class with the factory of its base when the library that contains this line is
 * loaded. Use it at global scope or inside namespace argos, with or without a semicolon; "argos::"
 * may be omitted from the class and its base. The class needs a default constructor.
 *
 * @param BASECLASS  the factory's base class.
 * @param LABEL      string literal: the name in experiment files. The other texts are shown by
 *   "argos3 -q".
 */
// the creator is a lambda, not a template, so it is local to its library even if another library
// has a class of the same name
#define REGISTER_SYMBOL(BASECLASS, CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION,        \
                        LONG_DESCRIPTION, STATUS)                                               \
  [[maybe_unused]] static const ::argos::CSymbolRegistrar ARGOS_JOIN_(argosRegistrar_,          \
                                                                      __COUNTER__)([] {         \
    using namespace ::argos;                                                                    \
    ::argos::RegisterSymbol<BASECLASS>(                                                         \
        ARGOS_BUILD_ID, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, LONG_DESCRIPTION, STATUS,    \
        []() -> BASECLASS* { return new CLASSNAME; }, {&typeid(CLASSNAME), sizeof(CLASSNAME)}); \
  });

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/datatypes/standard_headers.h>
#include <argos3/core/utility/plugins/factory_impl.h>
#endif

#endif
