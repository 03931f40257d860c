#include <argos3/plugins/simulator/outputs/recording/format/recording_reader.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/files/input_file.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace argos {

namespace {

// the text of the exception that is being handled, without the prefix of ours
std::string DescribeCause() {
  constexpr std::string_view kPrefix = "[FATAL] ";
  std::string text = DescribeCurrentException();
  if (text.rfind(kPrefix, 0) == 0) {
    text.erase(0, kPrefix.size());
  }
  return text;
}

}  // namespace

CRecordingReader::CRecordingReader(const std::string& path) : m_path(path) {
  const std::string problem = FindInputProblem(path);
  if (problem.empty()) {
    m_file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  }
  struct stat information {};
  if (m_file < 0 || fstat(m_file, &information) != 0) {
    THROW_ARGOSEXCEPTION("cannot open the recording \""
                         << path << "\": " << (problem.empty() ? std::strerror(errno) : problem));
  }
  m_size = static_cast<UInt64>(information.st_size);
  try {
    Open();
  } catch (...) {
    ::close(m_file);
    throw;
  }
}

CRecordingReader::~CRecordingReader() {
  ::close(m_file);
}

void CRecordingReader::Open() {
  CheckFileHeader();
  const SBlockHeader header = ReadHeader(kFileHeaderSize, EBlock::Info);
  std::string content;
  ReadContent(kFileHeaderSize, header, content);
  try {
    m_info = ReadInfo(content);
  } catch (const CARGoSException&) {
    ThrowDamaged(kFileHeaderSize, DescribeCause());
  }
  if (!TryReadIndex()) {
    FindBlocks();
  }
  if (m_blocks.empty()) {
    THROW_ARGOSEXCEPTION("the recording \""
                         << m_path << "\" has no state of any tick: the run that made it was "
                         << "killed, or failed, in its first second");
  }
  Seek(0);
}

// parts of the file

std::string CRecordingReader::ReadAt(UInt64 place, UInt64 size) const {
  std::string bytes(size, '\0');
  size_t done = 0;
  while (done < size) {
    const ssize_t count =
        ::pread(m_file, bytes.data() + done, size - done, static_cast<off_t>(place + done));
    if (count == 0 || (count < 0 && errno != EINTR)) {
      THROW_ARGOSEXCEPTION("cannot read the recording \""
                           << m_path << "\": "
                           << (count == 0 ? "it has become shorter" : std::strerror(errno)));
    }
    done += static_cast<size_t>(std::max<ssize_t>(count, 0));
  }
  return bytes;
}

void CRecordingReader::CheckFileHeader() const {
  const std::string begin = ReadAt(0, std::min<UInt64>(m_size, kFileHeaderSize));
  if (begin.empty()) {
    THROW_ARGOSEXCEPTION("\"" << m_path << "\" is no recording: it is empty");
  }
  if (std::string_view(begin).substr(0, kRecordingMagic.size()) != kRecordingMagic) {
    const bool isXml = begin.find('<') != std::string::npos;
    THROW_ARGOSEXCEPTION("\"" << m_path << "\" is no recording: it does not begin with \""
                              << kRecordingMagic << '"'
                              << (isXml ? "; an experiment file goes after -c" : ""));
  }
  if (begin.size() < kFileHeaderSize) {
    ThrowDamaged(0, "its header is cut");
  }
  const UInt32 version =
      CByteReader(std::string_view(begin).substr(kRecordingMagic.size())).ReadFixed32();
  if (version > kRecordingVersion) {
    THROW_ARGOSEXCEPTION("the recording \"" << m_path << "\" has version " << version
                                            << " of the format, and this program reads versions "
                                               "up to "
                                            << kRecordingVersion
                                            << ": it needs a newer version of argos3");
  }
}

void CRecordingReader::ThrowDamaged(UInt64 place, const std::string& cause) const {
  THROW_ARGOSEXCEPTION("the recording \"" << m_path << "\" is damaged in the block at byte "
                                          << place << ": " << cause);
}

std::optional<SBlockHeader> CRecordingReader::TryReadHeader(UInt64 place) const {
  if (place > m_size || m_size - place < kBlockHeaderSize) {
    return std::nullopt;
  }
  return ReadBlockHeader(ReadAt(place, kBlockHeaderSize));
}

SBlockHeader CRecordingReader::ReadHeader(UInt64 place, EBlock kind) const {
  const std::optional<SBlockHeader> header = TryReadHeader(place);
  if (!header || header->Kind != kind) {
    ThrowDamaged(place, "its header is wrong");
  }
  return *header;
}

void CRecordingReader::ReadContent(UInt64 place, const SBlockHeader& header,
                                   std::string& content) const {
  const UInt64 start = place + kBlockHeaderSize;
  if (header.PackedSize > m_size - start) {
    ThrowDamaged(place, "the file ends in it");
  }
  const std::string packed = ReadAt(start, header.PackedSize);
  try {
    UnpackBlock(header, packed, content);
  } catch (const CARGoSException&) {
    ThrowDamaged(place, DescribeCause());
  }
}

// finding blocks

bool CRecordingReader::TryReadIndex() {
  if (m_size < kFileFooterSize) {
    return false;
  }
  const std::string footer = ReadAt(m_size - kFileFooterSize, kFileFooterSize);
  if (std::string_view(footer).substr(0, kRecordingEnd.size()) != kRecordingEnd) {
    return false;
  }
  const UInt64 place =
      CByteReader(std::string_view(footer).substr(kRecordingEnd.size())).ReadFixed64();
  try {
    ReadIndex(place);
    return true;
  } catch (const CARGoSException&) {
    // the blocks can be found without it
    m_blocks.clear();
    return false;
  }
}

void CRecordingReader::ReadIndex(UInt64 place) {
  std::string content;
  ReadContent(place, ReadHeader(place, EBlock::Index), content);
  CByteReader in(content);
  UInt64 next = 0;
  while (!in.IsAtEnd()) {
    SBlock block{};
    next += in.ReadNumberUpTo(m_size - next, "place of a block");
    block.Place = next;
    block.FirstTick = static_cast<UInt32>(in.ReadNumberUpTo(~UInt32(0), "tick"));
    block.LastTick = block.FirstTick + static_cast<UInt32>(in.ReadNumberUpTo(
                                           ~UInt32(0) - block.FirstTick, "number of ticks"));
    if (!m_blocks.empty() && block.FirstTick <= m_blocks.back().LastTick) {
      ThrowDamaged(place, "its ticks are not in order");
    }
    m_blocks.push_back(block);
  }
}

void CRecordingReader::FindBlocks() {
  UInt64 place = kFileHeaderSize;
  while (place < m_size) {
    const std::optional<SBlockHeader> header = TryReadHeader(place);
    if (!header) {
      break;
    }
    const UInt64 end = place + kBlockHeaderSize + header->PackedSize;
    if (end > m_size) {
      break;
    }
    if (header->Kind == EBlock::Frames) {
      if (!m_blocks.empty() && header->FirstTick <= m_blocks.back().LastTick) {
        ThrowDamaged(place, "its ticks are not in order");
      }
      m_blocks.push_back({place, header->FirstTick, header->LastTick});
    }
    place = end;
  }
  // a block of zeros, or the start of one, may be what a crash of the system leaves
  const std::string rest =
      place < m_size ? ReadAt(place, std::min<UInt64>(m_size - place, kBlockHeaderSize)) : "";
  const bool isCut = rest.size() < kBlockHeaderSize || ReadBlockHeader(rest).has_value() ||
                     rest.find_first_not_of('\0') == std::string::npos ||
                     std::string_view(rest).substr(0, kRecordingEnd.size()) == kRecordingEnd;
  if (!isCut) {
    ThrowDamaged(place, "its header is wrong");
  }
  place = DropDamagedEnd(place);
  if (m_blocks.empty()) {
    return;
  }
  m_warning = "the recording \"" + m_path + "\" was not finished";
  if (place < m_size) {
    m_warning += ", or was cut";
  }
  m_warning += ": it ends with tick " + std::to_string(GetLastTick());
  if (place < m_size) {
    m_warning += ", and its last " + std::to_string(m_size - place) + " bytes are not used";
  }
}

// the last block may have been written only in part; @return the new end
UInt64 CRecordingReader::DropDamagedEnd(UInt64 end) {
  if (m_blocks.empty()) {
    return end;
  }
  const UInt64 place = m_blocks.back().Place;
  const SBlockHeader header = ReadHeader(place, EBlock::Frames);
  std::string content;
  try {
    ReadContent(place, header, content);
    return end;
  } catch (const CARGoSException&) {
    m_blocks.pop_back();
    return place;
  }
}

// frames

void CRecordingReader::Seek(UInt32 tick) {
  const auto found = std::find_if(m_blocks.begin(), m_blocks.end(),
                                  [tick](const SBlock& block) { return block.LastTick >= tick; });
  m_nextBlock = static_cast<size_t>(found - m_blocks.begin());
  m_frames = CByteReader("");
  m_from = tick;
}

UInt32 CRecordingReader::FindLastTickUpTo(UInt32 tick) {
  if (tick >= GetLastTick()) {
    return GetLastTick();
  }
  auto block = std::find_if(m_blocks.begin(), m_blocks.end(),
                            [tick](const SBlock& later) { return later.FirstTick > tick; });
  if (block == m_blocks.begin()) {
    return GetFirstTick();
  }
  --block;
  UInt32 last = block->FirstTick;
  Seek(last);
  for (const SRecordedFrame* frame = ReadNext(); frame != nullptr && frame->Tick <= tick;
       frame = ReadNext()) {
    last = frame->Tick;
  }
  return last;
}

bool CRecordingReader::OpenNextBlock() {
  if (m_nextBlock >= m_blocks.size()) {
    return false;
  }
  const UInt64 place = m_blocks[m_nextBlock++].Place;
  const SBlockHeader header = ReadHeader(place, EBlock::Frames);
  if (header.FloorPlace == 0) {
    m_floor.reset();
  } else if (header.FloorPlace != m_floorPlace || m_floor == nullptr) {
    std::string content;
    ReadContent(header.FloorPlace, ReadHeader(header.FloorPlace, EBlock::Floor), content);
    try {
      CByteReader in(content);
      m_floor = ReadFloor(in);
    } catch (const CARGoSException&) {
      ThrowDamaged(header.FloorPlace, DescribeCause());
    }
  }
  m_floorPlace = header.FloorPlace;
  ReadContent(place, header, m_content);
  m_frames = CByteReader(m_content);
  if (!m_decoder) {
    m_decoder.emplace(m_info.Precision);
  }
  m_decoder->SetFloor(m_floor);
  m_isKeyNext = true;
  return true;
}

const SRecordedFrame* CRecordingReader::ReadNext() {
  while (true) {
    if (m_frames.IsAtEnd() && !OpenNextBlock()) {
      return nullptr;
    }
    const SRecordedFrame* frame = nullptr;
    try {
      frame = &m_decoder->Decode(m_frames, m_isKeyNext);
    } catch (const CARGoSException&) {
      m_frames = CByteReader("");
      ThrowDamaged(m_blocks[m_nextBlock - 1].Place, DescribeCause());
    }
    m_isKeyNext = false;
    if (frame->Tick >= m_from) {
      return frame;
    }
  }
}

}  // namespace argos
