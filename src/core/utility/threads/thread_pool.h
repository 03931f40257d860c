#ifndef ARGOS3_CORE_UTILITY_THREADS_THREAD_POOL_H
#define ARGOS3_CORE_UTILITY_THREADS_THREAD_POOL_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/non_copyable.h>
#include <argos3/core/utility/threads/phase_cost.h>
#include <argos3/core/utility/threads/schedule.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace argos {

/**
 * The threads on which every phase of a tick runs.
 *
 * P = 0 or 1 means that the calling thread does everything; otherwise the calling thread and P - 1
 * workers share the items of a phase as the schedule says. A phase ends when all items are done.
 *
 * After fork() the child has only the thread that called it: its next phase starts workers of its
 * own. A child of fork() inside a phase cannot go on, see DoPhase().
 */
class CThreadPool : private CNonCopyable {
 public:
  /**
   * Starts the workers, and returns when all of them wait for the first phase: no worker
   * can then start so late that the end of the program has destroyed static objects.
   *
   * @param threads      P; 0 for none besides the caller.
   * @param schedule     distributes items over threads.
   * @param pinToCores   bind each worker to one core.
   * @param startWorker  run once in each worker before anything else, also in a child of fork().
   * @throws CARGoSException if the system refuses a thread, with its reason; whatever startWorker
   *         throws. No worker is left running.
   */
  CThreadPool(UInt32 threads, std::unique_ptr<CSchedule> schedule, bool pinToCores = false,
              std::function<void()> startWorker = {});
  /** Stops and joins the workers. */
  ~CThreadPool();

  /** Threads that take part in a phase, the caller included; at least 1. */
  UInt32 GetNumThreads() const { return m_numThreads; }

  /**
   * Calls function(begin, end, thread) for chunks of items that together are 0..items-1.
   *
   * Runs on several threads at once. If calls throw, the phase is completed and the exception of
   * the chunk with the lowest items is thrown here: the same one for every number of threads. Does
   * not allocate. Not to be called from inside a phase.
   * @throws CARGoSException if the call has called fork() and returns in the child.
   * @throws CARGoSException if the schedule deals other items than 0..items-1, as far as their
   *         number shows it.
   * @param grain  items that should stay together, >= 1.
   */
  template <typename FUNCTION>
  void ParallelFor(size_t items, size_t grain, FUNCTION&& function) {
    if (items == 0) {
      return;
    }
    if (m_numThreads == 1 || items <= grain) {
      function(size_t(0), items, UInt32(0));
      return;
    }
    const auto call = [](void* context, size_t begin, size_t end, UInt32 thread) {
      (*static_cast<std::remove_reference_t<FUNCTION>*>(context))(begin, end, thread);
    };
    DoPhase(items, grain, call, const_cast<void*>(static_cast<const void*>(&function)));
  }

  /**
   * The same with chunks whose length follows from the measured cost of the phase, if it is
   * not fixed. Measures what the calling thread does.
   */
  template <typename FUNCTION>
  void ParallelFor(size_t items, CPhaseCost& cost, FUNCTION&& function) {
    const size_t grain = cost.ChooseGrain(items, m_numThreads);
    if (m_numThreads == 1 || !cost.IsMeasured()) {
      ParallelFor(items, grain, function);
      return;
    }
    using TClock = std::chrono::steady_clock;
    size_t numDone = 0;
    TClock::duration time{0};
    ParallelFor(items, grain, [&](size_t begin, size_t end, UInt32 thread) {
      if (thread != 0) {
        function(begin, end, thread);
        return;
      }
      const TClock::time_point start = TClock::now();
      function(begin, end, thread);
      time += TClock::now() - start;
      numDone += end - begin;
    });
    cost.Add(numDone, std::chrono::duration<Real>(time).count());
  }

  /**
   * Whether phases with more than one chunk are shared whatever they cost. By default the calling
   * thread does a phase alone where, by measurement, other threads would cost more than they save;
   * builds with invariants or for ThreadSanitizer always share, so that tests reach the threads.
   */
  void SetSharesAlways(bool always) { m_sharesAlways = always; }

 private:
  using TCall = void (*)(void* context, size_t begin, size_t end, UInt32 thread);

  /** A phase, told from others by what is called. */
  struct SPhase {
    TCall Call;
    CSharingCost Cost;
  };

  void DoPhase(size_t items, size_t grain, TCall call, void* context);
  void Share(size_t items, size_t grain, TCall call, void* context, CSharingCost& cost);
  CSharingCost& FindCost(TCall call);
  void StartWorkers();
  void StopWorkers();
  bool IsOfParent() const;
  void ForgetWorkersOfParent();
  void RestartWorkers();
  void RequireSameProcess() const;
  bool PrepareWorker();
  void WorkerLoop(UInt32 thread);
  void WaitForWorkers();
  void NoteEnd();
  void NoteFailure(size_t begin);
  size_t DoShare(UInt32 thread);
  size_t DoChunks(UInt32 thread);
  void RequireAllDealt() const;
  void Pin(std::thread& worker, UInt32 thread);

  UInt32 m_numThreads;
  UInt32 m_numForks;  // count in the process, when the workers started
  bool m_pinToCores;
  bool m_spin;  // is true only if every thread has a core of its own
  std::unique_ptr<CSchedule> m_schedule;
  std::function<void()> m_startWorker;
  std::vector<std::thread> m_workers;
  bool m_sharesAlways = false;
  std::vector<SPhase> m_phases;  // never grows beyond its capacity: a phase does not allocate

  // written by DoPhase() before the phase number grows, read by the workers after
  TCall m_call = nullptr;
  void* m_context = nullptr;
  size_t m_items = 0;
  std::atomic<size_t> m_numDealt{0};  // items, of the schedule, in this phase
  std::atomic<UInt32> m_phase{0};
  std::atomic<UInt32> m_busy{0};  // workers that have not finished: their start, then a phase
  std::atomic<bool> m_stop{false};

  // the failure of the lowest items, if any; locked only when a chunk is about to end
  std::mutex m_failureMutex;
  std::exception_ptr m_failure;
  size_t m_failureBegin = 0;
};

}  // namespace argos

#endif
