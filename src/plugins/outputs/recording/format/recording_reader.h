#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_RECORDING_READER_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_RECORDING_READER_H

#include <argos3/core/utility/non_copyable.h>
#include <argos3/plugins/simulator/outputs/recording/format/frame_coding.h>
#include <argos3/plugins/simulator/outputs/recording/format/recording_blocks.h>
#include <argos3/plugins/simulator/outputs/recording/format/recording_info.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace argos {

/**
 * Reads a recording, from any tick on. What is thrown names the file.
 *
 * Blocks are found by the index at the file's end. If there is none, because the run was killed or
 * still goes on, or because the file was cut, they are found one after another, and the recording
 * ends with the last whole one.
 */
class CRecordingReader : private CNonCopyable {
 public:
  /**
   * Opens a file and finds its blocks.
   * @throws CARGoSException if it cannot be read, is no recording, is one of a newer version, is
   *   damaged, or has no state of any tick.
   */
  explicit CRecordingReader(const std::string& path);
  ~CRecordingReader();

  const std::string& GetPath() const { return m_path; }
  const SRecordingInfo& GetInfo() const { return m_info; }
  /** Of the first and the last state. */
  UInt32 GetFirstTick() const { return m_blocks.front().FirstTick; }
  UInt32 GetLastTick() const { return m_blocks.back().LastTick; }
  /** What is missing at the end of a recording that was not finished; empty if it is complete. */
  const std::string& GetWarning() const { return m_warning; }

  /** @return the last tick up to @p tick that has a state; the first one if there is none. */
  UInt32 FindLastTickUpTo(UInt32 tick);
  /** The next call of ReadNext() gives the first state at this tick or later. */
  void Seek(UInt32 tick);
  /**
   * @return the next state, valid until the next call; null at the end.
   * @throws CARGoSException if the file is damaged there.
   */
  const SRecordedFrame* ReadNext();

 private:
  struct SBlock {
    UInt64 Place;
    UInt32 FirstTick;
    UInt32 LastTick;
  };

  void Open();
  std::string ReadAt(UInt64 place, UInt64 size) const;
  void CheckFileHeader() const;
  std::optional<SBlockHeader> TryReadHeader(UInt64 place) const;
  SBlockHeader ReadHeader(UInt64 place, EBlock kind) const;
  void ReadContent(UInt64 place, const SBlockHeader& header, std::string& content) const;
  bool TryReadIndex();
  void ReadIndex(UInt64 place);
  void FindBlocks();
  UInt64 DropDamagedEnd(UInt64 end);
  bool OpenNextBlock();
  [[noreturn]] void ThrowDamaged(UInt64 place, const std::string& cause) const;

  std::string m_path;
  int m_file = -1;
  UInt64 m_size = 0;  // size of the file, bytes
  SRecordingInfo m_info;
  std::vector<SBlock> m_blocks;  // blocks of frames
  std::string m_warning;

  std::optional<CFrameDecoder> m_decoder;
  size_t m_nextBlock = 0;
  std::string m_content;  // content of the present block
  CByteReader m_frames{""};  // the rest of m_content
  bool m_isKeyNext = false;
  UInt64 m_floorPlace = 0;
  std::shared_ptr<const SRecordedFloor> m_floor;  // floor at m_floorPlace
  UInt32 m_from = 0;  // states before this tick are skipped
};

}  // namespace argos

#endif
