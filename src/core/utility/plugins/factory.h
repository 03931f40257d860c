#ifndef ARGOS3_CORE_UTILITY_PLUGINS_FACTORY_H
#define ARGOS3_CORE_UTILITY_PLUGINS_FACTORY_H

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/plugins/process_wide.h>
#include <argos3/core/utility/plugins/registration.h>
#include <argos3/core/utility/string_utilities.h>

#include <iostream>
#include <map>
#include <mutex>
#include <string>
#include <typeinfo>
#include <vector>

namespace argos {

/**
 * Makes objects of classes that the core does not know, by label.
 *
 * There is one table per base class TYPE in the whole process, whichever libraries use it.
 *
 * Several threads may register, look up and make objects at the same time, and load libraries
 * meanwhile. Only the table itself, GetTypeMap(), is for a time when nothing is registered.
 */
template <typename TYPE>
class CFactory {
 public:
  /** Makes an object on the heap; the caller owns it. */
  typedef TYPE* TCreator();

  /** What is known of a registered class. */
  struct STypeInfo {
    TCreator* Creator;
    std::string Author;
    std::string Version;
    std::string BriefDescription;
    std::string LongDescription;
    std::string Status;
    /** The library, or the program, that the class comes from. */
    std::string Library;
  };

  /** By label, in alphabetical order. */
  typedef std::map<std::string, STypeInfo*> TTypeMap;

  /** The table. Not thread safe; GetTypes() is. */
  static TTypeMap& GetTypeMap() { return detail::GetProcessWide<SOwner>().Types; }

  /** Registers a class; a class registered before under this label is forgotten. */
  static void Register(const std::string& label, const std::string& author,
                       const std::string& version, const std::string& briefDescription,
                       const std::string& longDescription, const std::string& status,
                       TCreator* creator) {
    // before the lock: it asks the dynamic linker
    const std::string library = GetLibraryOf(reinterpret_cast<const void*>(creator));
    const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
    STypeInfo*& info = GetTypeMap()[label];
    delete info;
    info =
        new STypeInfo{creator, author, version, briefDescription, longDescription, status, library};
  }

  /**
   * Registers a class unless the label is taken.
   * @return the library that has the label already, or "" if the class was registered.
   */
  static std::string RegisterIfFree(const std::string& label, const STypeInfo& info) {
    const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
    STypeInfo*& known = GetTypeMap()[label];
    if (known != nullptr) {
      return known->Library;
    }
    known = new STypeInfo(info);
    return "";
  }

  /**
   * Makes an object; the caller owns it.
   * @throws CARGoSException if nothing is registered under this label: the text lists the nearest
   *         labels, or all, and where libraries are looked for.
   */
  static TYPE* New(const std::string& label) {
    TCreator* const creator = FindCreator(label);
    if (creator == nullptr) {
      detail::ThrowUnknownLabel(DemangledName(typeid(TYPE)), label, GetLabels());
    }
    return creator();
  }

  static bool Exists(const std::string& label) { return FindCreator(label) != nullptr; }

  /** All labels, in alphabetical order. */
  static std::vector<std::string> GetLabels() {
    const detail::CLookUpLock lock;
    std::vector<std::string> labels;
    for (const auto& type : GetTypeMap()) {
      labels.push_back(type.first);
    }
    return labels;
  }

  /** What is registered now, by label: a copy. */
  static std::map<std::string, STypeInfo> GetTypes() {
    const detail::CLookUpLock lock;
    std::map<std::string, STypeInfo> types;
    for (const auto& type : GetTypeMap()) {
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

  /** Forgets every registration. Loading a library again does not bring its labels back. */
  static void Destroy() {
    const detail::CLookUpLock lock;
    Clear(GetTypeMap());
  }

 private:
  // the infos die with the map, at the end of the process
  struct SOwner {
    TTypeMap Types;
    SOwner() = default;
    SOwner(const SOwner&) = delete;
    SOwner& operator=(const SOwner&) = delete;
    ~SOwner() { Clear(Types); }
  };

  // null if there is none
  static TCreator* FindCreator(const std::string& label) {
    const detail::CLookUpLock lock;
    const TTypeMap& types = GetTypeMap();
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
 * A class from a library whose build id differs, or whose label another registration holds already,
 * is not registered; that is recorded, and CDynamicLoading::LoadLibrary() throws it.
 *
 * @param buildId  ARGOS_BUILD_ID, as the library was compiled with.
 */
template <typename TYPE>
void RegisterSymbol(const std::string& buildId, const std::string& label, const std::string& author,
                    const std::string& version, const std::string& briefDescription,
                    const std::string& longDescription, const std::string& status,
                    typename CFactory<TYPE>::TCreator* creator) {
  const std::string library = GetLibraryOf(reinterpret_cast<const void*>(creator));
  if (RecordIfBuildDiffers(buildId, library)) {
    return;
  }
  const std::string holder = CFactory<TYPE>::RegisterIfFree(
      label, {creator, author, version, briefDescription, longDescription, status, library});
  if (!holder.empty()) {
    RecordDuplicateLabel(label, DemangledName(typeid(TYPE)), holder, library);
  }
}

/** Runs a registration when it is constructed: what a REGISTER_* macro makes one of. */
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
 * Registers a class with the factory of its base when the library that holds this line is loaded.
 * Stands at global scope or inside namespace argos, with or without a semicolon; the class and its
 * base may be named without "argos::". The class needs a constructor without arguments.
 *
 * @param BASECLASS  the factory's base class.
 * @param LABEL      string literal: the name in experiment files. The other texts are for "argos3
 * -q".
 */
// the creator is a lambda, not a template: so it is local to its library, even if another library
// has a class of the same name
#define REGISTER_SYMBOL(BASECLASS, CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION,          \
                        LONG_DESCRIPTION, STATUS)                                                 \
  [[maybe_unused]] static const ::argos::CSymbolRegistrar ARGOS_JOIN_(argosRegistrar_,            \
                                                                      __COUNTER__)([] {           \
    using namespace ::argos;                                                                      \
    ::argos::RegisterSymbol<BASECLASS>(ARGOS_BUILD_ID, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, \
                                       LONG_DESCRIPTION, STATUS,                                  \
                                       []() -> BASECLASS* { return new CLASSNAME; });             \
  });

#endif
