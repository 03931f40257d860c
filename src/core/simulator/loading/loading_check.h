#ifndef ARGOS3_CORE_SIMULATOR_LOADING_LOADING_CHECK_H
#define ARGOS3_CORE_SIMULATOR_LOADING_LOADING_CHECK_H

namespace argos {

/**
 * During its lifetime, the experiments that this thread loads are only checked: their outputs and
 * profilers, which would overwrite the files of an earlier run, are not initialised.
 */
class CLoadingCheck {
 public:
  CLoadingCheck();
  ~CLoadingCheck();
  CLoadingCheck(const CLoadingCheck&) = delete;
  CLoadingCheck& operator=(const CLoadingCheck&) = delete;

  static bool IsActive();
};

}  // namespace argos

#endif
