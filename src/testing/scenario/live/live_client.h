#ifndef ARGOS3_TESTING_SCENARIO_LIVE_LIVE_CLIENT_H
#define ARGOS3_TESTING_SCENARIO_LIVE_LIVE_CLIENT_H

#include <argos3/plugins/simulator/outputs/recording/format/frame_coding.h>

#include <nlohmann/json.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace argos {

using TJson = nlohmann::json;

/** A viewer of a live view, for tests; each wait ends after 20 s with std::runtime_error. */
class CLiveClient {
 public:
  struct SOptions {
    std::string Host = {}; /**< header; empty: that of the URL */
    std::optional<std::string> Origin = {}; /**< unset: that of the page; empty: none */
    std::string Protocol = "argos-live.1";
    int ReceiveBuffer = 0; /**< bytes, of the system; 0: as usual */
  };

  /** Connects, and asks for a WebSocket. @throws std::runtime_error if that is refused. */
  explicit CLiveClient(const std::string& url) : CLiveClient(url, SOptions()) {}
  CLiveClient(const std::string& url, const SOptions& options);
  ~CLiveClient();
  CLiveClient(const CLiveClient&) = delete;
  CLiveClient& operator=(const CLiveClient&) = delete;

  /** Sends the token of the URL, or another one. */
  void Hello(const std::string& token = "");
  void SendText(const std::string& text, bool isBinary = false);
  void Send(const TJson& message) { SendText(message.dump()); }
  /** Sends a command, and waits for the answer. */
  TJson Do(const std::string& command, TJson arguments = TJson::object());

  /** Receives one message; decodes and acknowledges states. @return false if it was closed. */
  bool Receive();
  /** Receives until a text has this name, or the connection is closed (null). */
  TJson WaitFor(const std::string& name);
  /** Receives until a condition holds. @return false if it was closed. */
  bool ReceiveUntil(const std::function<bool()>& isDone);

  void SetAcknowledges(bool acknowledges) { m_acknowledges = acknowledges; }
  /** The last text; null after a state. */
  const TJson& GetText() const { return m_text; }
  const TJson& GetStatus() const { return m_status; }
  /** The state that was received last. */
  const SRecordedFrame& GetFrame() const { return m_decoder.GetFrame(); }
  UInt32 CountFrames() const { return m_numFrames; }
  UInt32 CountKeyFrames() const { return m_numKeys; }
  UInt32 CountInfos() const { return m_numInfos; }

 private:
  class CSocket;

  void Decode(const std::string& block);

  std::unique_ptr<CSocket> m_socket;
  std::string m_token;
  bool m_acknowledges = true;
  UInt32 m_lastId = 0;
  TJson m_text;
  TJson m_status = TJson::object();
  CFrameDecoder m_decoder{EPrecision::Grid};
  UInt32 m_numFrames = 0;
  UInt32 m_numKeys = 0;
  UInt32 m_numInfos = 0;
};

/** The answer to an HTTP request, headers and all; the request ends with an empty line. */
std::string RequestByHTTP(const std::string& url, const std::string& request);

}  // namespace argos

#endif
