#include <argos3/campaign/execution/message_stream.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace argos {

namespace {

constexpr char kMagic[] = "AC";
constexpr char kVersion = 1;
constexpr size_t kHeaderSize = 8;

bool WriteAll(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(file, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) {
      return false;
    }
    bytes.remove_prefix(count > 0 ? static_cast<size_t>(count) : 0);
  }
  return true;
}

}  // namespace

bool WriteMessage(int file, SMessage::EKind kind, std::string_view body) {
  if (body.size() > CMessageReader::kMaxSize) {
    return false;
  }
  const auto size = static_cast<UInt32>(body.size());
  std::string bytes(kMagic, 2);
  bytes += kVersion;
  bytes += static_cast<char>(kind);
  for (int i = 0; i < 4; ++i) {
    bytes += static_cast<char>(size >> (8 * i));
  }
  return WriteAll(file, bytes.append(body));
}

bool CMessageReader::Fill(int file) {
  std::array<char, 1 << 16> buffer;
  ssize_t count = 0;
  do {
    count = read(file, buffer.data(), buffer.size());
  } while (count < 0 && errno == EINTR);
  if (count > 0) {
    m_bytes.append(buffer.data(), static_cast<size_t>(count));
  }
  return count > 0 || (count < 0 && errno == EAGAIN);
}

std::optional<SMessage> CMessageReader::Take() {
  if (m_bytes.size() < kHeaderSize) {
    return std::nullopt;
  }
  UInt32 size = 0;
  for (size_t i = 0; i < 4; ++i) {
    size |= static_cast<UInt32>(static_cast<UInt8>(m_bytes[4 + i])) << (8 * i);
  }
  const auto kind = static_cast<UInt8>(m_bytes[3]);
  if (m_bytes.compare(0, 2, kMagic) != 0 || m_bytes[2] != kVersion || kind < 1 || kind > 3 ||
      size > kMaxSize) {
    THROW_ARGOSEXCEPTION("a process of the campaign sent bytes that are no message");
  }
  if (m_bytes.size() - kHeaderSize < size) {
    return std::nullopt;
  }
  SMessage message{static_cast<SMessage::EKind>(kind), m_bytes.substr(kHeaderSize, size)};
  m_bytes.erase(0, kHeaderSize + size);
  return message;
}

}  // namespace argos
