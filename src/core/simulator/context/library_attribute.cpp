#include <argos3/core/simulator/context/library_attribute.h>

#include <argos3/core/utility/plugins/dynamic_loading.h>

namespace argos {

void LoadLibraryOf(TConfigurationNode& node) {
  if (!NodeAttributeExists(node, "library")) {
    return;
  }
  std::string library;
  GetNodeAttribute(node, "library", library);
  try {
    CDynamicLoading::LoadLibrary(library, node.GetFileName());
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(
        node.GetLocation() << ": <" << node.Value() << ">: attribute \"library\"", error);
  }
}

}  // namespace argos
