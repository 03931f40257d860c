#include <argos3/plugins/simulator/visualizations/live/server/viewer_connection.h>

#include <argos3/plugins/simulator/visualizations/live/server/viewer_hub.h>

#include <boost/asio/buffer.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include <algorithm>
#include <utility>

namespace argos {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;
using TError = boost::system::error_code;

constexpr std::chrono::seconds kTimeForHello(5);
constexpr std::chrono::seconds kIdleTime(30);
constexpr size_t kMaxNameBytes = 64;
constexpr int kMaxDepth = 8;

/* @return what is no object if the text is no JSON object, or nested too deeply. */
TJson ParseMessage(const std::string& text) {
  bool isTooDeep = false;
  const TJson::parser_callback_t check = [&](int depth, TJson::parse_event_t, TJson&) {
    isTooDeep = isTooDeep || depth > kMaxDepth;
    return !isTooDeep;
  };
  TJson message = TJson::parse(text, check, false);
  return isTooDeep ? TJson() : message;
}

bool IsScript(const TJson& message) {
  const auto found = message.find("do");
  return found != message.end() && *found == "script";
}

}  // namespace

CViewerConnection::CViewerConnection(beast::tcp_stream&& stream, CViewerHub& hub)
    : m_socket(std::move(stream)),
      m_hub(hub),
      m_mark(hub.GetConnectionMark()),
      m_helloTimer(m_socket.get_executor()) {
  SetRate(hub.GetStatesPerSecond());
}

void CViewerConnection::Accept(const TLiveRequest& request) {
  websocket::stream_base::timeout times{};
  times.handshake_timeout = kTimeForHello;
  times.idle_timeout = kIdleTime;
  times.keep_alive_pings = true;
  beast::get_lowest_layer(m_socket).expires_never();
  m_socket.set_option(times);
  m_socket.read_message_max(kMaxScriptBytes);
  m_socket.auto_fragment(false);
  m_socket.set_option(websocket::stream_base::decorator([](websocket::response_type& response) {
    response.set(beast::http::field::sec_websocket_protocol, kLiveProtocol);
  }));
  m_helloTimer.expires_after(kTimeForHello);
  m_helloTimer.async_wait([weak = weak_from_this()](TError error) {
    const auto self = weak.lock();
    if (!error && self != nullptr && self->m_number == 0) {
      self->Drop();
    }
  });
  m_socket.async_accept(request,
                        [self = shared_from_this()](TError error) { self->OnAccepted(error); });
}

void CViewerConnection::OnAccepted(TError error) {
  if (error) {
    Drop();
    return;
  }
  ReadNext();
}

void CViewerConnection::SetRate(Real fps) {
  m_period = std::chrono::duration_cast<TClock::duration>(std::chrono::duration<Real>(1.0 / fps));
}

void CViewerConnection::Acknowledge() {
  m_unacknowledged -= m_unacknowledged > 0 ? 1 : 0;
}

void CViewerConnection::ReadNext() {
  if (!m_isClosing && !m_isClosed) {
    m_socket.async_read(m_buffer,
                        [self = shared_from_this()](TError error, size_t) { self->OnRead(error); });
  }
}

void CViewerConnection::OnRead(TError error) {
  if (error || m_isClosed) {
    Drop();
    return;
  }
  const std::string text = beast::buffers_to_string(m_buffer.data());
  m_buffer.consume(m_buffer.size());
  if (!m_socket.got_text()) {
    Close("messages of viewers are texts");
  } else {
    OnMessage(text);
  }
  ReadNext();
}

void CViewerConnection::OnMessage(const std::string& text) {
  const TJson message = ParseMessage(text);
  if (!message.is_object()) {
    Close("a message is no JSON object");
  } else if (m_number == 0) {
    OnHello(message);
  } else if (text.size() > kMaxMessageBytes && !IsScript(message)) {
    Close("a message has more than 64 KiB");
  } else if (message.contains("ack") && !message.contains("do") && m_unacknowledged > 0) {
    Acknowledge();
    m_hub.OnReady();
  } else if (!m_limit.Take(TClock::now())) {
    Close("more than 100 messages a second");
  } else {
    m_hub.OnMessage(*this, message);
  }
}

void CViewerConnection::OnHello(const TJson& message) {
  const auto hello = message.find("hello");
  if (hello == message.end() || !hello->is_object() || !hello->contains("token") ||
      !(*hello)["token"].is_string() ||
      !m_hub.IsToken((*hello)["token"].get_ref<const std::string&>())) {
    Close("the token is wrong: open the URL that the run has printed");
    return;
  }
  if (hello->contains("name") && (*hello)["name"].is_string()) {
    m_name = (*hello)["name"].get<std::string>().substr(0, kMaxNameBytes);
  }
  m_helloTimer.cancel();
  m_number = m_hub.Add(shared_from_this());
  if (m_number == 0) {
    Close("too many viewers");
    return;
  }
  m_hub.Welcome(*this);
}

void CViewerConnection::Send(TLiveText text, bool isBinary) {
  if (m_isClosing || m_isClosed) {
    return;
  }
  if (!isBinary) {
    m_waitingBytes += text->size();
    if (m_waitingBytes > kMaxWaitingBytes) {
      Drop();
      return;
    }
  }
  m_outgoing.push_back({std::move(text), isBinary});
  WriteNext();
}

bool CViewerConnection::IsReadyForState(TClock::time_point now) const {
  return !m_isClosing && !m_isClosed && m_number != 0 && m_unacknowledged < kMaxUnacknowledged &&
         now >= m_due;
}

bool CViewerConnection::SendState(SLiveState& state, CBlockPacker& packer, TClock::time_point now) {
  if (state.Number == m_lastState) {
    return false;
  }
  std::vector<std::string> blocks;
  m_encoder.Encode(state, packer, blocks);
  for (std::string& block : blocks) {
    Send(std::make_shared<const std::string>(std::move(block)), true);
  }
  m_lastState = state.Number;
  ++m_unacknowledged;
  // the mean rate is kept, unless it is late by more than a state
  m_due = m_due + m_period > now ? m_due + m_period : now + m_period;
  return true;
}

void CViewerConnection::WriteNext() {
  if (m_isWriting || m_isClosed) {
    return;
  }
  if (m_outgoing.empty()) {
    if (m_isClosing) {
      m_socket.async_close(websocket::close_code::policy_error,
                           [self = shared_from_this()](TError) { self->Drop(); });
      m_isWriting = true;
    }
    return;
  }
  m_isWriting = true;
  const SOutgoing& next = m_outgoing.front();
  m_socket.binary(next.IsBinary);
  m_socket.async_write(asio::buffer(*next.Text), [self = shared_from_this()](TError error, size_t) {
    self->OnWritten(error);
  });
}

void CViewerConnection::OnWritten(TError error) {
  m_isWriting = false;
  if (error || m_isClosed) {
    Drop();
    return;
  }
  m_waitingBytes -= m_outgoing.front().IsBinary ? 0 : m_outgoing.front().Text->size();
  m_outgoing.pop_front();
  WriteNext();
}

void CViewerConnection::Close(const std::string& reason) {
  if (m_isClosing || m_isClosed) {
    return;
  }
  Send(std::make_shared<const std::string>(ToText({{"error", reason}})));
  m_isClosing = true;
  m_hub.Remove(*this);
  WriteNext();
}

void CViewerConnection::Drop() {
  if (std::exchange(m_isClosed, true)) {
    return;
  }
  m_helloTimer.cancel();
  m_hub.Remove(*this);
  beast::get_lowest_layer(m_socket).close();
}

}  // namespace argos
