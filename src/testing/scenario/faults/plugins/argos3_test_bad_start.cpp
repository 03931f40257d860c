// A library whose static object throws or crashes when it is constructed, if that is requested.

#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace {

struct SBadStart {
  SBadStart() {
    const char* const what = std::getenv("ARGOS_TEST_BAD_START");
    if (what != nullptr && std::strcmp(what, "throw") == 0) {
      throw std::runtime_error("no good beginning");
    }
    if (what != nullptr && std::strcmp(what, "segv") == 0) {
      *static_cast<volatile int*>(nullptr) = 1;
    }
  }
};

const SBadStart kBadStart;

}  // namespace
