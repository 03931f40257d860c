#ifndef ARGOS3_CAMPAIGN_STORE_RESULT_STORE_H
#define ARGOS3_CAMPAIGN_STORE_RESULT_STORE_H

#include <argos3/campaign/design/campaign.h>
#include <argos3/campaign/execution/run_result.h>
#include <argos3/core/utility/non_copyable.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace argos {

/** A finished run in the store. */
struct SStoredRun {
  UInt64 Id = 0;
  UInt32 Combination = 0; /**< id in the store */
  UInt32 Seed = 0;
  UInt32 Generation = 0;
  UInt32 Attempt = 1; /**< 2: it was retried once; counted by the store */
  std::string Started; /**< UTC, ISO 8601 */
  std::string Machine, Version; /**< host name; version and build of the simulator */
  SRunResult Result; /**< series only where a function says so */
};

/** A combination in the store. */
struct SStoredCombination {
  UInt32 Id = 0;
  std::string Key; /**< SCombination::ComputeKey() */
  std::vector<std::string> Values; /**< (factors of the store) */
};

/**
 * The results of a campaign: one SQLite database, usually in WAL mode.
 *
 * Tables: campaign(key, value), generations(id, digest, experiment, libraries, started),
 * factors(id, name), combinations(id, key, number), combination_values(combination, factor, value,
 * level; the value, as a number if it is one),
 * runs(id, combination, seed, generation, attempt, status, exit_status, signal, start_up, wall,
 * cpu, total_wall, memory, ticks, robots, digest, log, log_bytes, started, machine, version),
 * metrics(run, name, unit, value), series(run, name, tick, value), collected(id, is_series, name,
 * unit; what the newest generation has); and the view results: a row for each run of the newest
 * generation, with a column for each factor and each metric.
 *
 * A run is stored by one transaction together with its metrics, so that a killed program loses or
 * doubles none. Not thread safe.
 */
class CResultStore : private CNonCopyable {
 public:
  enum class EMode {
    ReadOnly,
    Write,
    /**
     * For a folder that several computers share: while this object exists, others can read. The
     * WAL mode needs memory that all processes share, which those of several computers cannot; so
     * the database has a rollback journal, which needs only locks of the file system.
     */
    WriteShared
  };

  /**
   * Opens or, for writing, creates a database.
   * @throws CARGoSException if it is none of a campaign, of another version, or not writable; for
   *   writing also if another program has it open for writing (host and pid in the text).
   */
  CResultStore(const std::string& file, EMode mode);
  ~CResultStore();

  /**
   * Registers the campaign: its factors, combinations and experiment.
   * @param acceptChange  starts a new generation if the experiment has changed.
   * @throws CARGoSException if the database has other factors, or, without acceptChange, if the
   *   experiment has changed since the newest generation; the text says in which line.
   * @return warnings, one a line: libraries or scripts have changed, the campaign collects other
   *   metrics than before, or has no longer some of the combinations that were run. Else empty.
   */
  std::string Register(const SCampaign& campaign, bool acceptChange);

  /** Of the newest generation: (combination, seed) that need not be run again. */
  bool IsStored(const std::string& combinationKey, UInt32 seed) const;
  /** The id that a combination has. @throws CARGoSException if it is not registered. */
  UInt32 GetCombinationId(const std::string& combinationKey) const;
  /**
   * Adds runs to the newest generation, in one transaction. Runs that are stored already are
   * replaced (retry). Interrupted ones are left out. Id, Generation and Attempt are not used.
   */
  void Add(const std::vector<SStoredRun>& runs);

  /**
   * For a store that is written: checks that its file is still there. Results go to the file that
   * was opened, so those that are added after its removal would be lost at the end.
   * @throws CARGoSException if it was removed, renamed or replaced.
   */
  void ThrowIfRemoved() const;

  std::vector<std::string> ListFactors() const;
  std::vector<SStoredCombination> ListCombinations() const;
  /** Of the newest generation, by combination and seed; without metrics, series and logs. */
  std::vector<SStoredRun> ListRuns() const;
  /** A run with metrics and log. */
  std::optional<SStoredRun> FindRun(UInt64 id) const;
  std::vector<std::string> ListMetrics() const;
  std::vector<std::string> ListSeries() const;

  /** A value of a metric in a run of the newest generation; NaN: missing. */
  struct SValue {
    UInt32 Combination, Seed;
    Real Value;
  };
  /** Of runs that are done (or robots_stopped), by combination and seed. */
  std::vector<SValue> ReadMetric(const std::string& name) const;
  struct SSeriesOfRun {
    UInt32 Combination, Seed;
    SMetricSeries Series;
  };
  std::vector<SSeriesOfRun> ReadSeries(const std::string& name) const;

  /** Reads a series value by value, in the order of ReadSeries(), without keeping it in memory. */
  void ForEachPoint(const std::string& name,
                    const std::function<void(UInt32 combination, UInt32 seed, UInt32 tick,
                                             Real value)>& use) const;
  /** The unit of a metric, or of a series; empty if it has none. */
  std::string GetUnit(const std::string& name, bool isSeries) const;
  /** Of generations before the newest. */
  UInt64 CountOlderRuns() const;

  /**
   * Copies the runs of another database of the same campaign, in one transaction; equal
   * (generation, combination, seed) once: one that is done replaces one that is not.
   * @return the number of runs that were copied.
   * @throws CARGoSException if it is of other factors or of another experiment.
   */
  UInt64 Merge(const std::string& otherFile);

  /**
   * Text of the table campaign; empty if there is none: "name", "file", "text" (of the campaign
   * file), "experiment_file", "collect".
   */
  std::string GetText(const std::string& key) const;

 private:
  struct SDatabase;
  std::unique_ptr<SDatabase> m_database;
};

}  // namespace argos

#endif
