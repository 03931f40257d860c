#include <argos3/core/utility/networking/tcp_socket.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <limits>
#include <memory>
#include <utility>

namespace argos {

namespace {

std::string NumericAddress(const sockaddr* address, socklen_t length) {
  std::array<char, NI_MAXHOST> text{};
  if (getnameinfo(address, length, text.data(), text.size(), nullptr, 0, NI_NUMERICHOST) != 0) {
    return "";
  }
  return text.data();
}

void CheckPort(SInt32 port, SInt32 lowest) {
  // 65535: ports have 16 bits
  if (port < lowest || port > 65535) {
    THROW_ARGOSEXCEPTION("TCP socket: port " << port << ", expected a number from " << lowest
                                             << " to 65535");
  }
}

typedef std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> TAddresses;

TAddresses Resolve(const char* host, SInt32 port, int flags, int family) {
  addrinfo hints{};
  hints.ai_family = family;
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = flags;
  addrinfo* addresses = nullptr;
  const int error = getaddrinfo(host, std::to_string(port).c_str(), &hints, &addresses);
  if (error != 0) {
    THROW_ARGOSEXCEPTION("TCP socket: cannot resolve \"" << (host != nullptr ? host : "")
                                                         << "\": " << gai_strerror(error));
  }
  return TAddresses(addresses, &freeaddrinfo);
}

}  // namespace

// construction and destruction

CTCPSocket::CTCPSocket(CTCPSocket&& other) noexcept
    : m_descriptor(std::exchange(other.m_descriptor, -1)),
      m_address(std::exchange(other.m_address, std::string())),
      m_maxMessageSize(other.m_maxMessageSize) {}

CTCPSocket& CTCPSocket::operator=(CTCPSocket&& other) noexcept {
  if (this != &other) {
    Disconnect();
    m_descriptor = std::exchange(other.m_descriptor, -1);
    m_address = std::exchange(other.m_address, std::string());
    m_maxMessageSize = other.m_maxMessageSize;
  }
  return *this;
}

CTCPSocket::~CTCPSocket() {
  Disconnect();
}

void CTCPSocket::Disconnect() {
  if (m_descriptor >= 0) {
    close(m_descriptor);
    m_descriptor = -1;
    m_address.clear();
  }
}

void CTCPSocket::CheckOpen(const char* action) const {
  if (m_descriptor < 0) {
    THROW_ARGOSEXCEPTION("TCP socket: cannot " << action << ", it is not connected");
  }
}

// connections

void CTCPSocket::Connect(const std::string& host, SInt32 port) {
  CheckPort(port, 1);
  Disconnect();
  const TAddresses addresses = Resolve(host.c_str(), port, 0, AF_UNSPEC);
  int reason = 0;
  for (const addrinfo* address = addresses.get(); address != nullptr; address = address->ai_next) {
    const int descriptor =
        socket(address->ai_family, address->ai_socktype | SOCK_CLOEXEC, address->ai_protocol);
    if (descriptor < 0) {
      reason = errno;
      continue;
    }
    if (connect(descriptor, address->ai_addr, address->ai_addrlen) == 0) {
      m_descriptor = descriptor;
      m_address = NumericAddress(address->ai_addr, address->ai_addrlen);
      return;
    }
    reason = errno;
    close(descriptor);
  }
  THROW_ARGOSEXCEPTION("TCP socket: cannot connect to \"" << host << "\", port " << port << ": "
                                                          << std::strerror(reason));
}

void CTCPSocket::Listen(SInt32 port, SInt32 queueLength, const std::string& address) {
  CheckPort(port, 0);
  Disconnect();
  const TAddresses addresses = Resolve(address.c_str(), port, AI_PASSIVE, AF_UNSPEC);
  const int descriptor =
      socket(addresses->ai_family, addresses->ai_socktype | SOCK_CLOEXEC, addresses->ai_protocol);
  int reason = errno;
  if (descriptor >= 0) {
    // allow a port that was closed a moment ago to be used again
    const int yes = 1;
    setsockopt(descriptor, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
    if (bind(descriptor, addresses->ai_addr, addresses->ai_addrlen) == 0 &&
        listen(descriptor, queueLength) == 0) {
      m_descriptor = descriptor;
      m_address = NumericAddress(addresses->ai_addr, addresses->ai_addrlen);
      return;
    }
    reason = errno;
    close(descriptor);
  }
  THROW_ARGOSEXCEPTION("TCP socket: cannot listen on port " << port << " of \"" << address
                                                            << "\": " << std::strerror(reason));
}

void CTCPSocket::Accept(CTCPSocket& socket) {
  CheckOpen("accept a connection");
  sockaddr_storage address{};
  socklen_t length = sizeof(address);
  int descriptor = -1;
  do {
    length = sizeof(address);
    descriptor =
        accept4(m_descriptor, reinterpret_cast<sockaddr*>(&address), &length, SOCK_CLOEXEC);
  } while (descriptor < 0 && errno == EINTR);
  if (descriptor < 0) {
    THROW_ARGOSEXCEPTION("TCP socket: cannot accept a connection: " << std::strerror(errno));
  }
  socket.Disconnect();
  socket.m_descriptor = descriptor;
  socket.m_address = NumericAddress(reinterpret_cast<const sockaddr*>(&address), length);
}

SInt32 CTCPSocket::GetPort() const {
  CheckOpen("read its port");
  sockaddr_storage address{};
  socklen_t length = sizeof(address);
  if (getsockname(m_descriptor, reinterpret_cast<sockaddr*>(&address), &length) != 0) {
    THROW_ARGOSEXCEPTION("TCP socket: cannot read its port: " << std::strerror(errno));
  }
  if (address.ss_family == AF_INET6) {
    return ntohs(reinterpret_cast<const sockaddr_in6*>(&address)->sin6_port);
  }
  return ntohs(reinterpret_cast<const sockaddr_in*>(&address)->sin_port);
}

std::set<CTCPSocket::EEvent> CTCPSocket::GetEvents() const {
  if (m_descriptor < 0) {
    return {EEvent::InvalidRequest};
  }
  pollfd request{};
  request.fd = m_descriptor;
  request.events = POLLIN | POLLPRI | POLLOUT;
  if (poll(&request, 1, 0) < 0 && errno != EINTR) {
    THROW_ARGOSEXCEPTION("TCP socket: cannot poll: " << std::strerror(errno));
  }
  std::set<EEvent> events;
  const std::array<std::pair<int, EEvent>, 5> kinds = {{{POLLIN | POLLPRI, EEvent::InputReady},
                                                        {POLLOUT, EEvent::OutputReady},
                                                        {POLLHUP, EEvent::HangUp},
                                                        {POLLERR, EEvent::ErrorCondition},
                                                        {POLLNVAL, EEvent::InvalidRequest}}};
  for (const auto& kind : kinds) {
    if ((request.revents & kind.first) != 0) {
      events.insert(kind.second);
    }
  }
  return events;
}

// data

void CTCPSocket::SendBuffer(const UInt8* buffer, std::size_t size) {
  CheckOpen("send");
  while (size > 0) {
    // without MSG_NOSIGNAL writing to a closed connection would end the program
    const ssize_t sent = send(m_descriptor, buffer, size, MSG_NOSIGNAL);
    if (sent < 0) {
      if (errno == EINTR) {
        continue;
      }
      const int reason = errno;
      Disconnect();
      THROW_ARGOSEXCEPTION("TCP socket: cannot send: " << std::strerror(reason));
    }
    buffer += sent;
    size -= static_cast<std::size_t>(sent);
  }
}

void CTCPSocket::ReceiveBuffer(UInt8* buffer, std::size_t size) {
  CheckOpen("receive");
  while (size > 0) {
    const ssize_t received = recv(m_descriptor, buffer, size, 0);
    if (received <= 0) {
      if (received < 0 && errno == EINTR) {
        continue;
      }
      const int reason = errno;
      Disconnect();
      THROW_ARGOSEXCEPTION(
          "TCP socket: cannot receive: " << (received == 0 ? "the other side closed the connection"
                                                           : std::strerror(reason)));
    }
    buffer += received;
    size -= static_cast<std::size_t>(received);
  }
}

void CTCPSocket::SendByteArray(const CByteArray& array) {
  const std::size_t most =
      std::min<std::size_t>(m_maxMessageSize, std::numeric_limits<UInt32>::max());
  if (array.Size() > most) {
    THROW_ARGOSEXCEPTION("TCP socket: cannot send " << array.Size()
                                                    << " bytes at once, expected at most " << most
                                                    << "; see SetMaxMessageSize()");
  }
  CByteArray length;
  length << static_cast<UInt32>(array.Size());
  SendBuffer(length.ToCArray(), length.Size());
  SendBuffer(array.ToCArray(), array.Size());
}

void CTCPSocket::ReceiveByteArray(CByteArray& array) {
  CByteArray length(sizeof(UInt32));
  ReceiveBuffer(length.ToCArray(), length.Size());
  const auto size = length.PopFront<UInt32>();
  if (size > m_maxMessageSize) {
    Disconnect();
    THROW_ARGOSEXCEPTION("TCP socket: cannot receive a message of "
                         << size << " bytes, expected at most " << m_maxMessageSize
                         << "; is the other side no CTCPSocket? If it is, see "
                         << "SetMaxMessageSize()");
  }
  array.Clear();
  array.Resize(size);
  ReceiveBuffer(array.ToCArray(), array.Size());
}

void CTCPSocket::SendMsg(const std::string& message) {
  SendByteArray(CByteArray(reinterpret_cast<const UInt8*>(message.data()), message.size()));
}

void CTCPSocket::RecvMsg(std::string& message) {
  CByteArray array;
  ReceiveByteArray(array);
  message.clear();
  if (!array.Empty()) {
    message.assign(reinterpret_cast<const char*>(array.ToCArray()), array.Size());
  }
}

}  // namespace argos
