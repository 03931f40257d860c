#include <argos3/plugins/simulator/outputs/recording/format/frame_coding.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>
#include <bit>

namespace argos {

namespace {

// numbers of sections; never used again for something else
enum ESection : int {
  SECTION_ENTITIES = 1,
  SECTION_POSES = 2,
  SECTION_WORDS = 3,
  SECTION_RAYS = 4,
  SECTION_FLOOR = 5,
  SECTION_COLUMNS = 6,
  SECTION_DRAWING = 7,
  SECTION_METRICS = 8,
  SECTION_COMMANDS = 9
};

constexpr UInt32 kMaxPixels = 1 << 14;  // along one side of the floor
constexpr size_t kBytesPerPixel = 3;
constexpr size_t kMaxValues = size_t(1) << 24;  // number of values of all columns

void WriteMetrics(const std::vector<SRecordedMetric>& metrics, CByteWriter& out) {
  out.WriteNumber(metrics.size());
  for (const SRecordedMetric& metric : metrics) {
    out.WriteText(metric.Name);
    out.WriteText(metric.Unit);
    out.WriteReal(metric.Value);
  }
}

void ReadMetrics(std::vector<SRecordedMetric>& metrics, CByteReader& in) {
  const size_t count = in.ReadCount("number of metrics");
  for (size_t i = 0; i < count; ++i) {
    SRecordedMetric& metric = metrics.emplace_back();
    metric.Name = in.ReadText();
    metric.Unit = in.ReadText();
    metric.Value = in.ReadReal();
  }
}

void WriteCommands(const std::vector<SRecordedCommand>& commands, CByteWriter& out) {
  out.WriteNumber(commands.size());
  for (const SRecordedCommand& command : commands) {
    out.WriteNumber(command.Tick);
    out.WriteText(command.Text);
  }
}

void ReadCommands(std::vector<SRecordedCommand>& commands, CByteReader& in) {
  const size_t count = in.ReadCount("number of commands");
  for (size_t i = 0; i < count; ++i) {
    SRecordedCommand& command = commands.emplace_back();
    command.Tick = static_cast<UInt32>(in.ReadNumberUpTo(~UInt32(0), "tick of a command"));
    command.Text = in.ReadText();
  }
}

void WriteTexts(const std::vector<std::string>& texts, CByteWriter& out) {
  out.WriteNumber(texts.size());
  for (const std::string& text : texts) {
    out.WriteText(text);
  }
}

void ReadTexts(std::vector<std::string>& texts, CByteReader& in) {
  const size_t count = in.ReadCount("number of texts");
  for (size_t i = 0; i < count; ++i) {
    texts.emplace_back(in.ReadText());
  }
}

}  // namespace

// encoder

template <typename WRITE>
void CFrameEncoder::AddSection(int number, WRITE&& write) {
  m_section.clear();
  CByteWriter section(m_section);
  write(section);
  CByteWriter body(m_body);
  body.WriteNumber(static_cast<UInt64>(number));
  body.WriteText(m_section);
}

void CFrameEncoder::Resize(const CEntityTable::SChange& change) {
  if (change.IsRestart) {
    m_poses.Restart(0);
    m_words.clear();
  } else if (!change.RemovedPoses.empty() || !change.RemovedWords.empty()) {
    ARGOS_ASSERT(change.RemovedWords.size() == m_words.size(), "flags of another number of words");
    m_poses.Remove(change.RemovedPoses);
    size_t kept = 0;
    for (size_t i = 0; i < m_words.size(); ++i) {
      if (!change.RemovedWords[i]) {
        m_words[kept++] = m_words[i];
      }
    }
    m_words.resize(kept);
  }
  m_poses.Append(change.NumAddedPoses);
  m_words.resize(m_words.size() + change.NumAddedWords, 0);
  if (!change.IsEmpty) {
    m_rays.Restart();
    m_columns.Restart();
  }
}

void CFrameEncoder::EncodeWords(const std::vector<UInt32>& words, CByteWriter& out) {
  ARGOS_ASSERT(words.size() == m_words.size(),
               words.size() << " words, but entities have " << m_words.size());
  CSparseWriter sparse(out);
  for (size_t i = 0; i < words.size(); ++i) {
    sparse.Write(words[i] ^ m_words[i]);
  }
  sparse.Flush();
  m_words.assign(words.begin(), words.end());
}

void CFrameEncoder::Encode(SFrameUpdate& update, bool isKey, std::string& bytes) {
  m_body.clear();
  CByteWriter body(m_body);
  body.WriteNumber(update.Tick);
  body.WriteByte(isKey ? 1 : 0);
  const bool hasChanges = update.IsRestart || !update.NewTypes.empty() || !update.Removed.empty() ||
                          !update.Added.empty();
  if (!isKey && hasChanges) {
    AddSection(SECTION_ENTITIES,
               [&](CByteWriter& out) { CEntityTable::WriteChanges(update, out); });
  }
  const CEntityTable::SChange change = m_table.Apply(update);
  Resize(change);
  if (isKey) {
    AddSection(SECTION_ENTITIES, [&](CByteWriter& out) { m_table.WriteAll(out); });
    m_poses.Restart(m_table.GetNumPoses());
    std::fill(m_words.begin(), m_words.end(), 0);
    m_rays.Restart();
    m_columns.Restart();
    m_drawing.clear();
  }
  if (update.Poses.size() != m_table.GetNumPoses() || update.Words.size() != m_words.size()) {
    THROW_ARGOSEXCEPTION("a frame has " << update.Poses.size() << " poses and "
                                        << update.Words.size() << " words of its entities' "
                                        << m_table.GetNumPoses() << " and " << m_words.size());
  }
  AddSection(SECTION_POSES, [&](CByteWriter& out) { m_poses.Encode(update.Poses, out); });
  AddSection(SECTION_WORDS, [&](CByteWriter& out) { EncodeWords(update.Words, out); });
  AddSection(SECTION_RAYS, [&](CByteWriter& out) { m_rays.Encode(update.Rays, out); });
  if (!isKey && update.Floor != m_floor && update.Floor != nullptr && m_floor != nullptr) {
    AddSection(SECTION_FLOOR,
               [&](CByteWriter& out) { WriteFloorChange(*m_floor, *update.Floor, out); });
  }
  m_floor = update.Floor;
  if (!update.Columns.empty()) {
    AddSection(SECTION_COLUMNS, [&](CByteWriter& out) { m_columns.Encode(update.Columns, out); });
  }
  if (!update.Metrics.empty()) {
    AddSection(SECTION_METRICS, [&](CByteWriter& out) { WriteMetrics(update.Metrics, out); });
  }
  if (!update.Commands.empty()) {
    AddSection(SECTION_COMMANDS, [&](CByteWriter& out) { WriteCommands(update.Commands, out); });
  }
  if (update.Drawing != m_drawing || (isKey && !update.Drawing.empty())) {
    m_drawing = update.Drawing;
    AddSection(SECTION_DRAWING, [&](CByteWriter& out) { out.WriteText(m_drawing); });
  }
  CByteWriter(bytes).WriteText(m_body);
}

// decoder

const SRecordedFrame& CFrameDecoder::Decode(CByteReader& in, bool isKey) {
  CByteReader body(in.ReadText());
  const UInt32 lastTick = m_frame.Tick;
  m_frame.Tick = static_cast<UInt32>(body.ReadNumberUpTo(~UInt32(0), "tick"));
  m_isKey = body.ReadByte() != 0;
  if (m_isKey != isKey) {
    THROW_ARGOSEXCEPTION("the state of tick " << m_frame.Tick << " is "
                                              << (isKey ? "not complete" : "at the wrong place"));
  }
  if (!isKey && m_frame.Tick <= lastTick) {
    THROW_ARGOSEXCEPTION("tick " << m_frame.Tick << " follows tick " << lastTick);
  }
  m_frame.Rays.clear();
  m_frame.Columns.clear();
  m_frame.Metrics.clear();
  m_frame.Commands.clear();
  if (isKey) {
    m_table = CEntityTable();
    m_poses.Restart(0);
    m_frame.Words.clear();
    m_frame.Drawing.clear();
    m_rays.Restart();
    m_columns.Restart();
  }
  while (!body.IsAtEnd()) {
    const UInt64 number = body.ReadNumber();
    CByteReader section(body.ReadText());
    DecodeSection(number, section);
  }
  if (m_frame.Poses.size() != m_table.GetNumPoses() ||
      m_frame.Words.size() != m_table.GetNumWords()) {
    THROW_ARGOSEXCEPTION("the state of tick " << m_frame.Tick << " has no poses");
  }
  return m_frame;
}

void CFrameDecoder::DecodeSection(UInt64 number, CByteReader& in) {
  switch (number) {
    case SECTION_ENTITIES:
      ReadEntities(in);
      break;
    case SECTION_POSES:
      m_frame.Poses.resize(m_table.GetNumPoses());
      m_poses.Decode(m_frame.Poses, in);
      break;
    case SECTION_WORDS:
      DecodeWords(in);
      break;
    case SECTION_RAYS:
      m_rays.Decode(m_frame.Rays, m_table.GetEntities().size(), in);
      break;
    case SECTION_FLOOR:
      if (m_frame.Floor == nullptr) {
        THROW_ARGOSEXCEPTION("a floor changes that there is not");
      }
      m_frame.Floor = ReadFloorChange(*m_frame.Floor, in);
      break;
    case SECTION_COLUMNS:
      m_columns.Decode(m_frame.Columns, m_table.GetEntities().size(), in);
      break;
    case SECTION_METRICS:
      ReadMetrics(m_frame.Metrics, in);
      break;
    case SECTION_COMMANDS:
      ReadCommands(m_frame.Commands, in);
      break;
    case SECTION_DRAWING:
      m_frame.Drawing = in.ReadText();
      break;
    default:
      // a section of a later version
      break;
  }
}

void CFrameDecoder::ReadEntities(CByteReader& in) {
  SFrameUpdate update = CEntityTable::ReadChanges(in);
  if (m_isKey && !update.IsRestart) {
    THROW_ARGOSEXCEPTION("the list of entities of tick " << m_frame.Tick << " is not complete");
  }
  const CEntityTable::SChange change = m_table.Apply(update);
  std::vector<UInt32>& words = m_frame.Words;
  if (change.IsRestart) {
    m_poses.Restart(0);
    words.clear();
  } else if (!change.RemovedPoses.empty() || !change.RemovedWords.empty()) {
    ARGOS_ASSERT(change.RemovedWords.size() == words.size(), "flags of another number of words");
    m_poses.Remove(change.RemovedPoses);
    size_t kept = 0;
    for (size_t i = 0; i < words.size(); ++i) {
      if (!change.RemovedWords[i]) {
        words[kept++] = words[i];
      }
    }
    words.resize(kept);
  }
  m_poses.Append(change.NumAddedPoses);
  words.resize(words.size() + change.NumAddedWords, 0);
  m_rays.Restart();
  m_columns.Restart();
  m_frame.Types = m_table.GetTypes();
  m_frame.Entities = m_table.GetEntities();
  ++m_frame.EntitiesVersion;
}

void CFrameDecoder::DecodeWords(CByteReader& in) {
  CSparseReader sparse(in);
  for (UInt32& word : m_frame.Words) {
    word ^= static_cast<UInt32>(sparse.Read());
  }
}

// columns of users' choice

CPredictedColumn& CNamedColumns::Get(size_t number, size_t size) {
  if (m_columns.size() <= number) {
    m_columns.resize(number + 1);
  }
  if (m_columns[number].GetSize() != size) {
    m_columns[number].Restart(size);
  }
  return m_columns[number];
}

void CNamedColumns::Encode(const std::vector<SRecordedColumn>& columns, CByteWriter& out) {
  out.WriteNumber(columns.size());
  for (size_t i = 0; i < columns.size(); ++i) {
    const SRecordedColumn& column = columns[i];
    out.WriteText(column.Field);
    out.WriteText(column.Name);
    out.WriteText(column.Unit);
    out.WriteByte(column.IsText ? 1 : 0);
    if (column.IsText) {
      WriteTexts(column.Texts, out);
    }
    m_values.clear();
    for (const Real value : column.Values) {
      m_values.push_back(ToRecorded(value, EPrecision::Exact));
    }
    Get(i, m_values.size()).Encode(m_values, out);
  }
}

void CNamedColumns::Decode(std::vector<SRecordedColumn>& columns, size_t numEntities,
                           CByteReader& in) {
  const size_t count = in.ReadNumberUpTo(kMaxValues / (numEntities + 1), "number of columns");
  for (size_t i = 0; i < count; ++i) {
    SRecordedColumn& column = columns.emplace_back();
    column.Field = in.ReadText();
    column.Name = in.ReadText();
    column.Unit = in.ReadText();
    column.IsText = in.ReadByte() != 0;
    if (column.IsText) {
      ReadTexts(column.Texts, in);
    }
    m_values.resize(numEntities);
    Get(i, numEntities).Decode(m_values, in);
    for (const SInt64 value : m_values) {
      column.Values.push_back(FromRecorded(value, EPrecision::Exact));
    }
  }
}

// floor

void WriteFloorChange(const SRecordedFloor& before, const SRecordedFloor& now, CByteWriter& out) {
  ARGOS_ASSERT(before.Width == now.Width && before.Height == now.Height, "another size of floor");
  ARGOS_ASSERT(now.Width == before.Width && now.Height == before.Height &&
                   now.Pixels.size() == before.Pixels.size(),
               "only floors of equal size have changes");
  const size_t rowBytes = now.Width * kBytesPerPixel;
  const auto isSame = [&](size_t row) {
    return now.Pixels.compare(row * rowBytes, rowBytes, before.Pixels, row * rowBytes, rowBytes) ==
           0;
  };
  size_t first = 0;
  size_t end = now.Height;
  while (first < end && isSame(first)) {
    ++first;
  }
  while (end > first && isSame(end - 1)) {
    --end;
  }
  out.WriteNumber(first);
  out.WriteNumber(end - first);
  for (size_t i = first * rowBytes; i < end * rowBytes; ++i) {
    out.WriteByte(static_cast<UInt8>(now.Pixels[i] ^ before.Pixels[i]));
  }
}

std::shared_ptr<const SRecordedFloor> ReadFloorChange(const SRecordedFloor& before,
                                                      CByteReader& in) {
  const UInt64 first = in.ReadNumberUpTo(before.Height, "first row of a floor");
  const UInt64 rows = in.ReadNumberUpTo(before.Height - first, "number of rows of a floor");
  const size_t rowBytes = before.Width * kBytesPerPixel;
  const std::string_view changes = in.ReadBytes(rows * rowBytes);
  auto floor = std::make_shared<SRecordedFloor>(before);
  for (size_t i = 0; i < changes.size(); ++i) {
    char& pixel = floor->Pixels[first * rowBytes + i];
    pixel = static_cast<char>(pixel ^ changes[i]);
  }
  return floor;
}

void WriteFloor(const SRecordedFloor& floor, CByteWriter& out) {
  out.WriteNumber(floor.Width);
  out.WriteNumber(floor.Height);
  out.WriteText(floor.Pixels);
}

std::shared_ptr<const SRecordedFloor> ReadFloor(CByteReader& in) {
  auto floor = std::make_shared<SRecordedFloor>();
  floor->Width = static_cast<UInt32>(in.ReadNumberUpTo(kMaxPixels, "width of the floor"));
  floor->Height = static_cast<UInt32>(in.ReadNumberUpTo(kMaxPixels, "height of the floor"));
  floor->Pixels = in.ReadText();
  if (floor->Pixels.size() != size_t(floor->Width) * floor->Height * kBytesPerPixel) {
    THROW_ARGOSEXCEPTION("the size of its floor is wrong");
  }
  return floor;
}

}  // namespace argos
