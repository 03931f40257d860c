#include <argos3/plugins/simulator/physics_engines/dynamics3d/ode_session.h>

#include <argos3/core/utility/configuration/argos_exception.h>

#include <ode/ode.h>

#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <mutex>

namespace argos {

namespace {

// one text for each thread: worlds of other threads have their own
thread_local char complaint[256];
thread_local bool hasComplaint = false;

// the generator from which ODE draws in this thread
thread_local UInt32 randomState = 1;
bool hasOwnRandom = false;

// replaces ODE's own handler, which prints
void KeepComplaint(int /*number*/, const char* format, va_list arguments) {
  if (!hasComplaint) {
    std::vsnprintf(complaint, sizeof(complaint), format, arguments);
    hasComplaint = true;
  }
}

// One step that makes ODE draw, and has no other effect.
bool DrawsODEHere() {
  const dWorldID world = dWorldCreate();
  const dBodyID body = dBodyCreate(world);
  const dJointID joint = dJointCreateBall(world, nullptr);
  dJointAttach(joint, body, nullptr);
  dWorldSetQuickStepNumIterations(world, kSweepsWithoutDrawing + 1);
  SeedODE(0);
  const UInt32 before = randomState;
  dWorldQuickStep(world, 0.01);
  dJointDestroy(joint);
  dBodyDestroy(body);
  dWorldDestroy(world);
  return randomState != before;
}

void InitProcess() {
  if (dInitODE2(0) == 0) {
    THROW_ARGOSEXCEPTION("the Open Dynamics Engine cannot be initialised");
  }
  dSetMessageHandler(&KeepComplaint);
  dAllocateODEDataForThread(dAllocateMaskAll);
  hasOwnRandom = DrawsODEHere();
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

bool HasOwnODERandom() {
  return hasOwnRandom;
}

void SeedODE(UInt32 number) {
  // consecutive numbers give distant initial states
  randomState = (number + 1) * 0x9E3779B9u;
}

const char* TakeODEError() {
  if (!hasComplaint) {
    return nullptr;
  }
  hasComplaint = false;
  return complaint;
}

}  // namespace argos

/**
 * In place of ODE's function of that name, which is the only one that its steppers draw from: this
 * library is loaded before ODE's, so its symbol comes first.
 *
 * Source of the numbers: D. E. Knuth, The Art of Computer Programming, vol. 2, 3.2.1 (a linear
 * congruential generator, of which the upper bits are used).
 */
// NOLINTNEXTLINE(readability-identifier-naming): the name is ODE's
extern "C" int dRandInt(int n) {
  argos::randomState = 1664525u * argos::randomState + 1013904223u;
  return static_cast<int>(
      static_cast<std::uint64_t>(argos::randomState) * static_cast<std::uint64_t>(n) >> 32);
}
