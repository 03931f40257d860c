#include "raw_client.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/write.hpp>

#include <poll.h>

#include <array>
#include <chrono>

namespace argos {

namespace {

namespace asio = boost::asio;
using tcp = asio::ip::tcp;
using TError = boost::system::error_code;

constexpr size_t kMaxShort = 125;
constexpr size_t kMaxMedium = 65535;

}  // namespace

std::string MakeFrame(std::string_view payload, const SRawFrame& frame) {
  const UInt64 length = payload.size() + static_cast<UInt64>(frame.ExtraLength);
  const UInt8 mask = frame.IsMasked ? 0x80 : 0;
  std::string bytes(1, static_cast<char>(frame.FirstByte));
  const auto add = [&](int numBytes) {
    for (int i = numBytes - 1; i >= 0; --i) {
      bytes += static_cast<char>((length >> (8 * i)) & 255);
    }
  };
  if (length <= kMaxShort) {
    bytes += static_cast<char>(mask | length);
  } else if (length <= kMaxMedium) {
    bytes += static_cast<char>(mask | 126);
    add(2);
  } else {
    bytes += static_cast<char>(mask | 127);
    add(8);
  }
  // a mask of zeros leaves the payload as it is
  return bytes + (frame.IsMasked ? std::string(4, '\0') : std::string()) + std::string(payload);
}

class CRawClient::CSocket {
 public:
  tcp::socket Socket{GetContext()};

 private:
  // of all, so that each needs one file descriptor only
  static asio::io_context& GetContext() {
    static asio::io_context context;
    return context;
  }
};

CRawClient::CRawClient(const std::string& url) : m_socket(std::make_unique<CSocket>()) {
  const size_t start = url.find("//") + 2;
  const size_t colon = url.find(':', start);
  m_host = url.substr(start, url.find('/', start) - start);
  m_token = url.substr(url.find('#') + 1);
  TError error;
  m_socket->Socket.connect(tcp::endpoint(asio::ip::make_address(url.substr(start, colon - start)),
                                         static_cast<UInt16>(std::stoul(url.substr(colon + 1)))),
                           error);
  if (error) {
    throw std::runtime_error(error.message());
  }
}

CRawClient::~CRawClient() = default;

void CRawClient::ShakeHands() {
  Send("GET /live HTTP/1.1\r\nHost: " + m_host +
       "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
       "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
       "Sec-WebSocket-Protocol: argos-live.1\r\n\r\n");
  std::string answer;
  TError ignored;
  asio::read_until(m_socket->Socket, asio::dynamic_buffer(answer), "\r\n\r\n", ignored);
}

void CRawClient::Join() {
  ShakeHands();
  Send(MakeFrame(R"({"hello":{"token":")" + m_token + R"("}})"));
}

void CRawClient::Send(std::string_view bytes) {
  TError ignored;
  asio::write(m_socket->Socket, asio::buffer(bytes.data(), bytes.size()), ignored);
}

bool CRawClient::IsClosedWithin(Real seconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<Real>(seconds);
  std::array<char, 4096> bytes{};
  while (true) {
    const Real left = std::chrono::duration<Real>(end - std::chrono::steady_clock::now()).count();
    pollfd poll{m_socket->Socket.native_handle(), POLLIN, 0};
    if (left <= 0.0 || ::poll(&poll, 1, static_cast<int>(1000.0 * left) + 1) <= 0) {
      return false;
    }
    TError error;
    m_socket->Socket.read_some(asio::buffer(bytes), error);
    if (error) {
      return true;
    }
  }
}

}  // namespace argos
