#include <argos3/core/utility/threads/thread_pool.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/signal_safe_text.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/processes/fork_count.h>
#include <argos3/core/utility/threads/signal_stack.h>

#if defined(__x86_64__) || defined(__i386__)
#include <immintrin.h>
#endif
#include <pthread.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <system_error>

namespace argos {

namespace {

// about 20 us on current machines: longer than the gap between two phases of a busy tick, and
// short enough not to matter between ticks
constexpr int kSpins = 4000;

// different calls of ParallelFor(); there are about 40
constexpr size_t kMaxPhases = 128;

#if !defined(NDEBUG) || defined(ARGOS_CHECK_INVARIANTS) || defined(__SANITIZE_THREAD__)
constexpr bool kSharesAlways = true;
#elif defined(__has_feature)
constexpr bool kSharesAlways = __has_feature(thread_sanitizer);
#else
constexpr bool kSharesAlways = false;
#endif

using TClock = std::chrono::steady_clock;

Real SecondsSince(TClock::time_point start) {
  return std::chrono::duration<Real>(TClock::now() - start).count();
}

void Relax() {
#if defined(__x86_64__) || defined(__i386__)
  _mm_pause();
#else
  std::this_thread::yield();
#endif
}

// waits until the value is no longer the old one
template <typename T>
void WaitForChange(std::atomic<T>& value, T old, bool spin) {
  if (spin) {
    for (int i = 0; i < kSpins; ++i) {
      if (value.load(std::memory_order_acquire) != old) {
        return;
      }
      Relax();
    }
  }
  while (value.load(std::memory_order_acquire) == old) {
    value.wait(old, std::memory_order_acquire);
  }
}

constexpr char kForkedInPhase[] =
    "fork() was called while robots, engines or media were updated on several threads: the child "
    "has only one of these threads and cannot go on; it must call exec() or _exit(). fork() "
    "between ticks is possible";

// never 0; the system would read a file each time
UInt32 CountCores() {
  static const UInt32 cores = std::max(1U, std::thread::hardware_concurrency());
  return cores;
}

// it is a child that has this worker only: nothing could end its phase
[[noreturn]] void EndForkedWorker() {
  CSignalSafeText text;
  text.Append("[FATAL] ").Append(kForkedInPhase).Append("\n");
  text.WriteTo(STDERR_FILENO);
  _exit(EXIT_FAILURE);
}

}  // namespace

CThreadPool::CThreadPool(UInt32 threads, std::unique_ptr<CSchedule> schedule, bool pinToCores,
                         std::function<void()> startWorker)
    : m_numThreads(std::max<UInt32>(1, threads)),
      m_numForks(CountForks()),
      m_pinToCores(pinToCores),
      m_spin(m_numThreads <= CountCores()),
      m_schedule(std::move(schedule)),
      m_startWorker(std::move(startWorker)) {
  m_phases.reserve(kMaxPhases);
  try {
    StartWorkers();
  } catch (...) {
    StopWorkers();
    throw;
  }
}

CThreadPool::~CThreadPool() {
  StopWorkers();
}

void CThreadPool::StartWorkers() {
  m_workers.reserve(m_numThreads - 1);
  for (UInt32 thread = 1; thread < m_numThreads; ++thread) {
    m_busy.fetch_add(1, std::memory_order_relaxed);
    try {
      m_workers.emplace_back([this, thread] {
        if (PrepareWorker()) {
          WorkerLoop(thread);
        }
      });
    } catch (const std::system_error& error) {
      m_busy.fetch_sub(1, std::memory_order_relaxed);
      WaitForWorkers();
      THROW_ARGOSEXCEPTION("the system started only " << thread << " of " << m_numThreads
                                                      << " threads: " << error.code().message());
    }
    if (m_pinToCores) {
      Pin(m_workers.back(), thread);
    }
  }
  WaitForWorkers();
  if (m_failure) {
    std::rethrow_exception(m_failure);
  }
}

bool CThreadPool::IsOfParent() const {
  return m_numForks != CountForks();
}

// In a child of fork(): the workers do not exist there, so they can be neither joined nor detached.
void CThreadPool::ForgetWorkersOfParent() {
  for (std::thread& worker : m_workers) {
    std::construct_at(&worker);
  }
  m_workers.clear();
  m_busy.store(0, std::memory_order_relaxed);
  m_phase.store(0, std::memory_order_relaxed);
  m_failure = nullptr;
  m_numForks = CountForks();
}

void CThreadPool::RestartWorkers() {
  ForgetWorkersOfParent();
  try {
    StartWorkers();
  } catch (...) {
    StopWorkers();
    m_workers.clear();
    m_stop.store(false, std::memory_order_relaxed);
    // the next phase tries it again
    --m_numForks;
    throw;
  }
}

// users' code of a phase may have called fork()
void CThreadPool::RequireSameProcess() const {
  if (IsOfParent()) {
    THROW_ARGOSEXCEPTION(kForkedInPhase);
  }
}

void CThreadPool::StopWorkers() {
  if (IsOfParent()) {
    ForgetWorkersOfParent();
  }
  m_stop.store(true, std::memory_order_relaxed);
  m_phase.fetch_add(1, std::memory_order_release);
  m_phase.notify_all();
  for (std::thread& worker : m_workers) {
    worker.join();
  }
}

void CThreadPool::WaitForWorkers() {
  for (UInt32 busy = m_busy.load(std::memory_order_acquire); busy != 0;
       busy = m_busy.load(std::memory_order_acquire)) {
    WaitForChange(m_busy, busy, m_spin);
  }
}

void CThreadPool::NoteEnd() {
  if (m_busy.fetch_sub(1, std::memory_order_acq_rel) == 1) {
    m_busy.notify_one();
  }
}

void CThreadPool::NoteFailure(size_t begin) {
  const std::lock_guard<std::mutex> lock(m_failureMutex);
  if (!m_failure || begin < m_failureBegin) {
    m_failure = std::current_exception();
    m_failureBegin = begin;
  }
}

bool CThreadPool::PrepareWorker() {
  bool good = false;
  try {
    CSignalStack::Use();
    if (m_startWorker) {
      m_startWorker();
    }
    LOG.AddThreadSafeBuffer();
    LOGERR.AddThreadSafeBuffer();
    good = true;
  } catch (...) {
    NoteFailure(0);
  }
  NoteEnd();
  return good;
}

// the last one is of all phases for which there was no room
CSharingCost& CThreadPool::FindCost(TCall call) {
  for (SPhase& phase : m_phases) {
    if (phase.Call == call) {
      return phase.Cost;
    }
  }
  if (m_phases.size() < kMaxPhases) {
    m_phases.push_back({call, {}});
  }
  return m_phases.back().Cost;
}

void CThreadPool::DoPhase(size_t items, size_t grain, TCall call, void* context) {
  CSharingCost& cost = FindCost(call);
  if (kSharesAlways || m_sharesAlways || cost.IsWorthwhile(items, m_numThreads)) {
    Share(items, grain, call, context, cost);
    return;
  }
  const TClock::time_point start = TClock::now();
  call(context, 0, items, 0);
  cost.AddAlone(items, SecondsSince(start));
}

void CThreadPool::Share(size_t items, size_t grain, TCall call, void* context, CSharingCost& cost) {
  if (IsOfParent()) {
    RestartWorkers();
  }
  const TClock::time_point start = TClock::now();
  m_call = call;
  m_context = context;
  m_failure = nullptr;
  m_items = items;
  m_numDealt.store(0, std::memory_order_relaxed);
  m_schedule->Start(items, grain, m_numThreads);
  m_busy.store(m_numThreads - 1, std::memory_order_relaxed);
  m_phase.fetch_add(1, std::memory_order_release);
  m_phase.notify_all();

  const TClock::time_point callersStart = TClock::now();
  const size_t callersItems = DoShare(0);
  const Real callersSeconds = SecondsSince(callersStart);
  RequireSameProcess();
  WaitForWorkers();
  if (m_failure) {
    std::rethrow_exception(m_failure);
  }
  RequireAllDealt();
  cost.AddShared(items, SecondsSince(start), m_numThreads, callersItems, callersSeconds);
}

// a schedule of a user's library may have errors, which would leave out robots in silence
void CThreadPool::RequireAllDealt() const {
  const size_t numDealt = m_numDealt.load(std::memory_order_relaxed);
  if (numDealt != m_items) {
    THROW_ARGOSEXCEPTION("the schedule of the threads (\"method\" of <system>) dealt "
                         << numDealt << " of " << m_items
                         << " items: Next() must deal each of them once");
  }
}

void CThreadPool::WorkerLoop(UInt32 thread) {
  for (UInt32 seen = 0;; ++seen) {
    WaitForChange(m_phase, seen, m_spin);
    if (m_stop.load(std::memory_order_relaxed)) {
      return;
    }
    DoShare(thread);
    if (IsOfParent()) {
      EndForkedWorker();
    }
    NoteEnd();
  }
}

// returns the number of items
size_t CThreadPool::DoShare(UInt32 thread) {
  const size_t numDone = DoChunks(thread);
  m_numDealt.fetch_add(numDone, std::memory_order_relaxed);
  return numDone;
}

// returns the number of items
size_t CThreadPool::DoChunks(UInt32 thread) {
  size_t numDone = 0;
  size_t begin = 0;
  size_t end = 0;
  while (m_schedule->Next(thread, begin, end)) {
    try {
      if (begin > end || end > m_items) {
        THROW_ARGOSEXCEPTION("the schedule of the threads (\"method\" of <system>) dealt the items "
                             << begin << " to " << end << "; there are " << m_items);
      }
      numDone += end - begin;
      m_call(m_context, begin, end, thread);
    } catch (...) {
      NoteFailure(begin);
    }
  }
  return numDone;
}

void CThreadPool::Pin(std::thread& worker, UInt32 thread) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(thread % CountCores(), &set);
  // a refusal costs speed only, so it is not an error
  pthread_setaffinity_np(worker.native_handle(), sizeof(set), &set);
}

}  // namespace argos
