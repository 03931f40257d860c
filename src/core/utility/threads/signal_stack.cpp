#include <argos3/core/utility/threads/signal_stack.h>

#include <sys/mman.h>

#include <atomic>
#include <csignal>

namespace argos {

namespace {

// bytes; enough for the report of a crash, of which the search for symbols needs most
constexpr std::size_t kStackBytes = 256 * 1024;

std::atomic<bool> areStacksEnabled{false};

}  // namespace

void CSignalStack::Enable() {
  areStacksEnabled = true;
}

void CSignalStack::Use() {
  if (areStacksEnabled) {
    thread_local const CSignalStack stack;
  }
}

CSignalStack::CSignalStack() {
  stack_t present{};
  if (sigaltstack(nullptr, &present) != 0 || (present.ss_flags & SS_DISABLE) == 0) {
    return;
  }
  void* const memory = mmap(nullptr, kStackBytes, PROT_READ | PROT_WRITE,
                            MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) {
    return;
  }
  m_memory = memory;
  stack_t stack{};
  stack.ss_sp = memory;
  stack.ss_size = kStackBytes;
  sigaltstack(&stack, nullptr);
}

CSignalStack::~CSignalStack() {
  if (m_memory == nullptr) {
    return;
  }
  stack_t none{};
  none.ss_flags = SS_DISABLE;
  sigaltstack(&none, nullptr);
  munmap(m_memory, kStackBytes);
}

}  // namespace argos
