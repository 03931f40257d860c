#ifndef ARGOS3_TESTING_SUPPORT_SANITIZERS_H
#define ARGOS3_TESTING_SUPPORT_SANITIZERS_H

// Which sanitizers the tests are compiled with. g++ defines macros, clang has features.
#if defined(__has_feature)
#define ARGOS_TEST_HAS_FEATURE(FEATURE) __has_feature(FEATURE)
#else
#define ARGOS_TEST_HAS_FEATURE(FEATURE) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || ARGOS_TEST_HAS_FEATURE(address_sanitizer)
#define ARGOS_TEST_ADDRESS_SANITIZER 1
#else
#define ARGOS_TEST_ADDRESS_SANITIZER 0
#endif
#if defined(__SANITIZE_THREAD__) || ARGOS_TEST_HAS_FEATURE(thread_sanitizer)
#define ARGOS_TEST_THREAD_SANITIZER 1
#else
#define ARGOS_TEST_THREAD_SANITIZER 0
#endif

#include <vector>

namespace argos {

constexpr bool kHasAddressSanitizer = ARGOS_TEST_ADDRESS_SANITIZER == 1;
constexpr bool kHasThreadSanitizer = ARGOS_TEST_THREAD_SANITIZER == 1;
/** Sanitizers reserve more addresses than any limit of memory leaves. */
constexpr bool kCanLimitMemory = !kHasAddressSanitizer && !kHasThreadSanitizer;

/**
 * Of a number of repetitions, such as ticks: how many a test does. Sanitizers make each ten to
 * forty times as long, and find their errors in any of them.
 */
constexpr unsigned FewerIfSanitized(unsigned number) {
  return kHasAddressSanitizer || kHasThreadSanitizer ? number / 5 : number;
}

/**
 * Of numbers of threads, in ascending order: those with which a test runs. What sanitizers find
 * with few threads they find with many.
 */
inline std::vector<unsigned> MostIfSanitized(const std::vector<unsigned>& threads) {
  return kHasAddressSanitizer || kHasThreadSanitizer ? std::vector<unsigned>{threads.back()}
                                                     : threads;
}

}  // namespace argos

#endif
