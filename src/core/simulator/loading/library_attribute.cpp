#include <argos3/core/simulator/loading/library_attribute.h>

#include <argos3/core/utility/plugins/dynamic_loading.h>

namespace argos {

void LoadLibraryOf(TConfigurationNode& node) {
  if (NodeAttributeExists(node, "library")) {
    std::string library;
    GetNodeAttribute(node, "library", library);
    CDynamicLoading::LoadLibrary(library);
  }
}

}  // namespace argos
