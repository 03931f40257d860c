#include <argos3/core/utility/configuration/base_configurable_resource.h>

namespace argos {

// defined here so that the core library holds the only type info of the class
CBaseConfigurableResource::~CBaseConfigurableResource() = default;

}  // namespace argos
