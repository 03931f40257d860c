#include <argos3/plugins/simulator/outputs/recording/format/recording_writer.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/plugins/simulator/outputs/recording/format/frame_coding.h>
#include <argos3/plugins/simulator/outputs/recording/format/growing_file.h>
#include <argos3/plugins/simulator/outputs/recording/format/recording_blocks.h>

#include <chrono>
#include <utility>

namespace argos {

namespace {

// compromises between the size of the file (key frames) and what a killed run loses
constexpr UInt32 kFramesPerBlock = 100;
constexpr size_t kBytesPerBlock = size_t(1) << 22;
constexpr std::chrono::seconds kMaxWait(1);

constexpr size_t kMaxQueuedBytes = size_t(1) << 26;
constexpr size_t kMaxFreeUpdates = 8;
// level of zstd: in the rooms, 3 would save 4 % of the size for twice the time
constexpr int kLevel = 1;

}  // namespace

/* Frames on their way into blocks; used by one thread. */
class CRecordingWriter::CBlocks {
 public:
  CBlocks(const std::string& path, const SRecordingInfo& info)
      : m_packer(kLevel), m_encoder(info.Precision) {
    std::string start = MakeFileHeader();
    start += m_packer.Pack({}, WriteInfo(info));
    m_file.Create(path, kRecordingMagic, start);
  }

  bool IsEmpty() const { return m_numFrames == 0; }

  void Add(SFrameUpdate& update) {
    const bool isFull = m_numFrames >= kFramesPerBlock || m_frames.size() >= kBytesPerBlock;
    if (isFull || !HasSameSize(update.Floor.get(), m_lastFloor.get())) {
      Flush();
    }
    const bool isKey = IsEmpty();
    if (isKey) {
      WriteFloor(update.Floor);
      m_header.FirstTick = update.Tick;
    }
    m_header.LastTick = update.Tick;
    m_lastFloor = update.Floor;
    m_encoder.Encode(update, isKey, m_frames);
    ++m_numFrames;
  }

  /** Writes the frames as a block. */
  void Flush() {
    if (IsEmpty()) {
      return;
    }
    m_header.Kind = EBlock::Frames;
    CByteWriter index(m_index);
    index.WriteNumber(m_file.GetSize() - m_lastPlace);
    index.WriteNumber(m_header.FirstTick);
    index.WriteNumber(m_header.LastTick - m_header.FirstTick);
    m_lastPlace = m_file.GetSize();
    m_file.Append(m_packer.Pack(m_header, m_frames));
    m_numCodedBytes += m_frames.size();
    m_frames.clear();
    m_numFrames = 0;
  }

  void Finish() {
    Flush();
    SBlockHeader header;
    header.Kind = EBlock::Index;
    const UInt64 place = m_file.GetSize();
    m_file.Append(m_packer.Pack(header, m_index));
    m_file.Append(MakeFileFooter(place));
    m_size = m_file.GetSize();
    m_file.Close();
  }

  /** Closes the file without an index. */
  void Abandon() { m_file.Abandon(); }

  UInt64 GetNumCodedBytes() const { return m_numCodedBytes; }
  UInt64 GetSize() const { return m_size; }

 private:
  static bool HasSameSize(const SRecordedFloor* a, const SRecordedFloor* b) {
    return a == b ||
           (a != nullptr && b != nullptr && a->Width == b->Width && a->Height == b->Height);
  }

  // key frames name the block that has their floor
  void WriteFloor(const std::shared_ptr<const SRecordedFloor>& floor) {
    if (floor == nullptr) {
      m_header.FloorPlace = 0;
    } else if (floor != m_writtenFloor) {
      SBlockHeader header;
      header.Kind = EBlock::Floor;
      std::string bytes;
      CByteWriter out(bytes);
      argos::WriteFloor(*floor, out);
      m_header.FloorPlace = m_file.GetSize();
      m_file.Append(m_packer.Pack(header, bytes));
    }
    m_writtenFloor = floor;
  }

  CGrowingFile m_file;
  CBlockPacker m_packer;
  CFrameEncoder m_encoder;
  std::string m_frames;  // frames of the block
  UInt32 m_numFrames = 0;
  SBlockHeader m_header;  // header of the block
  std::shared_ptr<const SRecordedFloor> m_lastFloor;  // floor of the last frame
  std::shared_ptr<const SRecordedFloor> m_writtenFloor;  // floor at m_header.FloorPlace
  std::string m_index;
  UInt64 m_lastPlace = 0;  // place of a block of frames
  UInt64 m_numCodedBytes = 0;
  UInt64 m_size = 0;
};

CRecordingWriter::CRecordingWriter(const std::string& path, const SRecordingInfo& info)
    : m_path(path) {
  try {
    m_blocks = std::make_unique<CBlocks>(path, info);
  } catch (const CARGoSException&) {
    Fail(DescribeCurrentException());
    ThrowIfFailed();
  }
  m_thread = std::thread([this] { Run(); });
}

void CRecordingWriter::Check(const std::string& path) {
  try {
    CGrowingFile::Check(path, kRecordingMagic);
  } catch (const CARGoSException&) {
    ThrowWithCause("cannot write the recording \"" + path + '"');
  }
}

CRecordingWriter::~CRecordingWriter() {
  try {
    Close();
  } catch (const std::exception&) {
    // Close() before would have thrown it
    return;
  }
}

SFrameUpdate CRecordingWriter::TakeUpdate() {
  const std::lock_guard<std::mutex> lock(m_mutex);
  if (m_free.empty()) {
    return {};
  }
  SFrameUpdate update = std::move(m_free.back());
  m_free.pop_back();
  return update;
}

void CRecordingWriter::Add(SFrameUpdate&& update) {
  std::unique_lock<std::mutex> lock(m_mutex);
  m_isChanged.wait(lock, [this] { return m_queuedBytes < kMaxQueuedBytes || !m_failure.empty(); });
  if (!m_failure.empty()) {
    lock.unlock();
    ThrowIfFailed();
    return;
  }
  m_queuedBytes += update.ComputeSize();
  m_queue.push_back(std::move(update));
  lock.unlock();
  m_isChanged.notify_all();
}

void CRecordingWriter::Close() {
  if (m_thread.joinable()) {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_isClosing = true;
    }
    m_isChanged.notify_all();
    m_thread.join();
  }
  ThrowIfFailed();
}

UInt64 CRecordingWriter::GetNumCodedBytes() const {
  return m_blocks->GetNumCodedBytes();
}

UInt64 CRecordingWriter::GetNumWrittenBytes() const {
  return m_blocks->GetSize();
}

void CRecordingWriter::Fail(std::string reason) {
  constexpr std::string_view kPrefix = "[FATAL] ";
  if (reason.rfind(kPrefix, 0) == 0) {
    reason.erase(0, kPrefix.size());
  }
  const std::lock_guard<std::mutex> lock(m_mutex);
  m_failure = "cannot write the recording \"" + m_path + "\": " + reason;
}

void CRecordingWriter::ThrowIfFailed() {
  std::string failure;
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    failure = std::exchange(m_wasThrown, !m_failure.empty()) ? "" : m_failure;
  }
  if (!failure.empty()) {
    THROW_ARGOSEXCEPTION(failure);
  }
}

void CRecordingWriter::Run() {
  try {
    std::unique_lock<std::mutex> lock(m_mutex);
    while (true) {
      const auto hasWork = [this] { return !m_queue.empty() || m_isClosing; };
      if (m_blocks->IsEmpty()) {
        m_isChanged.wait(lock, hasWork);
      } else if (!m_isChanged.wait_for(lock, kMaxWait, hasWork)) {
        lock.unlock();
        m_blocks->Flush();
        lock.lock();
        continue;
      }
      if (m_queue.empty()) {
        break;
      }
      SFrameUpdate update = std::move(m_queue.front());
      m_queue.pop_front();
      m_queuedBytes -= update.ComputeSize();
      lock.unlock();
      m_isChanged.notify_all();
      m_blocks->Add(update);
      update.Clear();
      lock.lock();
      if (m_free.size() < kMaxFreeUpdates) {
        m_free.push_back(std::move(update));
      }
    }
    lock.unlock();
    m_blocks->Finish();
  } catch (...) {
    m_blocks->Abandon();
    Fail(DescribeCurrentException());
    m_isChanged.notify_all();
  }
}

}  // namespace argos
