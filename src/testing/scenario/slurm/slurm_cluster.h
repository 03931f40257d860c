#ifndef ARGOS3_TESTING_SCENARIO_SLURM_SLURM_CLUSTER_H
#define ARGOS3_TESTING_SCENARIO_SLURM_SLURM_CLUSTER_H

#include "../command_line/program_run.h"

#include <sys/types.h>

#include <string>
#include <vector>

namespace argos {

/** @return the names of Slurm's and munge's programs that are missing; empty: all are there. */
std::string ListMissingPrograms();

/**
 * A Slurm cluster of this computer with one node of four (claimed) processors: munged, slurmctld
 * and slurmd as children of this process, in a private folder with own ports, run by the current
 * user. SLURM_CONF is set during its lifetime.
 *
 * The destructor ends all of it, also the processes of jobs. Should this process be killed, the
 * daemons are, too.
 */
class CSlurmCluster {
 public:
  /** @throws (a failed REQUIRE) if the node is not ready in time; with the daemons' logs. */
  CSlurmCluster();
  ~CSlurmCluster();
  CSlurmCluster(const CSlurmCluster&) = delete;
  CSlurmCluster& operator=(const CSlurmCluster&) = delete;

  /** Waits until no job is in the queue. @return false if that takes too long. */
  bool AwaitEmptyQueue() const;
  /** Runs a command of Slurm. @return its exit status and what it printed. */
  SProgramRun Command(const std::string& command) const;
  std::string ReadLogs() const;

 private:
  void WriteConfiguration() const;
  void Start(const std::vector<std::string>& arguments);

  CTestFolder m_folder;
  std::vector<pid_t> m_daemons;
};

}  // namespace argos

#endif
