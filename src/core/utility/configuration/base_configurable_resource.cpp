#include <argos3/core/utility/configuration/base_configurable_resource.h>

namespace argos {

// defined here so that the class has one type identity, in the core library
CBaseConfigurableResource::~CBaseConfigurableResource() = default;

}  // namespace argos
