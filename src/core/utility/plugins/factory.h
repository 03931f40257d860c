#ifndef ARGOS3_CORE_UTILITY_PLUGINS_FACTORY_H
#define ARGOS3_CORE_UTILITY_PLUGINS_FACTORY_H

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/plugins/process_wide.h>
#include <argos3/core/utility/plugins/registration.h>
#include <argos3/core/utility/string_utilities.h>

#include <iostream>
#include <map>
#include <string>
#include <typeinfo>
#include <vector>

namespace argos {

/**
 * Makes objects of classes that the core does not know, by label.
 *
 * There is one table per base class TYPE in the whole process, whichever libraries use it. Not
 * thread safe: labels are registered while libraries load, which one thread does.
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

  static TTypeMap& GetTypeMap() { return detail::GetProcessWide<SOwner>().Types; }

  /** Registers a class; a class registered before under this label is forgotten. */
  static void Register(const std::string& label, const std::string& author,
                       const std::string& version, const std::string& briefDescription,
                       const std::string& longDescription, const std::string& status,
                       TCreator* creator) {
    STypeInfo*& info = GetTypeMap()[label];
    delete info;
    info = new STypeInfo{creator,
                         author,
                         version,
                         briefDescription,
                         longDescription,
                         status,
                         GetLibraryOf(reinterpret_cast<const void*>(creator))};
  }

  /**
   * Makes an object; the caller owns it.
   * @throws CARGoSException if nothing is registered under this label: the text lists the nearest
   *         labels, or all, and where libraries are looked for.
   */
  static TYPE* New(const std::string& label) {
    TTypeMap& types = GetTypeMap();
    const auto type = types.find(label);
    if (type == types.end()) {
      std::vector<std::string> labels;
      for (const auto& known : types) {
        labels.push_back(known.first);
      }
      detail::ThrowUnknownLabel(DemangledName(typeid(TYPE)), label, labels);
    }
    return type->second->Creator();
  }

  static bool Exists(const std::string& label) { return GetTypeMap().count(label) > 0; }

  /** Lists labels and brief descriptions. */
  static void Print(std::ostream& stream) {
    for (const auto& type : GetTypeMap()) {
      stream << "   [ " << type.first << " ]\n      " << type.second->BriefDescription << "\n\n";
    }
  }

  /** Forgets every registration. Loading a library again does not bring its labels back. */
  static void Destroy() { Clear(GetTypeMap()); }

 private:
  // the infos die with the map, at the end of the process
  struct SOwner {
    TTypeMap Types;
    SOwner() = default;
    SOwner(const SOwner&) = delete;
    SOwner& operator=(const SOwner&) = delete;
    ~SOwner() { Clear(Types); }
  };

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
void RegisterSymbol(const char* buildId, const std::string& label, const std::string& author,
                    const std::string& version, const std::string& briefDescription,
                    const std::string& longDescription, const std::string& status,
                    typename CFactory<TYPE>::TCreator* creator) {
  const std::string library = GetLibraryOf(reinterpret_cast<const void*>(creator));
  if (RecordIfBuildDiffers(buildId, library)) {
    return;
  }
  const auto& types = CFactory<TYPE>::GetTypeMap();
  const auto previous = types.find(label);
  if (previous != types.end()) {
    RecordDuplicateLabel(label, DemangledName(typeid(TYPE)), previous->second->Library, library);
    return;
  }
  CFactory<TYPE>::Register(label, author, version, briefDescription, longDescription, status,
                           creator);
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
