#include <argos3/core/simulator/loading/script_check.h>

#include <argos3/core/simulator/context/load_errors.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/wrappers/lua/lua_controller.h>

#include <string>

namespace argos {

void CheckScripts(CSpace& space, CLoadErrors& errors) {
  for (CControllableEntity* const robot : space.GetControllableEntities()) {
    if (!robot->HasController()) {
      continue;
    }
    const auto* const lua = dynamic_cast<const CLuaController*>(&robot->GetController());
    if (lua == nullptr) {
      continue;
    }
    // equal messages of several robots are one error
    for (const std::string& message : lua->FindMissingFunctions()) {
      errors.Add("", CARGoSException(message));
    }
  }
}

}  // namespace argos
