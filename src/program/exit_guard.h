#ifndef ARGOS3_PROGRAM_EXIT_GUARD_H
#define ARGOS3_PROGRAM_EXIT_GUARD_H

namespace argos {

class CSimulator;

/**
 * During its lifetime, exit() ends the run in order if users' code calls it: a warning says where
 * it was called, and the outputs are completed. The exit status is that of the call.
 *
 * A child process of users' code (fork) is not affected.
 */
class CExitGuard {
 public:
  /** Of the loading, run and destruction of an experiment in @p simulator. One at a time. */
  explicit CExitGuard(CSimulator& simulator);
  ~CExitGuard();
  CExitGuard(const CExitGuard&) = delete;
  CExitGuard& operator=(const CExitGuard&) = delete;

  /**
   * To be called when libraries were loaded: outputs are then completed before exit() destroys the
   * static objects of these libraries.
   */
  void Renew();
};

}  // namespace argos

#endif
