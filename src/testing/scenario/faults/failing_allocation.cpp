#include "failing_allocation.h"

#include <argos3/testing/support/sanitizers.h>

#include <cstdlib>
#include <new>

// a sanitizer has its own operator new, which must not be replaced by half
#if !ARGOS_TEST_ADDRESS_SANITIZER && !ARGOS_TEST_THREAD_SANITIZER
#define ARGOS_TEST_REPLACES_NEW 1
#endif

namespace argos {

namespace {

struct SFailure {
  bool IsActive = false;
  std::size_t Count = 0;
  std::size_t First = 0;
  std::size_t End = 0;
};

thread_local SFailure failure;

}  // namespace

CFailingAllocation::CFailingAllocation(std::size_t first, std::size_t number) {
  failure = {true, 0, first, first + number};
}

CFailingAllocation::~CFailingAllocation() {
  failure.IsActive = false;
}

std::size_t CFailingAllocation::GetCount() const {
  return failure.Count;
}

namespace {

[[maybe_unused]] bool Fails() {
  if (!failure.IsActive) {
    return false;
  }
  const std::size_t number = failure.Count++;
  return number >= failure.First && number < failure.End;
}

}  // namespace

}  // namespace argos

#ifdef ARGOS_TEST_REPLACES_NEW
// NOLINTBEGIN(cppcoreguidelines-no-malloc): this is the allocator
void* operator new(std::size_t bytes) {
  void* const memory = argos::Fails() ? nullptr : std::malloc(bytes > 0 ? bytes : 1);
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  return memory;
}

void* operator new[](std::size_t bytes) {
  return operator new(bytes);
}

void operator delete(void* memory) noexcept {
  std::free(memory);
}

void operator delete[](void* memory) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}
// NOLINTEND(cppcoreguidelines-no-malloc)
#endif
