#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_RECORDING_BLOCKS_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_RECORDING_BLOCKS_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/non_copyable.h>

#include <optional>
#include <string>
#include <string_view>

namespace argos {

/**
 * @file The parts of the file of a recording. Numbers have their lowest byte first.
 *
 *   "ARGOSREC", version of the format (4 bytes), 0 (4 bytes)
 *   blocks: header (SBlockHeader), content compressed by zstd
 *   "ARGOSEND", place of the index block (8 bytes): only of a recording that was finished
 *
 * A file only grows, by whole blocks in one write each, so a recording can be read up to the last
 * block that was written, however the run has ended.
 */

constexpr std::string_view kRecordingMagic = "ARGOSREC";
constexpr std::string_view kRecordingEnd = "ARGOSEND";
/**
 * Readers refuse higher versions. What readers may skip (blocks, sections of frames, and entries of
 * the information that they do not know) does not raise it.
 */
constexpr UInt32 kRecordingVersion = 1;
constexpr size_t kFileHeaderSize = 16;  // bytes
constexpr size_t kFileFooterSize = 16;  // bytes
constexpr size_t kBlockHeaderSize = 44;  // bytes
/** Of a block before compression, bytes; readers refuse more. */
constexpr size_t kMaxBlockBytes = size_t(1) << 29;

/** Kinds of blocks; numbers are never used again for something else. */
enum class EBlock : UInt32 {
  Info = 1, /**< SRecordingInfo; the first block */
  Floor = 2, /**< the whole floor, for the key frames that name its place */
  Frames = 3, /**< a key frame and those that follow */
  Index = 4 /**< place and ticks of each block of frames */
};

/** What precedes the content of a block. */
struct SBlockHeader {
  EBlock Kind = EBlock::Info;
  UInt32 FirstTick = 0; /**< first tick of frames */
  UInt32 LastTick = 0;
  UInt64 FloorPlace = 0; /**< place of the block with the floor at the first tick; 0: no floor */
  UInt32 Size = 0; /**< size of the content, bytes */
  UInt32 PackedSize = 0; /**< size of the compressed content, bytes */
  UInt64 Checksum = 0; /**< checksum of the compressed content */
};

/** "ARGOSREC" and the version. */
std::string MakeFileHeader();
/** "ARGOSEND" and the place of the index. */
std::string MakeFileFooter(UInt64 indexPlace);

/** Compresses blocks; keeps its memory. */
class CBlockPacker : private CNonCopyable {
 public:
  /** @param level  of zstd, 1 to 19. */
  explicit CBlockPacker(int level);
  ~CBlockPacker();

  /**
   * @param header  its sizes and checksum are ignored.
   * @return header and compressed content, valid until the next call.
   * @throws CARGoSException if it is larger than kMaxBlockBytes, or if there is no memory.
   */
  std::string_view Pack(const SBlockHeader& header, std::string_view content);

 private:
  void* m_context;  // context of zstd
  int m_level;
  std::string m_block;
};

/** @param bytes kBlockHeaderSize of them. @return nothing if they are no header. */
std::optional<SBlockHeader> ReadBlockHeader(std::string_view bytes);
/** @throws CARGoSException if the content does not fit to the header. */
void UnpackBlock(const SBlockHeader& header, std::string_view packed, std::string& content);

}  // namespace argos

#endif
