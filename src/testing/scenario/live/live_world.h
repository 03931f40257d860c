#ifndef ARGOS3_TESTING_SCENARIO_LIVE_LIVE_WORLD_H
#define ARGOS3_TESTING_SCENARIO_LIVE_LIVE_WORLD_H

#include <argos3/core/simulator/simulator.h>

#include <exception>
#include <functional>
#include <future>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace argos {

/** An experiment that is run with a live view, on a thread of its own. One at a time. */
class CLiveWorld {
 public:
  using TAttributes = std::vector<std::pair<std::string, std::string>>;

  /**
   * Loads and runs an experiment.
   * @param attributes  of <live>.
   * @param load  loads it; the visualization is set.
   */
  CLiveWorld(const TAttributes& attributes, std::function<void(CSimulator&)> load);
  /** Waits for the end, at most until a viewer that is there ends it. */
  ~CLiveWorld();
  CLiveWorld(const CLiveWorld&) = delete;
  CLiveWorld& operator=(const CLiveWorld&) = delete;

  const std::string& GetURL() const { return m_url; }
  /** Waits for the end. @return the digest. @throws what the run has thrown. */
  UInt64 Finish();

 private:
  void Run(const TAttributes& attributes, const std::function<void(CSimulator&)>& load);

  std::string m_url;
  std::promise<std::string> m_foundURL;
  UInt64 m_digest = 0;
  std::exception_ptr m_failure;
  std::thread m_thread;
};

/** Loads experiments/diffusion_10.argos, for that many seconds. */
std::function<void(CSimulator&)> Diffusion(Real seconds);

/** The digest of a run without a view. */
UInt64 RunHeadless(const std::function<void(CSimulator&)>& load);

}  // namespace argos

#endif
