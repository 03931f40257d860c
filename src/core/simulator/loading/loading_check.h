#ifndef ARGOS3_CORE_SIMULATOR_LOADING_LOADING_CHECK_H
#define ARGOS3_CORE_SIMULATOR_LOADING_LOADING_CHECK_H

#include <argos3/core/utility/non_copyable.h>

namespace argos {

/**
 * During its lifetime, the experiments that this thread loads are only checked: outputs and
 * profilers read their elements and check whether their files can be written, but create and change
 * nothing.
 */
class CLoadingCheck : private CNonCopyable {
 public:
  CLoadingCheck();
  ~CLoadingCheck();

  static bool IsActive();
};

}  // namespace argos

#endif
