#include <argos3/core/simulator/loading/loading_check.h>

namespace argos {

namespace {

thread_local int numChecks = 0;

}  // namespace

CLoadingCheck::CLoadingCheck() {
  ++numChecks;
}

CLoadingCheck::~CLoadingCheck() {
  --numChecks;
}

bool CLoadingCheck::IsActive() {
  return numChecks > 0;
}

}  // namespace argos
