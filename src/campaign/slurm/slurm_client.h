#ifndef ARGOS3_CAMPAIGN_SLURM_SLURM_CLIENT_H
#define ARGOS3_CAMPAIGN_SLURM_SLURM_CLIENT_H

#include <string>
#include <vector>

namespace argos {

// The commands of Slurm. Their failures are CARGoSExceptions with the message of Slurm.

/** @throws CARGoSException if sbatch or squeue is not in PATH; the text says what to do. */
void ThrowUnlessHasSlurm();

/** @return true if squeue is in PATH. */
bool HasSlurmQueue();

/**
 * Queues a job script (sbatch).
 * @param after  the job waits until all tasks of this one have ended, however; empty: none.
 * @return the job's number.
 */
std::string QueueJob(const std::string& script, const std::string& after = "");

/** @return those of the jobs that wait or run (squeue). Jobs that Slurm has forgotten have ended.
 */
std::vector<std::string> ListQueuedJobs(const std::vector<std::string>& jobs);

/** Removes a job from the queue (scancel). */
void CancelJob(const std::string& job);

}  // namespace argos

#endif
