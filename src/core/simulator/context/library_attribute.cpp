#include <argos3/core/simulator/context/library_attribute.h>

#include <argos3/core/utility/plugins/dynamic_loading.h>
#include <argos3/core/utility/plugins/unknown_label.h>

#include <dlfcn.h>
#include <link.h>

namespace argos {

namespace {

// empty of the program itself
std::string GetPath(CDynamicLoading::TDLHandle library) {
  link_map* map = nullptr;
  return dlinfo(library, RTLD_DI_LINKMAP, &map) == 0 && map != nullptr ? map->l_name : "";
}

}  // namespace

void LoadLibraryOf(TConfigurationNode& node) {
  NoteNamedLibrary("");
  if (!NodeAttributeExists(node, "library")) {
    return;
  }
  std::string library;
  GetNodeAttribute(node, "library", library);
  try {
    NoteNamedLibrary(GetPath(CDynamicLoading::LoadLibrary(library, node.GetFileName())));
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(
        node.GetLocation() << ": <" << node.Value() << ">: attribute \"library\"", error);
  }
}

}  // namespace argos
