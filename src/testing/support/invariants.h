#ifndef ARGOS3_TESTING_SUPPORT_INVARIANTS_H
#define ARGOS3_TESTING_SUPPORT_INVARIANTS_H

#include <catch2/catch.hpp>

#include <string>

namespace argos {

/** Does ARGOS_ASSERT throw in this build? See argos_exception.h. */
#if !defined(NDEBUG) || defined(ARGOS_CHECK_INVARIANTS)
inline constexpr bool kChecksInvariants = true;
#else
inline constexpr bool kChecksInvariants = false;
#endif

/**
 * Checks that a call that breaks an invariant throws an error with that text. Builds that do not
 * check invariants leave it out: its behaviour is undefined there.
 */
template <typename CALL>
void CheckCaught([[maybe_unused]] CALL&& call, [[maybe_unused]] const std::string& text) {
  if constexpr (kChecksInvariants) {
    CAPTURE(text);
    CHECK_THROWS_WITH(call(), Catch::Matchers::Contains(text));
  }
}

}  // namespace argos

#endif
