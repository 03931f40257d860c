#ifndef ARGOS3_CAMPAIGN_DESIGN_CAMPAIGN_H
#define ARGOS3_CAMPAIGN_DESIGN_CAMPAIGN_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>
#include <utility>
#include <vector>

namespace argos {

/** An attribute of the experiment and its value, as for `argos3 --set`. */
struct SSetting {
  std::string Path, Value;
};

/** One of the values of a factor. */
struct SLevel {
  std::string Value; /**< is what reports show; "{...}": a Lua expression of factors before it */
  std::vector<SSetting> Settings; /**< "{...}" in values: Lua expressions of the factors */
};

/** What is varied. */
struct SFactor {
  std::string Name; /**< letters, digits and '_', beginning with a letter */
  std::vector<SLevel> Levels;
  bool SetsThreads = false; /**< sets threads and nothing else: results do not depend on it */
};

/** One level of each factor. */
struct SCombination {
  std::vector<std::string> Values; /**< (factors), expressions replaced by their values */
  std::vector<SSetting> Settings; /**< settings of all factors; values replace expressions */

  /**
   * "path=value" lines in the order of the settings: two combinations with equal text are the same.
   * Line breaks in values are written as "&#10;".
   */
  std::string ComputeKey() const;
};

/** When a combination has enough runs. */
struct SStopping {
  std::vector<UInt32> Seeds; /**< all of these, unless Metric is set */
  std::string Metric; /**< sequential: until the interval of its mean is narrow enough */
  Real Level = 0.95;
  Real Width = 0.0; /**< width of the whole interval; 0: Relative counts */
  Real Relative = 0.0; /**< half the width over the mean */
  UInt32 MinRuns = 10, MaxRuns = 1000;
  UInt32 FirstSeed = 1; /**< sequential: seeds FirstSeed, FirstSeed + 1, ... */
};

/** What a run may use. */
struct SRunLimits {
  Real WallTime = 0.0; /**< s; 0: no limit */
  UInt64 Memory = 0; /**< address space, bytes; 0: no limit */
  UInt64 Output = 10 << 20; /**< bytes on standard output and error; the rest is dropped */
};

/** Runs at the same time. */
constexpr UInt32 kMaxJobs = 4096;

/** What runs are executed in: "process" and "thread" in XML. */
enum class EIsolation {
  OwnProcess, /**< each run in a process */
  SharedProcess /**< runs one after another in the process of a worker */
};
enum class EKeptFiles { None, Failed, All };

/** A metric to be collected. */
struct SCollectedMetric {
  enum class ESource { Metric, BuiltIn, File };
  enum class EReduction { Last, Mean, Sum, Min, Max };

  std::string Name;
  ESource Source = ESource::Metric;
  EReduction Reduction = EReduction::Last; /**< reduces the ticks of a run */
  bool IsSeries = false;
  UInt32 Every = 1; /**< ticks */
  std::string Library; /**< library of a built-in metric of a plug-in; may be empty */
  std::string Pattern, TimeColumn, ValueColumn; /**< describe a file */
};

/** A figure of the report. */
struct SFigure {
  static constexpr UInt32 kMinSide = 100, kMaxSide = 4000; /**< width and height, pixels */
  std::string Kind; /**< a name of kFigureKinds */
  std::vector<std::pair<std::string, std::string>> Attributes; /**< are those of the file */
  int Line = 0; /**< line in the campaign file, for messages */
};

/** A comparison of the levels of a factor. */
struct SComparison {
  std::string Metric, Factor;
  bool IsPaired = false; /**< pairs values by seed */
  int Line = 0;
};

struct SSlurmSettings {
  UInt32 Tasks = 1;
  UInt32 Jobs = 1; /**< runs of a task at the same time, each on a processor */
  UInt32 Resubmissions = 2; /**< repeats runs that are missing after all tasks have ended */
  std::string Partition, Account, TimeLimit, MemoryPerTask; /**< empty: what Slurm gives */
  std::vector<std::string> Options; /**< further lines "#SBATCH ..." */
};

/** A campaign file, checked, with all its combinations. */
struct SCampaign {
  std::string File; /**< path of the campaign file */
  std::string Text; /**< its contents */
  std::string Title; /**< title of reports; empty: the name of the file */
  std::string ExperimentFile; /**< path */
  std::string ExperimentSource; /**< contents of that file */
  /** with Constants, without factors: what a run depends on besides its combination and its seed */
  std::string ExperimentText;
  std::string ResultsFile; /**< path of the database */
  std::vector<SSetting> Constants;
  std::vector<SFactor> Factors;
  std::vector<SCombination> Combinations; /**< do not contain the excluded ones */
  UInt32 NumExcluded = 0;
  SStopping Stopping;
  SRunLimits Limits;
  UInt32 Jobs = 0; /**< runs at the same time; 0: as many as there are processors */
  EIsolation Isolation = EIsolation::OwnProcess;
  UInt32 Threads = 0; /**< threads of each run whose combination sets no other number */
  EKeptFiles Kept = EKeptFiles::Failed;
  std::vector<SCollectedMetric> Metrics; /**< empty: all that a run sets */
  std::vector<SFigure> Figures;
  std::vector<SComparison> Comparisons;
  SSlurmSettings Slurm;
  std::vector<std::string> Warnings; /**< "file:line: <tag>: ...", for the log */

  /** The names of Factors. */
  std::vector<std::string> ListFactors() const;
};

/** The built-in metrics that need no library of a user. */
const std::vector<std::string>& ListBuiltInMetrics();

/**
 * Reads a campaign file.
 * @throws CARGoSException that lists all errors of the file, with lines: also factors whose paths
 *   match nothing in the experiment, or that set an attribute twice or the seed.
 */
SCampaign ReadCampaign(const std::string& file);

}  // namespace argos

#endif
