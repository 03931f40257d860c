#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_SERVER_VIEWER_CONNECTION_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_SERVER_VIEWER_CONNECTION_H

#include <argos3/plugins/simulator/visualizations/live/server/message_limit.h>
#include <argos3/plugins/simulator/visualizations/live/server/state_encoder.h>

#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket/stream.hpp>

#include <chrono>
#include <deque>
#include <memory>
#include <set>
#include <string>

namespace argos {

class CViewerHub;

using TLiveRequest = boost::beast::http::request<boost::beast::http::string_body>;
using TLiveText = std::shared_ptr<const std::string>;

/**
 * A WebSocket of one viewer: waits for its token, passes its messages to the hub, and sends events
 * in order and states when it can take one. Thread of the server only.
 */
class CViewerConnection : public std::enable_shared_from_this<CViewerConnection> {
 public:
  using TClock = std::chrono::steady_clock;
  /** Events of a viewer that wait to be sent, bytes; one that takes less is disconnected. */
  static constexpr size_t kMaxWaitingBytes = size_t(1) << 20;
  /** States that a viewer has not acknowledged. */
  static constexpr UInt32 kMaxUnacknowledged = 2;
  static constexpr size_t kMaxMessageBytes = size_t(1) << 16;
  static constexpr size_t kMaxScriptBytes = size_t(1) << 18;

  CViewerConnection(boost::beast::tcp_stream&& stream, CViewerHub& hub);

  /** Completes the handshake that the request began. */
  void Accept(const TLiveRequest& request);

  UInt32 GetNumber() const { return m_number; }
  const std::string& GetName() const { return m_name; }
  std::set<std::string>& GetPinned() { return m_pinned; }
  /** @param fps  states a second that it wants. */
  void SetRate(Real fps);
  void Acknowledge();

  void Send(TLiveText text, bool isBinary = false);
  /** True if it may be sent another state now. */
  bool IsReadyForState(TClock::time_point now) const;
  /** Sends a state, unless it has it. @return true if it had not. */
  bool SendState(SLiveState& state, CBlockPacker& packer, TClock::time_point now);
  /** When it may be sent another state, as far as that depends on its rate. */
  TClock::time_point GetDueTime() const { return m_due; }
  /** Sends a last message, and closes. Call it only after the handshake. */
  void Close(const std::string& reason);

 private:
  struct SOutgoing {
    TLiveText Text;
    bool IsBinary;
  };

  void OnAccepted(boost::system::error_code error);
  void ReadNext();
  void OnRead(boost::system::error_code error);
  void OnMessage(const std::string& text);
  void OnHello(const TJson& message);
  void WriteNext();
  void OnWritten(boost::system::error_code error);
  void Drop();

  boost::beast::websocket::stream<boost::beast::tcp_stream> m_socket;
  CViewerHub& m_hub;
  std::shared_ptr<const int> m_mark;  // of the hub
  boost::asio::steady_timer m_helloTimer;
  boost::beast::flat_buffer m_buffer;
  CMessageLimit m_limit;
  UInt32 m_number = 0;  // 0: its token was not checked
  std::string m_name;
  std::set<std::string> m_pinned;  // ids of entities
  std::deque<SOutgoing> m_outgoing;
  size_t m_waitingBytes = 0;  // of m_outgoing
  bool m_isWriting = false;
  bool m_isClosing = false;  // after m_outgoing
  bool m_isClosed = false;

  CStateEncoder m_encoder;
  UInt64 m_lastState = 0;  // its number
  UInt32 m_unacknowledged = 0;
  TClock::duration m_period;
  TClock::time_point m_due;
};

}  // namespace argos

#endif
