#ifndef ARGOS3_TESTING_FUZZ_FUZZ_SUPPORT_H
#define ARGOS3_TESTING_FUZZ_FUZZ_SUPPORT_H

#include <cstddef>
#include <cstdint>
#include <functional>

namespace argos {

/**
 * Runs the body for one input of a fuzzer. Exceptions of type CARGoSException are the answer to a
 * wrong input; any other one aborts, which the fuzzer reports. Nothing is printed.
 */
int RunFuzzInput(const std::function<void()>& body);

}  // namespace argos

/** What libFuzzer calls for each input. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

#endif
