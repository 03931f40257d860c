#ifndef ARGOS3_CORE_SIMULATOR_SPACE_METRICS_H
#define ARGOS3_CORE_SIMULATOR_SPACE_METRICS_H

#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <exception>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace argos {

class CBuiltInMetric;
class CRobotRecords;
struct SSimulationContext;

/**
 * The metrics of a run: named numbers, such as the number of objects retrieved. Loop functions and
 * robots record them, the program computes those that are built in, and outputs write all of them
 * once a tick. simulator.GetMetrics() returns them.
 *
 * What is recorded in a tick (all with the same clock) is reduced in this order: actuators,
 * PreStep(), sensors and controllers, PostStep(); robots in their order in the space; and what one
 * robot, or a hook, records, in the order of its calls. So the results are equal, to the bit, for
 * any number of threads and any schedule.
 *
 * What is recorded when the tick is over, such as in PostExperiment(), is reduced separately, and
 * replaces what was recorded in the tick: outputs then have it in the row of this tick.
 */
class CMetrics : public CSpaceExtension {
 public:
  static constexpr Real kNone = std::numeric_limits<Real>::quiet_NaN();

  struct SMetric {
    std::string Name;
    std::string Unit; /**< empty for numbers without a unit */
    /** Mean of what was recorded in Tick; NaN: none since the start or the last reset. */
    Real Value = kNone;

    // values that were recorded in Tick
    UInt32 Tick = 0; /**< the last in which it was recorded; 0 before the first tick */
    UInt64 Period = 0; /**< period in which it was recorded, see EndTick() */
    UInt64 Count = 0; /**< 0: nothing, and NaN below */
    Real Sum = kNone; /**< sum in the order above */
    Real Min = kNone;
    Real Max = kNone;
    Real Last = kNone;

    bool IsBuiltIn = false;
    /** False if another run of the same experiment gives other values: real_time_factor. */
    bool IsReproducible = true;
  };

  CMetrics();
  ~CMetrics() override;

  /**
   * Adds to what was recorded in this tick; creates the metric at the first call. Its value is then
   * the mean of what was recorded in this tick, until a tick in which it is recorded again. A
   * metric that robots create in the same phase gets its place when the phase ends, in their order.
   *
   * For robots, which call it on several threads at a time, and on the main thread for hooks of the
   * loop functions and between ticks. Allocates nothing once the metric exists.
   *
   * @param name  letters, digits and '_', beginning with a letter; not that of a column that every
   *   table of metrics has, see IsReserved().
   * @param unit  such as "m"; empty: as in the call that created the metric.
   * @throws CARGoSException if the name is none, reserved, or that of a built-in metric, if the
   *   unit has changed, if the value is NaN or infinite; if an engine or a medium calls it. If the
   * calls that create a metric differ in the unit, the robots of the later ones fail, see EOnError.
   */
  void Record(std::string_view name, Real value, std::string_view unit = {});

  /**
   * The same, but replaces what was recorded in this tick. The value may be NaN: none.
   * @throws CARGoSException as Record(), and if a robot calls it.
   */
  void Set(const std::string& name, Real value, const std::string& unit = "");

  /** In order of creation; metrics are never removed. */
  const std::vector<SMetric>& GetAll() const { return m_metrics; }
  /** Null if there is no such metric. */
  const SMetric* Find(std::string_view name) const;

  /** @return true for run, tick, time, robots and stopped: columns of each table of metrics. */
  static bool IsReserved(std::string_view name);

  /** The names of all built-in metrics, in alphabetical order. `argos3 -q` describes them. */
  static std::vector<std::string> ListBuiltIns();
  /**
   * Has a built-in metric computed from now on: at once, after each tick and each reset. Does
   * nothing if that is done already. In a replay values are those that were recorded: warns if
   * there are none. To be called when the arena is filled, such as between loading and the run, or
   * in Init() of loop functions and outputs.
   * @throws CARGoSException with the nearest names if there is no such metric; if the experiment
   *   has not what it is computed from; if code has recorded a metric of that name.
   */
  void EnableBuiltIn(const std::string& name);

  /** Forgets the values; called by CSimulator::Reset(), before robots and loop functions. */
  void ForgetValues();

  // For the simulator.

  /** To be called when an experiment is loaded. Without it there are no ticks and no robots. */
  void Attach(SSimulationContext& context) { m_context = &context; }
  /** Computes the built-in metrics of this tick. @throws CARGoSException with the metric. */
  void UpdateBuiltIns();
  /** The tick is over: what is recorded from now on replaces what was recorded in it. */
  void EndTick() { ++m_period; }
  /** @return true if something was recorded since the last tick was over. */
  bool HasLateRecords() const;
  /** For loops over robots, see CRobotRecords. */
  CRobotRecords& GetRobotRecords() { return *m_records; }
  /** A robot whose records cannot be used. */
  struct SFailure {
    size_t Robot; /**< its number in the loop */
    std::exception_ptr Error;
  };
  /** To be called at the end of a loop over robots. @return one per robot, in their order. */
  const std::vector<SFailure>& TakeRobotRecords();

 private:
  struct SBuiltIn {
    std::unique_ptr<CBuiltInMetric> Metric;
    size_t Number;  // index in m_metrics
  };

  // numbers in m_metrics
  static constexpr size_t kUnknown = ~size_t(0);
  size_t FindNumber(std::string_view name) const;
  size_t GetOrCreate(std::string_view name, std::string_view unit);
  size_t Create(std::string_view name, std::string_view unit);
  void Check(size_t number, std::string_view unit) const;

  UInt32 GetTick() const;
  void Add(SMetric& metric, Real value) const;
  void Replace(SMetric& metric, Real value) const;
  void Update(const SBuiltIn& builtIn);

  SSimulationContext* m_context = nullptr;
  UInt64 m_period = 0;  // number of ticks that are over
  std::vector<SMetric> m_metrics;
  std::map<std::string, size_t, std::less<>> m_numbers;  // indices by name; not written in a phase
  std::unique_ptr<CRobotRecords> m_records;
  std::vector<SFailure> m_failures;  // failures of the last loop
  std::vector<SBuiltIn> m_builtIns;  // have the order in which they were enabled
};

}  // namespace argos

#endif
