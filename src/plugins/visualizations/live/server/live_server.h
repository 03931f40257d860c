#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_SERVER_LIVE_SERVER_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_SERVER_LIVE_SERVER_H

#include <argos3/plugins/simulator/visualizations/live/link/live_link.h>
#include <argos3/plugins/simulator/visualizations/live/server/live_page.h>
#include <argos3/plugins/simulator/visualizations/live/server/request_checks.h>

#include <memory>
#include <string>

namespace argos {

struct SLiveServerSettings {
  SLiveAccess Access;
  UInt16 Port = 0; /**< 0: a free one */
  Real StatesPerSecond = 25.0; /**< for each viewer, unless it wants another rate */
  SLivePage Page;
  bool HasControl = true; /**< one of the viewers can have it; otherwise all only look */
};

/** Serves the page and the viewers on a thread of its own. */
class CLiveServer {
 public:
  /** Listens. @throws CARGoSException if the address or the port cannot be used. */
  CLiveServer(SLiveServerSettings settings, CLiveLink& link);
  /** As Stop(). */
  ~CLiveServer();
  CLiveServer(const CLiveServer&) = delete;
  CLiveServer& operator=(const CLiveServer&) = delete;

  UInt16 GetPort() const;
  /** "http://127.0.0.1:8000/#0123...". */
  std::string GetURL() const;
  /**
   * Starts to answer.
   * @param info     content of a recording's block of information.
   * @param welcome  the first message to a viewer, which gets its number.
   */
  void Start(const std::string& info, const TJson& welcome);
  /** Sends what waits and the reason to the viewers, for at most a second, and ends. */
  void Stop(const std::string& reason);

 private:
  class CImpl;
  std::unique_ptr<CImpl> m_impl;
};

}  // namespace argos

#endif
