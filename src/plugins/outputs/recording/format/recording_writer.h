#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_RECORDING_WRITER_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_RECORDING_WRITER_H

#include <argos3/core/utility/non_copyable.h>
#include <argos3/plugins/simulator/outputs/recording/format/recorded_frame.h>
#include <argos3/plugins/simulator/outputs/recording/format/recording_info.h>

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace argos {

/**
 * Writes a recording: codes, compresses and writes frames on a thread of its own.
 *
 * The file exists when the constructor returns, and can be read from then on up to the last whole
 * block: a block is written when it has 100 frames or 4 MiB, or when its first frame was added a
 * second ago. A file that cannot be written further is cut behind its last whole block.
 */
class CRecordingWriter : private CNonCopyable {
 public:
  /**
   * Creates the file, or replaces an older recording.
   * @throws CARGoSException with the file and the reason if it cannot be created, if another
   *   process writes it, or if a file of that name is no recording, which is then kept.
   */
  CRecordingWriter(const std::string& path, const SRecordingInfo& info);
  /**
   * Checks whether a recording could be written, without changing anything.
   * @throws CARGoSException as the constructor, but not because another process writes it.
   */
  static void Check(const std::string& path);
  /** As Close(); failures are lost. */
  ~CRecordingWriter();

  /** An empty update, with the memory of one that was written. */
  SFrameUpdate TakeUpdate();
  /**
   * Adds a frame. Waits while 64 MiB of frames wait to be written.
   * @param update  its ticks increase; the first one has all entities.
   * @throws CARGoSException if an earlier frame could not be written.
   */
  void Add(SFrameUpdate&& update);
  /**
   * Writes what is left and the index, and closes the file. Does nothing if it is closed.
   * @throws CARGoSException if not all could be written; silent if that was thrown before.
   */
  void Close();

  /** Bytes of frames before compression, with their key frames; after Close(). */
  UInt64 GetNumCodedBytes() const;
  /** Bytes of the file; after Close(). */
  UInt64 GetNumWrittenBytes() const;

 private:
  class CBlocks;

  void Run();
  void ThrowIfFailed();
  void Fail(std::string reason);

  std::string m_path;
  std::unique_ptr<CBlocks> m_blocks;  // used by the thread while it runs

  std::mutex m_mutex;  // guards what follows
  std::condition_variable m_isChanged;
  std::deque<SFrameUpdate> m_queue;
  size_t m_queuedBytes = 0;
  std::vector<SFrameUpdate> m_free;
  std::string m_failure;  // empty: none
  bool m_wasThrown = false;
  bool m_isClosing = false;

  std::thread m_thread;
};

}  // namespace argos

#endif
