#include "live_world.h"

#include "live_client.h"

#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/logging/log_control.h>
#include <argos3/testing/support/paths.h>

#include <atomic>
#include <cstdlib>
#include <stdexcept>

namespace argos {

namespace {

// where the libraries of the experiments are
[[maybe_unused]] const int kPluginPath =
    setenv("ARGOS_PLUGIN_PATH", InBuildTree("experiments").c_str(), 1);

}  // namespace

CLiveWorld::CLiveWorld(const TAttributes& attributes, std::function<void(CSimulator&)> load) {
  CLogControl::SetLineReceiver([this, isFound = false](ELogLevel, const std::string& line) mutable {
    const size_t place = line.find("http://");
    if (!isFound && place != std::string::npos) {
      isFound = true;
      m_foundURL.set_value(line.substr(place));
    }
  });
  std::future<std::string> url = m_foundURL.get_future();
  m_thread = std::thread([this, attributes, load = std::move(load)] { Run(attributes, load); });
  constexpr std::chrono::seconds kLongestStart(60);
  if (url.wait_for(kLongestStart) == std::future_status::ready) {
    m_url = url.get();
  }
}

CLiveWorld::~CLiveWorld() {
  if (std::uncaught_exceptions() > 0) {
    // a test has failed, and its viewers are gone
    try {
      CLiveClient viewer(m_url);
      viewer.Hello();
      viewer.Do("end");
    } catch (const std::exception&) {
      // it has ended
    }
  }
  if (m_thread.joinable()) {
    m_thread.join();
  }
  CLogControl::SetLineReceiver({});
}

void CLiveWorld::Run(const TAttributes& attributes, const std::function<void(CSimulator&)>& load) {
  try {
    CSimulator simulator;
    const CSimulator::CScope scope(simulator);
    TAttributes all = {{"open", "false"}, {"linger", "5"}};
    all.insert(all.end(), attributes.begin(), attributes.end());
    simulator.SetVisualization("live", all);
    load(simulator);
    simulator.Execute();
    m_digest = simulator.GetSpace().ComputeDigest();
    simulator.Destroy();
  } catch (...) {
    m_failure = std::current_exception();
  }
}

UInt64 CLiveWorld::Finish() {
  m_thread.join();
  if (m_failure != nullptr) {
    std::rethrow_exception(m_failure);
  }
  return m_digest;
}

std::function<void(CSimulator&)> Diffusion(Real seconds) {
  return [seconds](CSimulator& simulator) {
    simulator.SetLength(seconds);
    simulator.SetExperimentFileName(InSourceTree("experiments/diffusion_10.argos"));
    simulator.LoadExperiment(true);
  };
}

UInt64 RunHeadless(const std::function<void(CSimulator&)>& load) {
  CLogControl::SetLineReceiver([](ELogLevel, const std::string&) {});
  CSimulator simulator;
  const CSimulator::CScope scope(simulator);
  load(simulator);
  simulator.Execute();
  CLogControl::SetLineReceiver({});
  return simulator.GetSpace().ComputeDigest();
}

}  // namespace argos
