// A controller and loop functions for the tests of campaigns: in the run with a given seed, or,
// with a period, in one of so many runs, one robot does what must not harm the other runs.

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/built_in_metric.h>
#include <argos3/core/simulator/space/metrics.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <future>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace argos;

namespace {

// larger than the limit of any test
constexpr size_t kBlock = 16 << 20;
constexpr size_t kMaxBlocks = 1024;

// each page is touched
void EatMemory() {
  std::vector<std::unique_ptr<std::vector<char>>> blocks;
  for (size_t i = 0; i < kMaxBlocks; ++i) {
    blocks.push_back(std::make_unique<std::vector<char>>(kBlock, 'x'));
  }
}

void PrintMuch() {
  const std::vector<char> line(1 << 10, '.');
  for (int i = 0; i < 64 << 10; ++i) {
    std::fwrite(line.data(), 1, line.size(), stdout);
  }
  std::fputs("end of the flood\n", stdout);
}

// resident for a moment
void TouchMemory() {
  const std::vector<char> block(64 << 20, 'x');
  std::fwrite(block.data(), 1, 1, stdout);
}

// more bytes than 32 bits can count
void Flood() {
  const std::vector<char> block(1 << 20, '.');
  for (int i = 0; i < (4 << 10) + 1; ++i) {
    std::fwrite(block.data(), 1, block.size(), stdout);
  }
}

void Misbehave(const std::string& what) {
  if (what == "crash") {
    *static_cast<volatile int*>(nullptr) = 1;
  } else if (what == "hang") {
    for (;;) {
      sleep(1);
    }
  } else if (what == "eat") {
    EatMemory();
  } else if (what == "print") {
    PrintMuch();
  } else if (what == "flood") {
    Flood();
  } else if (what == "exit") {
    std::exit(7);
  } else if (what == "touch") {
    TouchMemory();
  } else if (what == "fork") {
    // both go on with the run
    fork();
  } else if (what == "fork_fails") {
    const pid_t child = fork();
    if (child == 0) {
      throw std::runtime_error("the fork fails");
    }
    waitpid(child, nullptr, 0);
  } else if (what == "fork_and_exit") {
    // the fork keeps the pipes of this process open
    if (fork() == 0) {
      sleep(60);
    }
    std::_Exit(7);
  } else if (what == "throw") {
    throw std::runtime_error("deliberate error");
  } else if (what == "kill_parent") {
    // the worker, of which this process is a fork
    kill(getppid(), SIGKILL);
    sleep(10);
  }
}

class CMisbehavesOnce : public CCI_Controller {
 public:
  void Init(TConfigurationNode& params) override {
    GetNodeAttributeOrDefault(params, "what", m_what, m_what);
    GetNodeAttributeOrDefault(params, "seed", m_seed, m_seed);
    GetNodeAttributeOrDefault(params, "period", m_period, m_period);
    m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
    m_rng = CRandom::CreateRNG("argos");
  }
  void ControlStep() override {
    constexpr Real kTopSpeed = 10.0;  // cm/s
    m_wheels->SetLinearVelocity(m_rng->Uniform(CRange<Real>(0.0, kTopSpeed)), kTopSpeed);
    CSimulator& simulator = CSimulator::GetInstance();
    const UInt32 seed = simulator.GetRandomSeed();
    const bool isChosen = m_period == 0 ? seed == m_seed : seed % m_period == m_seed % m_period;
    if (isChosen && GetId() == "fb1" && simulator.GetSpace().GetSimulationClock() == kTick) {
      Misbehave(m_what);
    }
  }

 private:
  static constexpr UInt32 kTick = 3;

  std::string m_what;
  UInt32 m_seed = 1;
  UInt32 m_period = 0;  // runs; 0: the one with the seed
  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  CRandom::CRNG* m_rng = nullptr;
};

/* Waits for the run with the other one of the seeds 1 and 2, by files in a folder. */
class CMeeting {
 public:
  CMeeting(std::string folder, Real patience, UInt32 seed)
      : m_folder(std::move(folder)), m_patience(patience), m_seed(seed) {}

  // returns true if both are executed at the same time
  bool Attend() const {
    const UInt32 other = 3 - m_seed;
    if (Exists("begin", other)) {
      const bool isThere = !Exists("end", other);
      Write("begin");
      return isThere;
    }
    Write("begin");
    constexpr int kPollsPerSecond = 1000;
    for (int polls = 0; polls < m_patience * kPollsPerSecond; ++polls) {
      usleep(1000000 / kPollsPerSecond);
      if (Exists("begin", other)) {
        return true;
      }
    }
    return false;
  }
  void Leave() const { Write("end"); }

 private:
  std::string GetFile(const char* what, UInt32 seed) const {
    return m_folder + '/' + what + std::to_string(seed);
  }
  bool Exists(const char* what, UInt32 seed) const {
    return access(GetFile(what, seed).c_str(), F_OK) == 0;
  }
  void Write(const char* what) const { std::ofstream(GetFile(what, m_seed)) << what; }

  std::string m_folder;
  Real m_patience;  // s
  UInt32 m_seed;
};

// as users' libraries have it: from the time when they are loaded
CSimulator& g_simulator = CSimulator::GetInstance();

/* Metrics, and a table in the working directory. */
class CMeasures : public CLoopFunctions {
 public:
  void Init(TConfigurationNode& params) override {
    GetNodeAttributeOrDefault(params, "gain", m_gain, m_gain);
    GetNodeAttributeOrDefault(params, "event_every", m_eventEvery, m_eventEvery);
    GetNodeAttributeOrDefault(params, "result", m_result, m_result);
    GetNodeAttributeOrDefault(params, "uses_threads", m_usesThreads, m_usesThreads);
    m_rng = CRandom::CreateRNG("argos");
    m_value = m_rng->Gaussian(1.0, 10.0);
    std::string meet;
    GetNodeAttributeOrDefault(params, "meet", meet, meet);
    if (!meet.empty()) {
      Real patience = 0.0;
      GetNodeAttribute(params, "patience", patience);
      m_meeting =
          std::make_unique<CMeeting>(meet, patience, CSimulator::GetInstance().GetRandomSeed());
      GetSpace().GetExtension<CMetrics>().Set("met", m_meeting->Attend() ? 1.0 : 0.0);
    }
  }
  void PostStep() override {
    auto& metrics = GetSpace().GetExtension<CMetrics>();
    const UInt32 tick = GetSpace().GetSimulationClock();
    metrics.Set("level", m_gain * m_value, "m");
    metrics.Set("ticks", tick);
    if (m_eventEvery > 0 && tick % m_eventEvery == 0) {
      metrics.Set("event", tick);
    }
    if (m_usesThreads) {
      metrics.Set("static", g_simulator.GetSpace().GetSimulationClock());
      metrics.Set("thread", std::async(std::launch::async, [] {
                              return CSimulator::GetInstance().GetSpace().GetSimulationClock();
                            }).get());
    }
    m_table.push_back(m_gain * tick);
  }
  void PostExperiment() override {
    if (m_result > 0.0) {
      GetSpace().GetExtension<CMetrics>().Record("ticks", m_result);
    }
  }
  void Destroy() override {
    if (m_meeting != nullptr) {
      m_meeting->Leave();
    }
    std::ofstream file("table.csv");
    file << "tick;twice\n";
    for (size_t i = 0; i < m_table.size(); ++i) {
      file << i + 1 << ';' << 2.0 * m_table[i] << '\n';
    }
  }

 private:
  Real m_gain = 1.0;
  UInt32 m_eventEvery = 0;  // ticks; 0: never
  Real m_result = 0.0;  // recorded when the run is over; 0: none
  bool m_usesThreads = false;
  Real m_value = 0.0;
  CRandom::CRNG* m_rng = nullptr;
  std::unique_ptr<CMeeting> m_meeting;
  std::vector<Real> m_table;
};

/* The number of the tick. */
class CTickMetric : public CBuiltInMetric {
 public:
  void Init(CSpace& space) override { m_space = &space; }
  Real Compute() override { return m_space->GetSimulationClock(); }
  std::string GetUnit() const override { return "ticks"; }

 private:
  CSpace* m_space = nullptr;
};

}  // namespace

REGISTER_BUILT_IN_METRIC(CTickMetric, "test_tick", "", "", "The number of the tick.", "", "");
REGISTER_CONTROLLER(CMisbehavesOnce, "misbehaves_once");
REGISTER_LOOP_FUNCTIONS(CMeasures, "measures");
