#ifndef ARGOS3_PROGRAM_EXIT_GUARD_H
#define ARGOS3_PROGRAM_EXIT_GUARD_H

#include <argos3/core/utility/non_copyable.h>

namespace argos {

class CSimulator;

/**
 * During its lifetime, exit() ends the run in order if users' code calls it: a warning says where
 * it was called, and the outputs are completed. The exit status is that of the call.
 *
 * A child process of users' code (fork) is not affected.
 */
class CExitGuard : private CNonCopyable {
 public:
  /** Of the loading, run and destruction of an experiment in @p simulator. One at a time. */
  explicit CExitGuard(CSimulator& simulator);
  ~CExitGuard();

  /**
   * To be called when libraries were loaded: outputs are then completed before exit() destroys the
   * static objects of these libraries.
   */
  void Renew();
};

}  // namespace argos

#endif
