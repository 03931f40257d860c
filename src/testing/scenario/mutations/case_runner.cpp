#include "case_runner.h"

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/logging/argos_log.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <iterator>
#include <regex>

namespace argos {

namespace {

typedef std::chrono::steady_clock TClock;

constexpr const char* kFileName = "case.argos";
constexpr UInt32 kTicks = 3;
// a fresh process bounds what may pile up
constexpr std::size_t kCasesPerChild = 100;

bool HasFinitePoses(CSpace& space) {
  for (CEntity* root : space.GetRootEntityVector()) {
    auto* const composable = dynamic_cast<CComposableEntity*>(root);
    if (composable == nullptr) {
      continue;
    }
    for (const CEntity* component : composable->GetExistingComponents()) {
      const auto* const body = dynamic_cast<const CEmbodiedEntity*>(component);
      if (body != nullptr && !(std::isfinite(body->GetOriginAnchor().Position.SquareLength()) &&
                               std::isfinite(body->GetOriginAnchor().Orientation.SquareLength()))) {
        return false;
      }
    }
  }
  return true;
}

SCaseResult RunCase(const std::string& xml) {
  CConfigurationDocument document;
  CSimulator simulator;
  const CSimulator::CScope scope(simulator);
  bool isLoaded = false;
  try {
    document.Parse(xml, kFileName);
    simulator.Load(document, xml.find("<offscreen") != std::string::npos);
    isLoaded = true;
    for (UInt32 tick = 0; tick < kTicks && !simulator.IsExperimentFinished(); ++tick) {
      simulator.UpdateSpace();
    }
    const bool isFinite = HasFinitePoses(simulator.GetSpace());
    simulator.Destroy();
    return {isFinite ? EOutcome::Loaded : EOutcome::NotFinite, ""};
  } catch (const CARGoSException& error) {
    const std::string text = error.what();
    const bool hasPlace = std::regex_search(text, std::regex(std::string(kFileName) + ":[0-9]+"));
    return {isLoaded   ? EOutcome::RunError
            : hasPlace ? EOutcome::ErrorWithPlace
                       : EOutcome::ErrorWithoutPlace,
            text};
  } catch (const std::exception& error) {
    return {EOutcome::OtherException, error.what()};
  } catch (...) {
    return {EOutcome::OtherException, "not a std::exception"};
  }
}

void WriteLine(int pipe, std::string line) {
  std::replace(line.begin(), line.end(), '\n', '|');
  constexpr std::size_t kMaxLength = 600;
  line = line.substr(0, kMaxLength) + '\n';
  if (write(pipe, line.data(), line.size()) < 0) {
    _exit(3);
  }
}

// "begin" before each case, "<outcome> <text>" after it
[[noreturn]] void RunChild(std::size_t first, std::size_t last,
                           const std::function<std::string(std::size_t)>& getCase,
                           const std::string& folder, int pipe) {
  if (chdir(folder.c_str()) != 0) {
    _exit(2);
  }
  const int output = open("output.txt", O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  LOG.GetStream().rdbuf(nullptr);
  LOGERR.GetStream().rdbuf(nullptr);
  for (std::size_t i = first; i < last; ++i) {
    WriteLine(pipe, "begin");
    const SCaseResult result = RunCase(getCase(i));
    WriteLine(pipe, std::to_string(static_cast<int>(result.Outcome)) + ' ' + result.Text);
  }
  // without destructors of the test program
  _exit(0);
}

std::size_t ResidentMegabytes(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/statm");
  std::size_t total = 0;
  std::size_t resident = 0;
  file >> total >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) >> 20;
}

std::string EndOfOutput(const std::string& folder) {
  std::ifstream file(folder + "/output.txt");
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  constexpr std::size_t kLength = 3000;
  return text.size() <= kLength ? text : text.substr(0, kLength);
}

/* Reads the lines of a child, and kills it when a case exceeds a limit. */
class CChildReader {
 public:
  CChildReader(pid_t process, int pipe, const SCaseLimits& limits)
      : m_process(process), m_pipe(pipe), m_limits(limits) {}

  /** Appends the results of finished cases. @return false if the child was killed or has died. */
  void Read(std::vector<SCaseResult>& results) {
    TClock::time_point start = TClock::now();
    for (;;) {
      struct pollfd ready {
        m_pipe, POLLIN, 0
      };
      if (poll(&ready, 1, 100) > 0) {
        char buffer[4096];
        const ssize_t length = read(m_pipe, buffer, sizeof(buffer));
        if (length <= 0) {
          return;
        }
        m_text.append(buffer, static_cast<std::size_t>(length));
        if (TakeLines(results)) {
          start = TClock::now();
        }
      } else if (TClock::now() - start > std::chrono::seconds(m_limits.Seconds)) {
        Kill(EOutcome::Timeout);
        return;
      } else if (ResidentMegabytes(m_process) > m_limits.Megabytes) {
        Kill(EOutcome::TooMuchMemory);
        return;
      }
    }
  }

  bool IsInCase() const { return m_isInCase; }
  EOutcome GetReason() const { return m_reason; }

 private:
  bool TakeLines(std::vector<SCaseResult>& results) {
    bool any = false;
    for (std::size_t end = m_text.find('\n'); end != std::string::npos; end = m_text.find('\n')) {
      const std::string line = m_text.substr(0, end);
      m_text.erase(0, end + 1);
      m_isInCase = line == "begin";
      if (!m_isInCase) {
        results.push_back({static_cast<EOutcome>(line[0] - '0'), line.substr(2)});
      }
      any = true;
    }
    return any;
  }

  void Kill(EOutcome reason) {
    m_reason = reason;
    kill(m_process, SIGKILL);
  }

  pid_t m_process;
  int m_pipe;
  const SCaseLimits& m_limits;
  std::string m_text;
  bool m_isInCase = false;
  EOutcome m_reason = EOutcome::Crash;
};

// results of a run of cases, up to the first that kills the child
void RunSome(std::size_t last, const std::function<std::string(std::size_t)>& getCase,
             const std::string& folder, const SCaseLimits& limits,
             std::vector<SCaseResult>& results) {
  int pipes[2];
  if (pipe(pipes) != 0) {
    THROW_ARGOSEXCEPTION("no pipe to a child process");
  }
  const pid_t process = fork();
  if (process == 0) {
    close(pipes[0]);
    RunChild(results.size(), last, getCase, folder, pipes[1]);
  }
  close(pipes[1]);
  CChildReader reader(process, pipes[0], limits);
  reader.Read(results);
  close(pipes[0]);
  int status = 0;
  waitpid(process, &status, 0);
  const bool isGood = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (!isGood || reader.IsInCase()) {
    const std::string how = WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                                                : "status " + std::to_string(WEXITSTATUS(status));
    results.push_back({reader.GetReason(), how + '\n' + EndOfOutput(folder)});
  }
}

}  // namespace

const char* ToText(EOutcome outcome) {
  static constexpr const char* kTexts[] = {"loaded",
                                           "error with file and line",
                                           "error without line",
                                           "error in a tick",
                                           "other exception",
                                           "pose not finite",
                                           "crash",
                                           "timeout",
                                           "too much memory"};
  return kTexts[static_cast<int>(outcome)];
}

bool IsAccepted(EOutcome outcome) {
  return outcome <= EOutcome::RunError;
}

std::vector<SCaseResult> RunCases(std::size_t number,
                                  const std::function<std::string(std::size_t)>& getCase,
                                  const std::string& folder, const SCaseLimits& limits) {
  std::vector<SCaseResult> results;
  while (results.size() < number) {
    const std::size_t before = results.size();
    RunSome(std::min(number, before + kCasesPerChild), getCase, folder, limits, results);
    if (results.size() == before) {
      THROW_ARGOSEXCEPTION("a child process ended before its first case");
    }
  }
  return results;
}

}  // namespace argos
