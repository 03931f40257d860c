#include <argos3/core/utility/threads/thread_pool.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/threads/signal_stack.h>

#if defined(__x86_64__) || defined(__i386__)
#include <immintrin.h>
#endif
#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <system_error>

namespace argos {

namespace {

// about 20 us on current machines: longer than the gap between two phases of a busy tick, and
// short enough not to matter between ticks
constexpr int kSpins = 4000;

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

}  // namespace

CThreadPool::CThreadPool(UInt32 threads, std::unique_ptr<CSchedule> schedule, bool pinToCores,
                         const std::function<void()>& startWorker)
    : m_numThreads(std::max<UInt32>(1, threads)),
      m_spin(m_numThreads <= std::thread::hardware_concurrency()),
      m_schedule(std::move(schedule)) {
  try {
    StartWorkers(pinToCores, startWorker);
  } catch (...) {
    StopWorkers();
    throw;
  }
}

CThreadPool::~CThreadPool() {
  StopWorkers();
}

void CThreadPool::StartWorkers(bool pinToCores, const std::function<void()>& startWorker) {
  m_workers.reserve(m_numThreads - 1);
  for (UInt32 thread = 1; thread < m_numThreads; ++thread) {
    m_busy.fetch_add(1, std::memory_order_relaxed);
    try {
      m_workers.emplace_back([this, thread, &startWorker] {
        if (PrepareWorker(startWorker)) {
          WorkerLoop(thread);
        }
      });
    } catch (const std::system_error& error) {
      m_busy.fetch_sub(1, std::memory_order_relaxed);
      WaitForWorkers();
      THROW_ARGOSEXCEPTION("the system started only " << thread << " of " << m_numThreads
                                                      << " threads: " << error.code().message());
    }
    if (pinToCores) {
      Pin(m_workers.back(), thread);
    }
  }
  WaitForWorkers();
  if (m_failure) {
    std::rethrow_exception(m_failure);
  }
}

void CThreadPool::StopWorkers() {
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

bool CThreadPool::PrepareWorker(const std::function<void()>& startWorker) {
  bool good = false;
  try {
    CSignalStack::Use();
    if (startWorker) {
      startWorker();
    }
    LOG.AddThreadSafeBuffer();
    LOGERR.AddThreadSafeBuffer();
    good = true;
  } catch (...) {
    NoteFailure(0);
  }
  // the caller's function is not used after this
  NoteEnd();
  return good;
}

void CThreadPool::Run(size_t items, size_t grain, TCall call, void* context) {
  m_call = call;
  m_context = context;
  m_failure = nullptr;
  m_schedule->Start(items, grain, m_numThreads);
  m_busy.store(m_numThreads - 1, std::memory_order_relaxed);
  m_phase.fetch_add(1, std::memory_order_release);
  m_phase.notify_all();

  DoShare(0);
  WaitForWorkers();
  if (m_failure) {
    std::rethrow_exception(m_failure);
  }
}

void CThreadPool::WorkerLoop(UInt32 thread) {
  for (UInt32 seen = 0;; ++seen) {
    WaitForChange(m_phase, seen, m_spin);
    if (m_stop.load(std::memory_order_relaxed)) {
      return;
    }
    DoShare(thread);
    NoteEnd();
  }
}

void CThreadPool::DoShare(UInt32 thread) {
  size_t begin = 0;
  size_t end = 0;
  while (m_schedule->Next(thread, begin, end)) {
    try {
      m_call(m_context, begin, end, thread);
    } catch (...) {
      NoteFailure(begin);
    }
  }
}

void CThreadPool::Pin(std::thread& worker, UInt32 thread) {
  const UInt32 cores = std::max(1U, std::thread::hardware_concurrency());
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(thread % cores, &set);
  // a refusal costs speed only, so it is not an error
  pthread_setaffinity_np(worker.native_handle(), sizeof(set), &set);
}

}  // namespace argos
