#ifndef ARGOS3_CAMPAIGN_EXECUTION_MESSAGE_STREAM_H
#define ARGOS3_CAMPAIGN_EXECUTION_MESSAGE_STREAM_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <optional>
#include <string>
#include <string_view>

namespace argos {

/** A message between the processes of a campaign. */
struct SMessage {
  enum class EKind : UInt8 {
    Request = 1, /**< goes to a worker, to a run's process: SRunRequest */
    Result = 2, /**< comes from them: SRunResult */
    Error = 3 /**< comes from a worker that cannot start: the text */
  };
  EKind Kind = EKind::Error;
  std::string Body;
};

/**
 * Writes a message to a blocking pipe: "AC", version, kind, length of the body in 4 bytes, body.
 * @return false if there is no reader.
 */
bool WriteMessage(int file, SMessage::EKind kind, std::string_view body);

/** Reads messages from a pipe, in any pieces. */
class CMessageReader {
 public:
  /** Largest body. A series has 12 bytes a value. */
  static constexpr UInt32 kMaxSize = 1 << 30;

  /**
   * Reads once, what is there; waits only if the pipe is blocking.
   * @return false at the end of the pipe, or if it failed.
   */
  bool Fill(int file);
  /**
   * @return the next complete message, if there is one.
   * @throws CARGoSException if the bytes are no message of this version.
   */
  std::optional<SMessage> Take();

 private:
  std::string m_bytes;
};

}  // namespace argos

#endif
