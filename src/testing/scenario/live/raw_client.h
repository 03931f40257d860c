#ifndef ARGOS3_TESTING_SCENARIO_LIVE_RAW_CLIENT_H
#define ARGOS3_TESTING_SCENARIO_LIVE_RAW_CLIENT_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <memory>
#include <string>
#include <string_view>

namespace argos {

/** How a frame of a WebSocket is written, right or wrong. */
struct SRawFrame {
  UInt8 FirstByte = 0x81; /**< flags and opcode: the only fragment of a text */
  bool IsMasked = true; /**< as the frames of clients must be */
  SInt64 ExtraLength = 0; /**< said, but not there */
};

/** The bytes of a frame. */
std::string MakeFrame(std::string_view payload, const SRawFrame& frame = {});

/** A connection to a live view that sends any bytes. Failures to send are ignored. */
class CRawClient {
 public:
  /** Only connects. @throws std::runtime_error if that is refused. */
  explicit CRawClient(const std::string& url);
  ~CRawClient();
  CRawClient(const CRawClient&) = delete;
  CRawClient& operator=(const CRawClient&) = delete;

  /** Becomes a viewer: the handshake and the token. */
  void Join();
  /** The handshake only. */
  void ShakeHands();
  void Send(std::string_view bytes);
  /** @return true if the server closes the connection within that time; what it sends is ignored.
   */
  bool IsClosedWithin(Real seconds);

 private:
  class CSocket;
  std::unique_ptr<CSocket> m_socket;
  std::string m_host;
  std::string m_token;
};

}  // namespace argos

#endif
