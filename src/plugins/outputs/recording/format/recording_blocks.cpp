#include <argos3/plugins/simulator/outputs/recording/format/recording_blocks.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/support/byte_stream.h>

#include <zstd.h>

#include <cstring>

namespace argos {

namespace {

constexpr UInt32 kBlockMagic = 0x4b4c4241;  // "ABLK"
constexpr size_t kCheckedSize = kBlockHeaderSize - 4;  // bytes of a header before its own checksum

// checksum of the bytes and their number; finds damage, is no protection against intent
UInt64 ComputeChecksum(std::string_view bytes) {
  UInt64 sum = 0x9e3779b97f4a7c15ULL ^ bytes.size();
  const auto mix = [&sum](UInt64 word) {
    sum = (sum ^ word) * 0xff51afd7ed558ccdULL;
    sum ^= sum >> 32;
  };
  while (bytes.size() >= sizeof(UInt64)) {
    UInt64 word = 0;
    std::memcpy(&word, bytes.data(), sizeof(word));
    mix(word);
    bytes.remove_prefix(sizeof(word));
  }
  UInt64 rest = 0;
  for (const char byte : bytes) {
    rest = rest << 8 | static_cast<UInt8>(byte);
  }
  mix(rest);
  return sum;
}

void WriteHeader(const SBlockHeader& header, std::string& bytes) {
  CByteWriter out(bytes);
  out.WriteFixed32(kBlockMagic);
  out.WriteFixed32(static_cast<UInt32>(header.Kind));
  out.WriteFixed32(header.FirstTick);
  out.WriteFixed32(header.LastTick);
  out.WriteFixed64(header.FloorPlace);
  out.WriteFixed32(header.Size);
  out.WriteFixed32(header.PackedSize);
  out.WriteFixed64(header.Checksum);
  out.WriteFixed32(static_cast<UInt32>(ComputeChecksum(bytes)));
}

}  // namespace

std::string MakeFileHeader() {
  std::string bytes(kRecordingMagic);
  CByteWriter out(bytes);
  out.WriteFixed32(kRecordingVersion);
  out.WriteFixed32(0);
  return bytes;
}

std::string MakeFileFooter(UInt64 indexPlace) {
  std::string bytes(kRecordingEnd);
  CByteWriter(bytes).WriteFixed64(indexPlace);
  return bytes;
}

CBlockPacker::CBlockPacker(int level) : m_context(ZSTD_createCCtx()), m_level(level) {
  if (m_context == nullptr) {
    THROW_ARGOSEXCEPTION("there is no memory to compress it");
  }
}

CBlockPacker::~CBlockPacker() {
  ZSTD_freeCCtx(static_cast<ZSTD_CCtx*>(m_context));
}

std::string_view CBlockPacker::Pack(const SBlockHeader& header, std::string_view content) {
  if (content.size() > kMaxBlockBytes) {
    THROW_ARGOSEXCEPTION("the state of one tick takes "
                         << content.size() << " bytes, more than the possible " << kMaxBlockBytes);
  }
  m_block.resize(kBlockHeaderSize + ZSTD_compressBound(content.size()));
  const size_t size =
      ZSTD_compressCCtx(static_cast<ZSTD_CCtx*>(m_context), m_block.data() + kBlockHeaderSize,
                        m_block.size() - kBlockHeaderSize, content.data(), content.size(), m_level);
  if (ZSTD_isError(size) != 0) {
    THROW_ARGOSEXCEPTION("it cannot be compressed: " << ZSTD_getErrorName(size));
  }
  m_block.resize(kBlockHeaderSize + size);
  SBlockHeader complete = header;
  complete.Size = static_cast<UInt32>(content.size());
  complete.PackedSize = static_cast<UInt32>(size);
  complete.Checksum = ComputeChecksum(std::string_view(m_block).substr(kBlockHeaderSize));
  std::string bytes;
  WriteHeader(complete, bytes);
  m_block.replace(0, kBlockHeaderSize, bytes);
  return m_block;
}

std::optional<SBlockHeader> ReadBlockHeader(std::string_view bytes) {
  CByteReader in(bytes);
  if (bytes.size() != kBlockHeaderSize || in.ReadFixed32() != kBlockMagic) {
    return std::nullopt;
  }
  SBlockHeader header;
  header.Kind = static_cast<EBlock>(in.ReadFixed32());
  header.FirstTick = in.ReadFixed32();
  header.LastTick = in.ReadFixed32();
  header.FloorPlace = in.ReadFixed64();
  header.Size = in.ReadFixed32();
  header.PackedSize = in.ReadFixed32();
  header.Checksum = in.ReadFixed64();
  const bool isWhole =
      in.ReadFixed32() == static_cast<UInt32>(ComputeChecksum(bytes.substr(0, kCheckedSize)));
  if (!isWhole || header.Size > kMaxBlockBytes || header.FirstTick > header.LastTick) {
    return std::nullopt;
  }
  return header;
}

void UnpackBlock(const SBlockHeader& header, std::string_view packed, std::string& content) {
  if (packed.size() != header.PackedSize || ComputeChecksum(packed) != header.Checksum) {
    THROW_ARGOSEXCEPTION("its checksum is wrong");
  }
  content.resize(header.Size);
  const size_t size = ZSTD_decompress(content.data(), content.size(), packed.data(), packed.size());
  if (ZSTD_isError(size) != 0 || size != header.Size) {
    THROW_ARGOSEXCEPTION("it cannot be decompressed"
                         << (ZSTD_isError(size) != 0 ? ": " : "")
                         << (ZSTD_isError(size) != 0 ? ZSTD_getErrorName(size) : ""));
  }
}

}  // namespace argos
