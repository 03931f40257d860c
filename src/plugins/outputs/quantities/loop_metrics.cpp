// Built-in metrics of what the main loop costs: time, processors and memory.

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/space/built_in_metric.h>
#include <argos3/core/simulator/space/metrics.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/processes/cpu_time.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string>

namespace argos {

namespace {

using TWallClock = std::chrono::steady_clock;

/*
 * The time that the loop has taken. It is measured for all metrics together, so that these fit.
 * Reading the processor time takes about as long as half a tick of one robot, which would change
 * the wall time: so several such ticks share a measurement.
 */
class CLoopMeter : public CSpaceExtension {
 public:
  struct SUse {
    Real Simulated = 0.0, WallTime = 0.0, CPUTime = 0.0;  // s, since the start
  };

  void Attach(const SSimulationContext& context) { m_context = &context; }
  // the last measurement before a tick is the start
  void Reset() { m_isRunning = false; }

  // the processor time of a single thread is at most the wall time: it is read inside of it
  const SUse& Measure() {
    const UInt32 tick = *m_context->Clock;
    // the loop has not begun while the metrics of the first state are computed
    if (!m_isRunning || tick == m_firstTick) {
      m_isRunning = true;
      m_firstTick = tick;
      m_use = {};
      m_start = TWallClock::now();
      m_startCPUTime = GetProcessCPUTime();
      m_next = m_start + kPause;
    } else if (tick != m_tick && TWallClock::now() >= m_next) {
      m_use.Simulated = (tick - m_firstTick) * m_context->TickLength;
      m_use.CPUTime = GetProcessCPUTime() - m_startCPUTime;
      const TWallClock::time_point now = TWallClock::now();
      m_use.WallTime = std::chrono::duration<Real>(now - m_start).count();
      m_next = now + kPause;
    }
    m_tick = tick;
    return m_use;
  }

 private:
  static constexpr std::chrono::microseconds kPause{20};

  const SSimulationContext* m_context = nullptr;
  bool m_isRunning = false;
  UInt32 m_firstTick = 0;
  UInt32 m_tick = 0;  // tick of m_use
  TWallClock::time_point m_start;
  TWallClock::time_point m_next;  // no measurement before
  Real m_startCPUTime = 0.0;
  SUse m_use;
};

class CLoopMetric : public CBuiltInMetric {
 public:
  void Init(CSpace& space) override {
    m_meter = &space.GetExtension<CLoopMeter>();
    m_meter->Attach(space.GetContext());
  }
  void Reset() override { m_meter->Reset(); }
  bool IsReproducible() const override { return false; }
  Real Compute() override { return ComputeFrom(m_meter->Measure()); }

 protected:
  virtual Real ComputeFrom(const CLoopMeter::SUse& use) = 0;

 private:
  CLoopMeter* m_meter = nullptr;
};

class CRealTimeFactor : public CLoopMetric {
 protected:
  Real ComputeFrom(const CLoopMeter::SUse& use) override {
    return use.Simulated > 0.0 ? use.Simulated / use.WallTime : CMetrics::kNone;
  }
};

class CLoopWallTime : public CLoopMetric {
 public:
  std::string GetUnit() const override { return "s"; }

 protected:
  Real ComputeFrom(const CLoopMeter::SUse& use) override { return use.WallTime; }
};

class CLoopCPUTime : public CLoopMetric {
 public:
  std::string GetUnit() const override { return "s"; }

 protected:
  Real ComputeFrom(const CLoopMeter::SUse& use) override { return use.CPUTime; }
};

class CSpeedup : public CLoopMetric {
 protected:
  Real ComputeFrom(const CLoopMeter::SUse& use) override {
    return use.WallTime > 0.0 ? use.CPUTime / use.WallTime : CMetrics::kNone;
  }
};

using TFileStart = std::array<char, 256>;

// the first bytes of a file of the system, ending with 0; empty if it cannot be read
TFileStart ReadStart(const char* name) {
  TFileStart text{};
  const int file = open(name, O_RDONLY | O_CLOEXEC);
  if (file >= 0) {
    const ssize_t length = read(file, text.data(), text.size() - 1);
    text[static_cast<size_t>(std::max<ssize_t>(length, 0))] = '\0';
    close(file);
  }
  return text;
}

constexpr const char* kMemoryFile = "/proc/self/statm";  // Linux: pages in all, resident, ...

// MB; nothing if the system does not tell
std::optional<Real> ReadResidentMemory() {
  unsigned long long pages = 0;
  if (std::sscanf(ReadStart(kMemoryFile).data(), "%*u %llu", &pages) != 1) {
    return std::nullopt;
  }
  return static_cast<Real>(pages) * static_cast<Real>(sysconf(_SC_PAGESIZE)) / 1e6;
}

// Linux, proc(5): user, nice, system, idle, iowait, irq, softirq, steal, ... of all processors
constexpr const char* kProcessorFile = "/proc/stat";

// s, of all processors, since the system was started; nothing if the system does not tell
std::optional<Real> ReadBusyTime() {
  unsigned long long user = 0, nice = 0, system = 0, irq = 0, softIrq = 0, steal = 0;
  if (std::sscanf(ReadStart(kProcessorFile).data(), "cpu %llu %llu %llu %*u %*u %llu %llu %llu",
                  &user, &nice, &system, &irq, &softIrq, &steal) != 6) {
    return std::nullopt;
  }
  return static_cast<Real>(user + nice + system + irq + softIrq + steal) /
         static_cast<Real>(sysconf(_SC_CLK_TCK));
}

class COtherLoad : public CBuiltInMetric {
 public:
  void Init(CSpace& space) override {
    if (!ReadBusyTime()) {
      THROW_ARGOSEXCEPTION("the system does not tell how busy it is: \""
                           << kProcessorFile << "\" cannot be read: " << std::strerror(errno));
    }
    m_clock = space.GetContext().Clock;
  }
  void Reset() override { m_isRunning = false; }
  bool IsReproducible() const override { return false; }

  Real Compute() override {
    const TWallClock::time_point now = TWallClock::now();
    // while the metrics of the first state are computed, the loop has not begun
    if (!m_isRunning || *m_clock == m_firstTick) {
      m_isRunning = true;
      m_firstTick = *m_clock;
      m_start = now;
      m_next = now + kMinTime;
      m_startTime = ReadOthersTime();
      m_value = CMetrics::kNone;
    } else if (now >= m_next) {
      m_next = now + kPause;
      // the system counts in hundredths of a second, some of them late
      m_value = std::max(
          (ReadOthersTime() - m_startTime) / std::chrono::duration<Real>(now - m_start).count(),
          0.0);
    }
    return m_value;
  }

 private:
  static constexpr std::chrono::milliseconds kMinTime{500};
  // a reading takes as long as a tick of some hundred robots
  static constexpr std::chrono::milliseconds kPause{100};

  // s, of processors that did not work for this process
  static Real ReadOthersTime() {
    const Real busy = ReadBusyTime().value_or(CMetrics::kNone);
    return busy - GetProcessCPUTime();
  }

  const UInt32* m_clock = nullptr;
  bool m_isRunning = false;
  UInt32 m_firstTick = 0;
  TWallClock::time_point m_start;
  TWallClock::time_point m_next;  // no reading before
  Real m_startTime = 0.0;
  Real m_value = CMetrics::kNone;
};

class CResidentMemory : public CBuiltInMetric {
 public:
  void Init(CSpace&) override {
    if (!ReadResidentMemory()) {
      THROW_ARGOSEXCEPTION("the system does not tell the memory of a process: \""
                           << kMemoryFile << "\" cannot be read: " << std::strerror(errno));
    }
  }
  void Reset() override { m_isRead = false; }
  std::string GetUnit() const override { return "MB"; }
  bool IsReproducible() const override { return false; }

  Real Compute() override {
    const TWallClock::time_point now = TWallClock::now();
    if (!m_isRead || now >= m_next) {
      m_value = ReadResidentMemory().value_or(CMetrics::kNone);
      m_isRead = true;
      m_next = now + kPause;
    }
    return m_value;
  }

 private:
  // a reading takes longer than a tick of one robot, and would change what other metrics measure
  static constexpr std::chrono::milliseconds kPause{1};

  bool m_isRead = false;
  Real m_value = CMetrics::kNone;
  TWallClock::time_point m_next;
};

// the end of a manual. @param metrics  of the example
std::string NotReproducible(const std::string& metrics) {
  return R"(
This metric is not reproducible: another run of the same experiment has other values. So has its recording.

  <metrics file="metrics.csv" builtin=")" +
         metrics + "\" />\n";
}

}  // namespace

REGISTER_BUILT_IN_METRIC(
    CRealTimeFactor, "real_time_factor", "the authors of this project", "1.0",
    "Simulated time over wall time, since the start of the run.",
    R"(Both times are over the span of loop_wall_time. There is no value before the first tick.
)" + NotReproducible("real_time_factor"),
    "Usable")
REGISTER_BUILT_IN_METRIC(
    CLoopWallTime, "loop_wall_time", "the authors of this project", "1.0",
    "The wall time of the main loop so far, s.",
    R"(It begins when the experiment is loaded or reset, or at the tick after which the first metric of the loop is enabled
(loop_wall_time, loop_cpu_time, speedup, real_time_factor), and ends with the last tick. So loading and the end of the program
are excluded; what outputs and the program do between ticks is included. It is measured at most every 20 us, so as not to slow
short ticks down: so it may be that old.
)" + NotReproducible("loop_wall_time"),
    "Usable")
REGISTER_BUILT_IN_METRIC(
    CLoopCPUTime, "loop_cpu_time", "the authors of this project", "1.0",
    "The processor time that the process used during the main loop so far, s.",
    R"(User and system time of all threads of the process, over the same span as loop_wall_time. Threads of other simulations in
the process and of outputs are included. So is the time in which threads of the pool spin while they wait for each other.
)" + NotReproducible("loop_cpu_time"),
    "Usable")
REGISTER_BUILT_IN_METRIC(
    CSpeedup, "speedup", "the authors of this project", "1.0",
    "loop_cpu_time over loop_wall_time: the processors that were busy, on average.",
    R"(The measure u of C. Pinciroli's thesis, chapter 5: at most 1 without threads. It tells how far processors were used, not how
much faster the run was. There is no value before the first tick.
)" + NotReproducible("loop_wall_time, loop_cpu_time, speedup"),
    "Usable")
REGISTER_BUILT_IN_METRIC(
    COtherLoad, "other_load", "the authors of this project", "1.0",
    "The processors that other programs kept busy during the main loop, on average.",
    R"(0 on an idle machine, 1 if others used one processor all the time. It tells which measurements of time were disturbed:
`argos3-campaign retry FILE --where "other_load > 0.1"` repeats them. Time that the host of a virtual machine took away counts.
Linux only, and of the whole computer, not of a container. It has no value in the first half second of wall time, because the
system counts in hundredths of a second, and is read at most ten times a second.
)" + NotReproducible("loop_wall_time, other_load"),
    "Usable")
REGISTER_BUILT_IN_METRIC(
    CResidentMemory, "resident_memory", "the authors of this project", "1.0",
    "The memory of the process that is in RAM, MB (10^6 bytes).",
    R"(The resident set size, not its peak: of the program, its libraries, the experiment, and all else in the process. Linux only.
It is read at most every millisecond, and may be that old.
)" + NotReproducible("resident_memory"),
    "Usable")

}  // namespace argos
