// What tests use of Catch2, by the names of its version 2, for systems that have version 3: Debian from 13 on.

#ifndef ARGOS3_TESTING_SUPPORT_CATCH2_VERSION3_CATCH2_CATCH_HPP
#define ARGOS3_TESTING_SUPPORT_CATCH2_VERSION3_CATCH2_CATCH_HPP

#include <catch2/catch_all.hpp>

#include <string>

namespace Catch {

using TestEventListenerBase = EventListenerBase;

namespace Matchers {

// that of version 3 compares elements of ranges
inline auto Contains(const std::string& text) {
  return ContainsSubstring(text);
}
inline auto Contains(std::string& text) {
  return ContainsSubstring(text);
}
inline auto Contains(std::string&& text) {
  return ContainsSubstring(text);
}
inline auto Contains(const char* text) {
  return ContainsSubstring(text);
}

}  // namespace Matchers

using Matchers::Contains;
using Matchers::EndsWith;
using Matchers::Equals;
using Matchers::StartsWith;
using Matchers::WithinAbs;
using Matchers::WithinRel;

}  // namespace Catch

#endif
