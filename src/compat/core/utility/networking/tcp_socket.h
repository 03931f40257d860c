#ifndef ARGOS3_COMPAT_CORE_UTILITY_NETWORKING_TCP_SOCKET_H
#define ARGOS3_COMPAT_CORE_UTILITY_NETWORKING_TCP_SOCKET_H

#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <cstddef>
#include <set>
#include <string>

namespace argos {

/**
 * A TCP connection or a listening port. Owns its file descriptor; can be moved, not copied. Sending
 * and receiving block until complete.
 *
 * Every function throws CARGoSException, with the operating system's reason, on failure. A
 * connection that failed or was closed by the peer is disconnected first.
 */
class CTCPSocket {
 public:
  /** Result of GetEvents(). */
  enum class EEvent {
    /** Data can be received, or a connection accepted. */
    InputReady,
    /** Sending does not block. */
    OutputReady,
    /** The peer has closed the connection. */
    HangUp,
    ErrorCondition,
    /** The socket is not open. */
    InvalidRequest
  };

  CTCPSocket() = default;
  CTCPSocket(const CTCPSocket&) = delete;
  CTCPSocket& operator=(const CTCPSocket&) = delete;
  CTCPSocket(CTCPSocket&& other) noexcept;
  CTCPSocket& operator=(CTCPSocket&& other) noexcept;
  ~CTCPSocket();

  /** @param host  a name or an address, IPv4 or IPv6. */
  void Connect(const std::string& host, SInt32 port);

  /**
   * Opens a port.
   * @param port         0: any free port, see GetPort().
   * @param queueLength  maximum number of connections that wait for Accept().
   * @param address      of the interface: by default, only programs on this machine can connect;
   * "0.0.0.0" is all IPv4 interfaces, and "::" all of both kinds.
   */
  void Listen(SInt32 port, SInt32 queueLength = 10, const std::string& address = "127.0.0.1");

  /** Waits for a connection. @param socket  set to the connection; closed before. */
  void Accept(CTCPSocket& socket);

  /** Closes the socket, if open. */
  void Disconnect();

  /** @return true if the connection or port is open. */
  bool IsConnected() const { return m_descriptor >= 0; }

  /** The file descriptor; -1 if closed. */
  SInt32 GetStream() const { return m_descriptor; }

  /** The peer's address; for a listening socket its own; "" if closed. */
  const std::string& GetAddress() const { return m_address; }

  /** The port on this machine. */
  SInt32 GetPort() const;

  /** Returns the operations that would not block now. */
  std::set<EEvent> GetEvents() const;

  /** Raw bytes. */
  void SendBuffer(const UInt8* buffer, std::size_t size);
  void ReceiveBuffer(UInt8* buffer, std::size_t size);

  /**
   * Bytes that one byte array or text may have; 64 MiB by default. The length comes from the peer:
   * a longer one disconnects, and throws, before memory is allocated.
   */
  void SetMaxMessageSize(std::size_t bytes) { m_maxMessageSize = bytes; }
  std::size_t GetMaxMessageSize() const { return m_maxMessageSize; }

  /** A 32-bit unsigned length in network byte order, then the bytes. */
  void SendByteArray(const CByteArray& array);
  void ReceiveByteArray(CByteArray& array);

  /** A text, in the format of a byte array. */
  void SendMsg(const std::string& message);
  void RecvMsg(std::string& message);

 private:
  void CheckOpen(const char* action) const;

  SInt32 m_descriptor = -1;
  std::string m_address;
  std::size_t m_maxMessageSize = std::size_t{64} << 20;
};

}  // namespace argos

#endif
