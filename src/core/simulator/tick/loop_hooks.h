#ifndef ARGOS3_CORE_SIMULATOR_TICK_LOOP_HOOKS_H
#define ARGOS3_CORE_SIMULATOR_TICK_LOOP_HOOKS_H

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/errors/running_code.h>

namespace argos {

/**
 * Calls a hook of the loop functions.
 * @param name  such as "PreStep()".
 * @return what the hook returns.
 * @throws CARGoSException with the hook and the tick if the hook throws anything.
 */
template <typename HOOK>
auto CallHook(const SSimulationContext& context, const char* name, HOOK&& hook) {
  const CRunningCodeScope running({name, nullptr, "loop functions", context.Clock});
  try {
    return hook();
  } catch (...) {
    ThrowWithCause(SRunningCode::OfThread().ToText() + " threw");
  }
}

}  // namespace argos

#endif
