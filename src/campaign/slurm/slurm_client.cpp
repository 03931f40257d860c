#include <argos3/campaign/slurm/slurm_client.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/support/child_process.h>

namespace argos {

bool HasSlurmQueue() {
  return !FindProgram("squeue").empty();
}

void ThrowUnlessHasSlurm() {
  for (const char* program : {"sbatch", "squeue", "scancel"}) {
    if (FindProgram(program).empty()) {
      THROW_ARGOSEXCEPTION(
          program
          << " was not found in PATH, so that no job can be submitted from here: log in to "
             "a login node of the cluster, or install Slurm's commands (Debian: apt install "
             "slurm-client) with the slurm.conf and the munge key of the cluster. submit "
             "--dry-run prints the scripts without Slurm; run executes the campaign on this "
             "computer");
    }
  }
}

std::string QueueJob(const std::string& script, const std::string& after) {
  std::vector<std::string> arguments = {"sbatch", "--parsable"};
  if (!after.empty()) {
    arguments.push_back("--dependency=afterany:" + after);
  }
  arguments.push_back(script);
  const SProgramOutput end = RunProgram(arguments);
  if (!end.IsSuccess) {
    THROW_ARGOSEXCEPTION("Slurm has rejected the job \""
                         << script << "\": " << end.Err
                         << "\nThe attributes and options of <slurm> are in the script's lines "
                            "#SBATCH");
  }
  // "NUMBER" or "NUMBER;CLUSTER"
  return end.Out.substr(0, end.Out.find(';'));
}

std::vector<std::string> ListQueuedJobs(const std::vector<std::string>& jobs) {
  std::vector<std::string> queued;
  for (const std::string& job : jobs) {
    const SProgramOutput end = RunProgram({"squeue", "--noheader", "--format=%i", "--jobs=" + job});
    if (end.IsSuccess && !end.Out.empty()) {
      queued.push_back(job);
    } else if (!end.IsSuccess && end.Err.find("Invalid job id") == std::string::npos) {
      THROW_ARGOSEXCEPTION("squeue has failed: " << end.Err);
    }
  }
  return queued;
}

void CancelJob(const std::string& job) {
  const SProgramOutput end = RunProgram({"scancel", job});
  if (!end.IsSuccess) {
    THROW_ARGOSEXCEPTION("scancel " << job << " has failed: " << end.Err);
  }
}

}  // namespace argos
