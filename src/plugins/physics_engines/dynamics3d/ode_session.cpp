#include <argos3/plugins/simulator/physics_engines/dynamics3d/ode_session.h>

#include <argos3/core/utility/configuration/argos_exception.h>

#include <ode/ode.h>

#include <cstdarg>
#include <cstdio>
#include <mutex>

namespace argos {

namespace {

// one text for each thread: worlds of other threads have their own
thread_local char complaint[256];
thread_local bool hasComplaint = false;

// in place of ODE's own handler, which prints
void KeepComplaint(int /*number*/, const char* format, va_list arguments) {
  if (!hasComplaint) {
    std::vsnprintf(complaint, sizeof(complaint), format, arguments);
    hasComplaint = true;
  }
}

void InitProcess() {
  if (dInitODE2(0) == 0) {
    THROW_ARGOSEXCEPTION("the Open Dynamics Engine cannot be initialised");
  }
  dSetMessageHandler(&KeepComplaint);
}

}  // namespace

void UseODEInThisThread() {
  static std::once_flag isReady;
  std::call_once(isReady, &InitProcess);
  thread_local const bool hasData = dAllocateODEDataForThread(dAllocateMaskAll) != 0;
  if (!hasData) {
    THROW_ARGOSEXCEPTION("the Open Dynamics Engine has no memory for another thread");
  }
}

const char* TakeODEComplaint() {
  if (!hasComplaint) {
    return nullptr;
  }
  hasComplaint = false;
  return complaint;
}

}  // namespace argos
