#ifndef ARGOS3_CORE_UTILITY_NETWORKING_TCP_SOCKET_H
#define ARGOS3_CORE_UTILITY_NETWORKING_TCP_SOCKET_H

#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <cstddef>
#include <set>
#include <string>

namespace argos {

/**
 * A TCP connection, or a port that waits for connections. Owns its file descriptor; can be moved,
 * not copied. Sending and receiving block until all is done.
 *
 * Every function throws CARGoSException, with the operating system's reason, if it fails. A
 * connection that fails, or that the other side closes, is disconnected first.
 */
class CTCPSocket {
 public:
  /** What GetEvents() reports. */
  enum class EEvent {
    /** There is something to receive, or a connection to accept. */
    InputReady,
    /** Sending does not block. */
    OutputReady,
    /** The other side has closed the connection. */
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
   * Opens a port on all interfaces.
   * @param port         0: any free one, see GetPort().
   * @param queueLength  how many connections may wait for Accept().
   */
  void Listen(SInt32 port, SInt32 queueLength = 10);

  /** Waits for a connection. @param socket  becomes that connection; what it was is closed. */
  void Accept(CTCPSocket& socket);

  /** Closes; does nothing if closed already. */
  void Disconnect();

  /** Is there an open connection or port? */
  bool IsConnected() const { return m_descriptor >= 0; }

  /** The file descriptor; -1 if closed. */
  SInt32 GetStream() const { return m_descriptor; }

  /** The other side's address, for a listening socket its own; "" if closed. */
  const std::string& GetAddress() const { return m_address; }

  /** The port on this machine. */
  SInt32 GetPort() const;

  /** What can be done without blocking, now. */
  std::set<EEvent> GetEvents() const;

  /** Bytes as they are. */
  void SendBuffer(const UInt8* buffer, std::size_t size);
  void ReceiveBuffer(UInt8* buffer, std::size_t size);

  /** A length, as a 32-bit unsigned integer in network byte order, then as many bytes. */
  void SendByteArray(const CByteArray& array);
  void ReceiveByteArray(CByteArray& array);

  /** A text; on the wire like a byte array. */
  void SendMsg(const std::string& message);
  void RecvMsg(std::string& message);

 private:
  void CheckOpen(const char* action) const;

  SInt32 m_descriptor = -1;
  std::string m_address;
};

}  // namespace argos

#endif
