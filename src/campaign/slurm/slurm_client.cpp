#include <argos3/campaign/slurm/slurm_client.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/support/child_process.h>

#include <spawn.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <sstream>

extern char** environ;

namespace argos {

namespace {

using TFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

struct SCommandEnd {
  bool IsSuccess = false;
  std::string Out, Err;  // without line breaks at the end
};

std::string ReadAll(std::FILE* file) {
  std::rewind(file);
  std::string text;
  std::array<char, 4096> block{};
  for (size_t size = 0; (size = std::fread(block.data(), 1, block.size(), file)) > 0;) {
    text.append(block.data(), size);
  }
  text.erase(text.find_last_not_of('\n') + 1);
  return text;
}

TFile OpenTemporaryFile() {
  TFile file(std::tmpfile(), &std::fclose);
  if (file == nullptr) {
    THROW_ARGOSEXCEPTION("no temporary file can be created: " << std::strerror(errno));
  }
  return file;
}

// what the program prints goes to files, so that a full pipe cannot stop it
SCommandEnd RunCommand(const std::vector<std::string>& arguments) {
  const TFile out = OpenTemporaryFile();
  const TFile err = OpenTemporaryFile();
  std::vector<char*> argv;
  for (const std::string& argument : arguments) {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(out.get()), 1);
  posix_spawn_file_actions_adddup2(&actions, fileno(err.get()), 2);
  pid_t child = -1;
  const int error = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    THROW_ARGOSEXCEPTION(arguments[0] << " cannot be started: " << std::strerror(error));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  SCommandEnd end;
  end.IsSuccess = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  end.Out = ReadAll(out.get());
  end.Err = ReadAll(err.get());
  return end;
}

}  // namespace

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
  const SCommandEnd end = RunCommand(arguments);
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
    const SCommandEnd end = RunCommand({"squeue", "--noheader", "--format=%i", "--jobs=" + job});
    if (end.IsSuccess && !end.Out.empty()) {
      queued.push_back(job);
    } else if (!end.IsSuccess && end.Err.find("Invalid job id") == std::string::npos) {
      THROW_ARGOSEXCEPTION("squeue has failed: " << end.Err);
    }
  }
  return queued;
}

void CancelJob(const std::string& job) {
  const SCommandEnd end = RunCommand({"scancel", job});
  if (!end.IsSuccess) {
    THROW_ARGOSEXCEPTION("scancel " << job << " has failed: " << end.Err);
  }
}

}  // namespace argos
