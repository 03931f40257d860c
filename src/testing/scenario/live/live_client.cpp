#include "live_client.h"

#include <argos3/plugins/simulator/outputs/recording/format/recording_blocks.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>

#include <chrono>
#include <stdexcept>

namespace argos {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using tcp = asio::ip::tcp;
using TError = boost::system::error_code;

constexpr std::chrono::seconds kLongestWait(20);

struct SAddress {
  std::string Host;
  UInt16 Port;
  std::string Token;
};

// of "http://127.0.0.1:8000/#0123"
SAddress ReadURL(const std::string& url) {
  const size_t start = url.find("//") + 2;
  const size_t colon = url.find(':', start);
  return {url.substr(start, colon - start), static_cast<UInt16>(std::stoul(url.substr(colon + 1))),
          url.substr(url.find('#') + 1)};
}

/* Waits for an operation, which gets a handler of (error, ...). */
template <typename START>
TError Await(asio::io_context& context, START&& start) {
  std::optional<TError> result;
  start([&result](TError error, auto&&...) { result = error; });
  context.restart();
  const auto end = std::chrono::steady_clock::now() + kLongestWait;
  while (!result && std::chrono::steady_clock::now() < end) {
    context.run_one_for(kLongestWait);
  }
  if (!result) {
    throw std::runtime_error("the live view does not answer");
  }
  return *result;
}

tcp::endpoint ToEndpoint(const SAddress& address) {
  return {asio::ip::make_address(address.Host), address.Port};
}

bool IsKeyFrame(std::string_view frames) {
  CByteReader all(frames);
  CByteReader first(all.ReadText());
  first.ReadNumber();
  return first.ReadByte() != 0;
}

}  // namespace

class CLiveClient::CSocket {
 public:
  CSocket(const std::string& url, const SOptions& options) {
    const SAddress address = ReadURL(url);
    const std::string host =
        options.Host.empty() ? address.Host + ':' + std::to_string(address.Port) : options.Host;
    tcp::socket& socket = m_stream.next_layer();
    socket.open(tcp::v4());
    if (options.ReceiveBuffer > 0) {
      socket.set_option(asio::socket_base::receive_buffer_size(options.ReceiveBuffer));
    }
    socket.connect(ToEndpoint(address));
    m_stream.read_message_max(size_t(1) << 28);
    m_stream.set_option(
        beast::websocket::stream_base::decorator([&](beast::websocket::request_type& request) {
          request.set(beast::http::field::sec_websocket_protocol, options.Protocol);
          const std::string origin = options.Origin.value_or("http://" + host);
          if (!origin.empty()) {
            request.set(beast::http::field::origin, origin);
          }
        }));
    const TError error =
        Await(m_context, [&](auto handler) { m_stream.async_handshake(host, "/live", handler); });
    if (error) {
      throw std::runtime_error(error.message());
    }
  }

  void Send(const std::string& text, bool isBinary) {
    m_stream.binary(isBinary);
    // a connection that the server has closed is noticed by Receive()
    Await(m_context, [&](auto handler) { m_stream.async_write(asio::buffer(text), handler); });
  }

  // @return nothing if it was closed
  std::optional<std::string> Receive() {
    m_buffer.consume(m_buffer.size());
    const TError error =
        Await(m_context, [&](auto handler) { m_stream.async_read(m_buffer, handler); });
    if (error) {
      return std::nullopt;
    }
    return beast::buffers_to_string(m_buffer.data());
  }
  bool HasText() const { return m_stream.got_text(); }

 private:
  asio::io_context m_context;
  beast::websocket::stream<tcp::socket> m_stream{m_context};
  beast::flat_buffer m_buffer;
};

CLiveClient::CLiveClient(const std::string& url, const SOptions& options)
    : m_socket(std::make_unique<CSocket>(url, options)), m_token(ReadURL(url).Token) {}

CLiveClient::~CLiveClient() = default;

void CLiveClient::Hello(const std::string& token) {
  Send({{"hello", {{"token", token.empty() ? m_token : token}, {"name", "a test"}}}});
}

void CLiveClient::SendText(const std::string& text, bool isBinary) {
  m_socket->Send(text, isBinary);
}

TJson CLiveClient::Do(const std::string& command, TJson arguments) {
  arguments["do"] = command;
  arguments["id"] = ++m_lastId;
  Send(arguments);
  const bool isOpen = ReceiveUntil(
      [this] { return m_text.is_object() && m_text.contains("re") && m_text["re"] == m_lastId; });
  return isOpen ? m_text : TJson();
}

bool CLiveClient::Receive() {
  const std::optional<std::string> message = m_socket->Receive();
  m_text = TJson();
  if (!message) {
    return false;
  }
  if (m_socket->HasText()) {
    m_text = TJson::parse(*message);
    if (m_text.contains("status")) {
      m_status = m_text["status"];
    }
  } else {
    Decode(*message);
  }
  return true;
}

void CLiveClient::Decode(const std::string& block) {
  const auto header = ReadBlockHeader(std::string_view(block).substr(0, kBlockHeaderSize));
  if (!header) {
    throw std::runtime_error("a block without a header");
  }
  std::string content;
  UnpackBlock(*header, std::string_view(block).substr(kBlockHeaderSize), content);
  CByteReader in(content);
  if (header->Kind == EBlock::Info) {
    ++m_numInfos;
  } else if (header->Kind == EBlock::Floor) {
    m_decoder.SetFloor(ReadFloor(in));
  } else {
    m_numKeys += IsKeyFrame(content) ? 1 : 0;
    m_decoder.Decode(in, IsKeyFrame(content));
    ++m_numFrames;
    if (m_acknowledges) {
      Send({{"ack", m_decoder.GetFrame().Tick}});
    }
  }
}

TJson CLiveClient::WaitFor(const std::string& name) {
  const bool isOpen = ReceiveUntil([&] { return m_text.is_object() && m_text.contains(name); });
  return isOpen ? m_text[name] : TJson();
}

bool CLiveClient::ReceiveUntil(const std::function<bool()>& isDone) {
  while (Receive()) {
    if (isDone()) {
      return true;
    }
  }
  return false;
}

std::string RequestByHTTP(const std::string& url, const std::string& request) {
  asio::io_context context;
  tcp::socket socket(context);
  socket.connect(ToEndpoint(ReadURL(url)));
  asio::write(socket, asio::buffer(request));
  std::string answer;
  Await(context,
        [&](auto handler) { asio::async_read(socket, asio::dynamic_buffer(answer), handler); });
  return answer;
}

}  // namespace argos
