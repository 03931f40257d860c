#include "campaign_run.h"

#include <argos3/campaign/store/result_store.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/testing/support/paths.h>

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <thread>

namespace argos {

std::vector<std::string> ReadTable(const std::string& database) {
  const CResultStore store(database, CResultStore::EMode::ReadOnly);
  std::map<UInt32, std::string> keys;
  for (const SStoredCombination& combination : store.ListCombinations()) {
    keys[combination.Id] = combination.Key;
  }
  std::vector<std::string> lines;
  for (const SStoredRun& listed : store.ListRuns()) {
    const std::optional<SStoredRun> run = store.FindRun(listed.Id);
    REQUIRE(run);
    const SRunResult& result = run->Result;
    std::string line = fmt::format("{}seed={:05} {} {} {} {} {:016x}", keys.at(run->Combination),
                                   run->Seed, ToText(result.Status), result.ExitStatus,
                                   result.Signal, result.Ticks, result.Digest);
    for (const SMetricValue& metric : result.Metrics) {
      line += fmt::format(" {}={:a}{}", metric.Name, metric.Value, metric.Unit);
    }
    lines.push_back(line);
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

pid_t StartCampaign(const CTestFolder& folder, const std::vector<std::string>& arguments) {
  const std::string program = InBuildTree("bin/argos3-campaign");
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);
  const std::string path = folder.Path(".");
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const int null = open("/dev/null", O_RDWR);
    dup2(null, STDOUT_FILENO);
    dup2(null, STDERR_FILENO);
    if (chdir(path.c_str()) == 0) {
      execv(program.c_str(), argv.data());
    }
    _exit(127);
  }
  return child;
}

int AwaitCampaign(pid_t process) {
  int status = 0;
  waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

bool AwaitRuns(const std::string& database, size_t count, pid_t process) {
  for (;;) {
    if (std::filesystem::exists(database)) {
      try {
        const CResultStore store(database, CResultStore::EMode::ReadOnly);
        if (store.ListRuns().size() >= count) {
          return true;
        }
      } catch (const CARGoSException&) {
        // it is being created
      }
    }
    siginfo_t information{};
    waitid(P_PID, static_cast<id_t>(process), &information, WEXITED | WNOHANG | WNOWAIT);
    if (information.si_pid == process) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

}  // namespace argos
