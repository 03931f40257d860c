#include <argos3/plugins/simulator/physics_engines/dynamics3d/ode_session.h>

#include <argos3/core/utility/configuration/argos_exception.h>

#include <ode/ode.h>

#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <mutex>

namespace argos {

namespace {

// one text for each thread: worlds of other threads have their own
thread_local char complaint[256];
thread_local bool hasComplaint = false;

// state of this library's dRand() in this thread
thread_local UInt32 randomState = 1;
bool isRandomReplaced = false;
// held during a step that draws from ODE's own generator
std::mutex sharedRandomMutex;

// replaces ODE's own handler, which prints
void KeepComplaint(int /*number*/, const char* format, va_list arguments) {
  if (!hasComplaint) {
    std::vsnprintf(complaint, sizeof(complaint), format, arguments);
    hasComplaint = true;
  }
}

// Replaces ODE's own handlers of errors and failed assertions, which end the process. The exception
// passes through functions of ODE, so the world must not be used any more.
void ThrowODEError(int /*number*/, const char* format, va_list arguments) {
  constexpr std::size_t kLongest = 256;
  char text[kLongest];
  std::vsnprintf(text, sizeof(text), format, arguments);
  THROW_ARGOSEXCEPTION("the Open Dynamics Engine fails: "
                       << text
                       << "; are masses, sizes and forces of bodies in proportion to each other?");
}

// sequences with consecutive numbers begin far from each other
UInt32 ComputeSeed(UInt32 sequence) {
  return (sequence + 1) * 0x9E3779B9u;
}

// Makes a step in which ODE draws random numbers: from the ninth sweep on, it shuffles the
// constraints. @return true if it drew them from this library.
bool TestRandom() {
  constexpr int kSweeps = 9;
  const dWorldID world = dWorldCreate();
  const dBodyID body = dBodyCreate(world);
  const dJointID joint = dJointCreateBall(world, nullptr);
  dJointAttach(joint, body, nullptr);
  dWorldSetQuickStepNumIterations(world, kSweeps);
  randomState = 0;
  dWorldQuickStep(world, 0.01);
  dJointDestroy(joint);
  dBodyDestroy(body);
  dWorldDestroy(world);
  return randomState != 0;
}

void InitProcess() {
  if (dInitODE2(0) == 0) {
    THROW_ARGOSEXCEPTION("the Open Dynamics Engine cannot be initialised");
  }
  dSetMessageHandler(&KeepComplaint);
  dSetErrorHandler(&ThrowODEError);
  dSetDebugHandler(&ThrowODEError);
  dAllocateODEDataForThread(dAllocateMaskAll);
  isRandomReplaced = TestRandom();
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

bool IsODERandomReplaced() {
  return isRandomReplaced;
}

void StepODEIteratively(dxWorld* world, Real duration, UInt32 sequence) {
  const UInt32 seed = ComputeSeed(sequence);
  if (isRandomReplaced) {
    randomState = seed;
    dWorldQuickStep(world, duration);
    return;
  }
  const std::lock_guard<std::mutex> lock(sharedRandomMutex);
  dRandSetSeed(seed);
  dWorldQuickStep(world, duration);
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
 * Replaces ODE's function of that name, from which dWorldQuickStep() draws through dRandInt(): this
 * library is normally loaded before ODE's, so its symbol comes first. Gives the numbers of ODE's
 * own function, but from a state that belongs to the thread.
 *
 * Source of the numbers: D. E. Knuth, The Art of Computer Programming, vol. 2, 3.2.1 (a linear
 * congruential generator), with the constants of ODE 0.16.
 */
// NOLINTNEXTLINE(readability-identifier-naming): the name is ODE's
extern "C" unsigned long dRand() {
  argos::randomState = 1664525u * argos::randomState + 1013904223u;
  return argos::randomState;
}
