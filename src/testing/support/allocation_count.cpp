#include <argos3/testing/support/allocation_count.h>

#include <cxxabi.h>
#include <execinfo.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>

// a sanitizer with its own allocator offers hooks for allocations
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ARGOS_TEST_SANITIZER_ALLOCATES 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || \
    __has_feature(memory_sanitizer)
#define ARGOS_TEST_SANITIZER_ALLOCATES 1
#endif
#endif
#ifndef ARGOS_TEST_SANITIZER_ALLOCATES
#define ARGOS_TEST_SANITIZER_ALLOCATES 0
#endif
#if ARGOS_TEST_SANITIZER_ALLOCATES || defined(__GLIBC__)
#define ARGOS_TEST_COUNTS_ALLOCATIONS 1
#else
#define ARGOS_TEST_COUNTS_ALLOCATIONS 0
#endif

#if ARGOS_TEST_SANITIZER_ALLOCATES
// defined in every sanitizer's library; GCC installs no header that declares it
// NOLINTNEXTLINE(readability-identifier-naming): a name of the sanitizers
extern "C" int __sanitizer_install_malloc_and_free_hooks(
    void (*onAllocation)(const volatile void* memory, std::size_t size),
    void (*onRelease)(const volatile void* memory));
#endif

namespace argos {

namespace {

constexpr int kMaxFrames = 48;

std::atomic<bool> g_counting{false};
std::atomic<std::size_t> g_count{0};
// written by the thread with the first allocation
void* g_frames[kMaxFrames];
int g_numFrames = 0;

// @return the demangled name in "library(name+0x12) [0x34]"
std::string Readable(const std::string& symbol) {
  const std::size_t open = symbol.find('(');
  const std::size_t plus = symbol.find('+', open);
  if (open == std::string::npos || plus == std::string::npos || plus == open + 1) {
    return symbol;
  }
  const std::string name = symbol.substr(open + 1, plus - open - 1);
  int status = 0;
  char* const demangled = abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status);
  const std::string result = status == 0 ? demangled : name;
  // NOLINTNEXTLINE(cppcoreguidelines-no-malloc): the C library allocated it
  std::free(demangled);
  return result + "  " + symbol.substr(0, open);
}

#if ARGOS_TEST_COUNTS_ALLOCATIONS
void NoteAllocation() {
  if (g_counting.load(std::memory_order_relaxed) && g_count.fetch_add(1) == 0) {
    g_numFrames = backtrace(g_frames, kMaxFrames);
  }
}
#endif

}  // namespace

CAllocationCount::CAllocationCount() {
#if ARGOS_TEST_SANITIZER_ALLOCATES
  static const int installed = __sanitizer_install_malloc_and_free_hooks(
      [](const volatile void*, std::size_t) { NoteAllocation(); }, [](const volatile void*) {});
  static_cast<void>(installed);
#endif
  // the first call of backtrace() loads a library, which allocates
  g_numFrames = backtrace(g_frames, kMaxFrames);
  g_numFrames = 0;
  g_count = 0;
  g_counting = true;
}

CAllocationCount::~CAllocationCount() {
  g_counting = false;
}

bool CAllocationCount::IsAvailable() {
  return ARGOS_TEST_COUNTS_ALLOCATIONS != 0;
}

std::size_t CAllocationCount::GetCount() const {
  return g_count;
}

std::string CAllocationCount::DescribeFirst() const {
  const bool counting = g_counting.exchange(false);
  std::string text;
  char** const symbols = backtrace_symbols(g_frames, g_numFrames);
  for (int frame = 0; symbols != nullptr && frame < g_numFrames; ++frame) {
    text += Readable(symbols[frame]) + '\n';
  }
  // NOLINTNEXTLINE(cppcoreguidelines-no-malloc): the C library allocated it
  std::free(symbols);
  g_counting = counting;
  return text;
}

}  // namespace argos

#if ARGOS_TEST_COUNTS_ALLOCATIONS && !ARGOS_TEST_SANITIZER_ALLOCATES
// These definitions precede the C library's, in which each allocator has a second name. operator
// new of the C++ library calls malloc().
extern "C" {

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) noexcept {
  argos::NoteAllocation();
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  argos::NoteAllocation();
  return __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size) noexcept {
  argos::NoteAllocation();
  return __libc_realloc(memory, size);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  argos::NoteAllocation();
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  argos::NoteAllocation();
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
  argos::NoteAllocation();
  void* const result = __libc_memalign(alignment, size);
  if (result == nullptr) {
    return ENOMEM;
  }
  *memory = result;
  return 0;
}

}  // extern "C"
#endif
