#ifndef ARGOS3_CORE_UTILITY_THREADS_SIGNAL_STACK_H
#define ARGOS3_CORE_UTILITY_THREADS_SIGNAL_STACK_H

#include <argos3/core/utility/non_copyable.h>

#include <cstddef>

namespace argos {

/**
 * The stack of the calling thread on which signal handlers run that request it, so that they also
 * work when the thread's own stack has overflowed.
 */
class CSignalStack : private CNonCopyable {
 public:
  /** From now on Use() gives each thread a stack. Before threads are started. */
  static void Enable();
  /**
   * Gives the calling thread a stack until it ends, if stacks are enabled and it has none: a stack
   * that a sanitizer or the user has set is kept. Does nothing if there is no memory for it.
   */
  static void Use();

  ~CSignalStack();

 private:
  CSignalStack();

  void* m_memory = nullptr;
};

}  // namespace argos

#endif
