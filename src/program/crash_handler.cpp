#include <argos3/program/crash_handler.h>

#include <argos3/core/utility/errors/running_code.h>
#include <argos3/core/utility/errors/signal_safe_text.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/threads/signal_stack.h>

#include <backtrace.h>
#include <cxxabi.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <atomic>
#include <csetjmp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace argos {

namespace {

struct SCrashSignal {
  int Number;
  const char* Name;
};

constexpr SCrashSignal kCrashSignals[] = {{SIGSEGV, "SIGSEGV: invalid memory access"},
                                          {SIGBUS, "SIGBUS: invalid memory access"},
                                          {SIGFPE, "SIGFPE: invalid arithmetic operation"},
                                          {SIGILL, "SIGILL: invalid instruction"},
                                          {SIGABRT, "SIGABRT: the program was aborted"}};

// s; for the steps that read symbols, of which there are many in large files
constexpr unsigned int kPatience = 10;
// s; for the other steps, which wait only for locks that nothing releases any more
constexpr unsigned int kShortPatience = 1;
constexpr int kMaxFrames = 40;
constexpr int kMaxOwnFrames = 20;  // frames of the handler
// bytes beside the end of a stack that an overflow touches first
constexpr std::uintptr_t kGuardReach = 64 * 1024;

backtrace_state* g_symbols = nullptr;
int g_logFile = STDOUT_FILENO;
int g_logErrFile = STDERR_FILENO;
// the thread that reports; 0: none
std::atomic<int> g_reporter{0};
sigjmp_buf g_giveUp;
// a step of the report runs, which g_giveUp ends
volatile std::sig_atomic_t g_isInStep = 0;

int GetThreadId() {
  return static_cast<int>(syscall(SYS_gettid));
}

extern "C" void GiveUpStep(int) {
  if (GetThreadId() == g_reporter.load()) {
    siglongjmp(g_giveUp, 1);
  }
  // the alarm has interrupted another thread
  syscall(SYS_tgkill, getpid(), g_reporter.load(), SIGALRM);
}

// runs a step of the report; gives it up if it crashes or takes too long
template <typename STEP>
bool TryStep(unsigned int patience, STEP&& step) {
  if (sigsetjmp(g_giveUp, 1) != 0) {
    alarm(0);
    g_isInStep = 0;
    return false;
  }
  g_isInStep = 1;
  alarm(patience);
  step();
  alarm(0);
  g_isInStep = 0;
  return true;
}

void Print(const CSignalSafeText& text) {
  text.WriteTo(STDERR_FILENO);
  if (g_logErrFile != STDERR_FILENO) {
    text.WriteTo(g_logErrFile);
  }
}

// the addresses of the calls, innermost first
struct SStack {
  std::uintptr_t Addresses[kMaxFrames + kMaxOwnFrames];
  int Count = 0;
};

// a line of the report
struct SFrame {
  int Number;
  bool Demangle;
  bool IsPrinted = false;
};

void IgnoreError(void*, const char*, int) {}

int NoteAddress(void* data, std::uintptr_t address) {
  SStack& stack = *static_cast<SStack*>(data);
  // the last address of a thread is none
  if (address != ~std::uintptr_t(0)) {
    stack.Addresses[stack.Count++] = address;
  }
  return stack.Count == kMaxFrames + kMaxOwnFrames ? 1 : 0;
}

void AppendFunction(const char* mangled, bool demangle, CSignalSafeText& text) {
  int status = -1;
  char* const name = demangle ? abi::__cxa_demangle(mangled, nullptr, nullptr, &status) : nullptr;
  text.Append(status == 0 ? name : mangled);
  // NOLINTNEXTLINE(cppcoreguidelines-no-malloc): the C library allocated it
  std::free(name);
}

void AppendPlace(std::uintptr_t address, const char* file, int line, CSignalSafeText& text) {
  Dl_info library{};
  if (file != nullptr) {
    text.Append(" at ").Append(file).Append(":").AppendNumber(static_cast<std::uint64_t>(line));
  } else if (dladdr(reinterpret_cast<const void*>(address), &library) != 0) {
    text.Append(" in ").Append(library.dli_fname).Append(" +");
    text.AppendHex(address - reinterpret_cast<std::uintptr_t>(library.dli_fbase));
  }
}

void NoteName(void* data, std::uintptr_t, const char* name, std::uintptr_t, std::uintptr_t) {
  *static_cast<const char**>(data) = name;
}

int PrintFrame(void* data, std::uintptr_t address, const char* file, int line,
               const char* function) {
  SFrame& frame = *static_cast<SFrame*>(data);
  if (function == nullptr) {
    backtrace_syminfo(g_symbols, address, &NoteName, &IgnoreError, &function);
  }
  CSignalSafeText text;
  text.Append("  #").AppendNumber(static_cast<std::uint64_t>(frame.Number)).Append(" ");
  if (function != nullptr) {
    AppendFunction(function, frame.Demangle, text);
  } else {
    text.AppendHex(address);
  }
  AppendPlace(address, file, line, text);
  text.Append("\n");
  Print(text);
  frame.IsPrinted = true;
  return 0;
}

std::uintptr_t GetFaultAddress([[maybe_unused]] const ucontext_t& context) {
#if defined(__x86_64__)
  return static_cast<std::uintptr_t>(context.uc_mcontext.gregs[REG_RIP]);
#elif defined(__aarch64__)
  return context.uc_mcontext.pc;
#else
  return 0;
#endif
}

std::uintptr_t GetStackPointer([[maybe_unused]] const ucontext_t& context) {
#if defined(__x86_64__)
  return static_cast<std::uintptr_t>(context.uc_mcontext.gregs[REG_RSP]);
#elif defined(__aarch64__)
  return context.uc_mcontext.sp;
#else
  return 0;
#endif
}

void PrintStack(std::uintptr_t fault, bool demangle) {
  SStack stack;
  backtrace_simple(g_symbols, 0, &NoteAddress, &IgnoreError, &stack);
  // the handler's own calls are before the instruction that crashed
  int first = 0;
  while (first < stack.Count && stack.Addresses[first] != fault) {
    ++first;
  }
  first = first == stack.Count ? 0 : first;
  for (int i = first; i < stack.Count && i < first + kMaxFrames; ++i) {
    SFrame frame{i - first, demangle};
    backtrace_pcinfo(g_symbols, stack.Addresses[i], &PrintFrame, &IgnoreError, &frame);
    if (!frame.IsPrinted) {
      PrintFrame(&frame, stack.Addresses[i], nullptr, 0, nullptr);
    }
  }
}

void PrintHeader(int signal, const siginfo_t& info, const ucontext_t& context) {
  CSignalSafeText text;
  text.Append("[FATAL] crash, ");
  for (const SCrashSignal& known : kCrashSignals) {
    text.Append(known.Number == signal ? known.Name : nullptr);
  }
  if (signal == SIGSEGV && info.si_code > 0) {
    const auto address = reinterpret_cast<std::uintptr_t>(info.si_addr);
    const std::uintptr_t stack = GetStackPointer(context);
    const bool isNearStack = address + kGuardReach > stack && address < stack + kGuardReach;
    text.Append(" at address ").AppendHex(address);
    text.Append(isNearStack ? " (the stack has overflowed)" : nullptr);
  }
  CSignalSafeText running;
  SRunningCode::OfThread().AppendTo(running);
  if (running.GetLength() > 0) {
    text.Append("\n[FATAL] ").Append(running.GetText(), running.GetLength());
  } else {
    text.Append("\n[FATAL] no code of robots or loop functions was running in this thread");
  }
  text.Append("\n");
  Print(text);
}

// writes the log of this tick, and the C streams, of which std::cout is one
void WriteUnwritten() {
  TryStep(kPatience, [] {
    LOG.WriteAfterCrash(g_logFile);
    LOGERR.WriteAfterCrash(g_logErrFile);
  });
  TryStep(kShortPatience, [] { std::fflush(nullptr); });
}

// the crash may have damaged the heap, or have happened while it was locked
bool IsHeapUsable() {
  return TryStep(kShortPatience, [] {
    // the larger ones are not among those that each thread keeps for itself without a lock
    for (std::size_t size = 16; size <= 64 * 1024; size *= 2) {
      // NOLINTNEXTLINE(cppcoreguidelines-no-malloc): as the demangler does
      void* volatile memory = std::malloc(size);
      // NOLINTNEXTLINE(cppcoreguidelines-no-malloc)
      std::free(memory);
    }
  });
}

void Report(int signal, const siginfo_t& info, const ucontext_t& context) {
  struct sigaction action {};
  action.sa_handler = &GiveUpStep;
  sigaction(SIGALRM, &action, nullptr);
  sigset_t alarms;
  sigemptyset(&alarms);
  sigaddset(&alarms, SIGALRM);
  pthread_sigmask(SIG_UNBLOCK, &alarms, nullptr);

  TryStep(kShortPatience, [&] { PrintHeader(signal, info, context); });
  const std::uintptr_t fault = GetFaultAddress(context);
  // demangling allocates
  if (!IsHeapUsable() || !TryStep(kPatience, [fault] { PrintStack(fault, true); })) {
    TryStep(kPatience, [fault] { PrintStack(fault, false); });
  }
  WriteUnwritten();
}

extern "C" void HandleCrash(int signal, siginfo_t* info, void* context) {
  int none = 0;
  if (g_reporter.compare_exchange_strong(none, GetThreadId())) {
    Report(signal, *info, *static_cast<const ucontext_t*>(context));
  } else if (none == GetThreadId()) {
    if (g_isInStep != 0) {
      siglongjmp(g_giveUp, 1);
    }
  } else {
    // another thread reports its crash, and the process dies of that
    for (;;) {
      pause();
    }
  }
  std::signal(signal, SIG_DFL);
  raise(signal);
}

void CatchSignal(int signal) {
  struct sigaction present {};
  sigaction(signal, nullptr, &present);
  if ((present.sa_flags & SA_SIGINFO) != 0 || present.sa_handler != SIG_DFL) {
    return;
  }
  struct sigaction action {};
  action.sa_sigaction = &HandleCrash;
  // a crash of the report must reach this handler, too
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER;
  sigaction(signal, &action, nullptr);
}

int OpenForAppending(const std::string& file, int otherwise) {
  if (file.empty()) {
    return otherwise;
  }
  const int opened = open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  return opened >= 0 ? opened : otherwise;
}

}  // namespace

void CCrashHandler::Install() {
  if (g_symbols != nullptr) {
    return;
  }
  g_symbols = backtrace_create_state(nullptr, 1, &IgnoreError, nullptr);
  CSignalStack::Enable();
  CSignalStack::Use();
  for (const SCrashSignal& signal : kCrashSignals) {
    CatchSignal(signal.Number);
  }
}

void CCrashHandler::SetLogFiles(const std::string& log, const std::string& logErr) {
  g_logFile = OpenForAppending(log, STDOUT_FILENO);
  g_logErrFile = OpenForAppending(logErr, STDERR_FILENO);
}

}  // namespace argos
