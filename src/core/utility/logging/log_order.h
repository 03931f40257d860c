#ifndef ARGOS3_CORE_UTILITY_LOGGING_LOG_ORDER_H
#define ARGOS3_CORE_UTILITY_LOGGING_LOG_ORDER_H

#include <argos3/core/utility/logging/argos_log.h>

namespace argos {

/**
 * Runs a phase whose items write their messages in the order of the items, on whatever thread they
 * run, and after all earlier messages.
 * @param phase  void(UInt64 firstPlace): calls CARGoSLog::SetSequence(firstPlace + i) before item
 * i.
 */
template <typename PHASE>
void InLogOrder(size_t items, PHASE&& phase) {
  const UInt64 firstPlace = CARGoSLog::GetSequence() + 1;
  phase(firstPlace);
  CARGoSLog::SetSequence(firstPlace + items);
}

}  // namespace argos

#endif
