// Tables as text: comma-separated values, also compressed.

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/input_file.h>
#include <argos3/core/utility/files/output_file.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/plugins/simulator/outputs/tables/table_format.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>
#include <vector>

namespace argos {

namespace {

// begins the line before that with the names of the columns
constexpr std::string_view kUnits = "# units: ";

constexpr std::size_t kMaxNumberLength = 32;  // length of the text of a number, characters

/**
 * Writes a number as decimal text; nothing for NaN.
 * @param to      has room for kMaxNumberLength characters.
 * @param digits  significant ones, from 1 to 17, of numbers that are not whole; 0: the fewest that
 *   read back to the same number.
 * @return the end of the text.
 */
char* WriteNumber(char* to, double number, int digits) {
  if (std::isnan(number)) {
    return to;
  }
  char* const end = to + kMaxNumberLength;
  // whole numbers have all their digits: they may be colors, or numbers of something
  constexpr double kMax = 1e15;
  const bool isWhole = std::abs(number) < kMax && number == std::trunc(number);
  if (isWhole && !(number == 0.0 && std::signbit(number))) {
    return std::to_chars(to, end, static_cast<std::int64_t>(number)).ptr;
  }
  if (digits == 0) {
    return std::to_chars(to, end, number).ptr;
  }
  return std::to_chars(to, end, number, std::chars_format::general, digits).ptr;
}

/* A text that a program reads as one value. */
std::string Quote(std::string_view text) {
  if (text.find_first_of(",\"\n\r#") == std::string_view::npos) {
    return std::string(text);
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + '"';
}

/* A text that grows by pieces whose greatest length is known before. */
class CGrowingText {
 public:
  char* Reserve(std::size_t length) {
    if (m_text.size() < m_length + length) {
      m_text.resize(2 * (m_length + length));
    }
    return m_text.data() + m_length;
  }
  void SetEnd(const char* end) { m_length = static_cast<std::size_t>(end - m_text.data()); }
  void Append(std::string_view text) {
    text.copy(Reserve(text.size()), text.size());
    m_length += text.size();
  }
  void Clear() { m_length = 0; }
  std::string_view Get() const { return {m_text.data(), m_length}; }

 private:
  std::vector<char> m_text;
  std::size_t m_length = 0;
};

class CCSVFormat : public CTableFormat {
 public:
  void Open(const std::string& path, const STableSchema& schema) override {
    m_path = path;
    m_schema = schema;
    m_file.Open(path);
    m_text.Clear();
    m_text.Append("# argos3 " + schema.Version + " table\n");
    for (const auto& [key, value] : schema.Header) {
      std::string line = "# " + key + ": " + value;
      for (char& c : line) {
        c = c == '\n' || c == '\r' ? ' ' : c;
      }
      m_text.Append(line + '\n');
    }
    m_text.Append(MakeColumnLines());
    WriteText(m_text.Get());
  }

  void AddColumns(const std::vector<SColumn>& columns) override {
    ARGOS_ASSERT(!m_schema.HasRobots, "lines of rows with texts may have several lines");
    const std::size_t numOld = m_schema.Columns.size();
    m_schema.AddColumns(columns);
    if (!m_file.CanReplace()) {
      // written rows cannot be changed: the numbers of the new columns are left out
      m_schema.Columns.resize(numOld);
      LOGERR << "[WARNING] \"" << m_path << "\" is no regular file, so the metric \""
             << columns.front().Name
             << "\", which was first recorded when the table had begun, is left out" << std::endl;
      return;
    }
    std::string old;
    std::string problem;
    if (!ReadInputFile(m_file.GetTarget(), old, problem)) {
      THROW_ARGOSEXCEPTION("cannot read the file \"" << m_path << "\": " << problem);
    }
    m_text.Clear();
    m_text.Append(WidenLines(Unpack(old), columns.size()));
    m_file.Replace(Pack(m_text.Get()));
  }

  void Write(const SRowBlock& block) override {
    for (const std::string& id : block.NewRobots) {
      m_robots.push_back(Quote(id) + ',');
    }
    m_text.Clear();
    std::size_t row = 0;
    for (const SRowBlock::STick& tick : block.Ticks) {
      if (tick.Run != m_run) {
        m_run = tick.Run;
        m_text.Append("# run " + std::to_string(tick.Run) + ": seed " + std::to_string(tick.Seed) +
                      '\n');
      }
      WriteRows(block, tick, row);
      row += tick.NumRows;
    }
    WriteText(m_text.Get());
  }

  void Close() override { m_file.Close(); }

 protected:
  /** What is written instead of a piece of text. */
  virtual std::string_view Pack(std::string_view text) { return text; }
  /** @return the text of a whole file. */
  virtual std::string Unpack(const std::string& bytes) { return bytes; }

 private:
  void WriteText(std::string_view text) { m_file.WriteRecord(Pack(text)); }

  std::string MakeColumnLines() const {
    std::string units = std::string(kUnits) + "time [s]";
    std::string names = m_schema.HasRobots ? "run,tick,time,robot" : "run,tick,time";
    for (const SColumn& column : m_schema.Columns) {
      names += ',' + column.Name;
      if (!column.Unit.empty()) {
        units += ", " + column.Name + " [" + column.Unit + ']';
      }
    }
    return units + '\n' + names + '\n';
  }

  // @return the lines with the present columns, the last ones of which are new and empty
  std::string WidenLines(std::string_view text, std::size_t numNew) const {
    std::string wider;
    wider.reserve(text.size() + text.size() / 8);
    bool isNames = false;  // the line with the columns' names, after that of their units
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size() - 1);
      const std::string_view line = text.substr(0, end);
      text.remove_prefix(end + 1);
      if (isNames) {
        isNames = false;
      } else if (line.substr(0, kUnits.size()) == kUnits) {
        isNames = true;
        wider += MakeColumnLines();
      } else {
        wider += line;
        wider.append(line.substr(0, 1) == "#" ? 0 : numNew, ',');
        wider += '\n';
      }
    }
    return wider;
  }

  void WriteRows(const SRowBlock& block, const SRowBlock::STick& tick, std::size_t first) {
    char start[4 * kMaxNumberLength];
    char* end = WriteNumber(start, tick.Run, 0);
    *end++ = ',';
    end = WriteNumber(end, tick.Tick, 0);
    *end++ = ',';
    end = WriteNumber(end, tick.Time, 0);
    *end++ = ',';
    const std::string_view prefix(start, static_cast<std::size_t>(end - start));
    for (std::size_t row = first; row < first + tick.NumRows; ++row) {
      ARGOS_ASSERT(!m_schema.HasRobots || block.Robots[row] < m_robots.size(),
                   "there is no robot number " << block.Robots[row]);
      const std::string_view robot =
          m_schema.HasRobots ? std::string_view(m_robots[block.Robots[row]]) : std::string_view();
      const std::size_t longest =
          prefix.size() + robot.size() + (m_schema.Columns.size() + 1) * (kMaxNumberLength + 1);
      char* to = m_text.Reserve(longest);
      std::memcpy(to, prefix.data(), prefix.size());
      to += prefix.size();
      to += robot.copy(to, robot.size());
      to = WriteValues(block, row, to);
      // it replaces the comma after the last value
      to[-1] = '\n';
      m_text.SetEnd(to);
    }
  }

  char* WriteValues(const SRowBlock& block, std::size_t row, char* to) {
    const double* const numbers = block.Numbers.data() + row * m_schema.NumNumbers;
    for (std::size_t i = 0; i < m_schema.Columns.size(); ++i) {
      ARGOS_ASSERT(m_schema.Places[i] < m_schema.NumNumbers,
                   "a row has no number " << m_schema.Places[i]);
      const double number = numbers[m_schema.Places[i]];
      if (m_schema.Columns[i].Kind == EColumnKind::Text) {
        m_text.SetEnd(to);
        m_text.Append(Quote(block.Texts.Get(number)));
        to = m_text.Reserve((m_schema.Columns.size() - i + 1) * (kMaxNumberLength + 1));
      } else {
        to = WriteNumber(to, number, m_schema.Digits);
      }
      *to++ = ',';
    }
    return to;
  }

  std::string m_path;
  STableSchema m_schema;
  COutputFile m_file;
  CGrowingText m_text;
  std::vector<std::string> m_robots;  // ids, each with the comma after it
  UInt32 m_run = 0;
};

/* Each piece of text is a member of the gzip file, so that the file can be read at any time. */
class CGzipCSVFormat : public CCSVFormat {
 public:
  CGzipCSVFormat() {
    // 16: with a gzip header
    if (deflateInit2(&m_stream, kLevel, Z_DEFLATED, MAX_WBITS + 16, 9, Z_DEFAULT_STRATEGY) !=
        Z_OK) {
      THROW_ARGOSEXCEPTION("there is no memory for compression");
    }
  }
  ~CGzipCSVFormat() override { deflateEnd(&m_stream); }
  CGzipCSVFormat(const CGzipCSVFormat&) = delete;
  CGzipCSVFormat& operator=(const CGzipCSVFormat&) = delete;

 protected:
  std::string_view Pack(std::string_view text) override {
    deflateReset(&m_stream);
    m_packed.resize(deflateBound(&m_stream, text.size()));
    m_stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
    m_stream.avail_in = static_cast<uInt>(text.size());
    m_stream.next_out = reinterpret_cast<Bytef*>(m_packed.data());
    m_stream.avail_out = static_cast<uInt>(m_packed.size());
    if (deflate(&m_stream, Z_FINISH) != Z_STREAM_END) {
      THROW_ARGOSEXCEPTION("a part of a table cannot be compressed");
    }
    return {m_packed.data(), m_packed.size() - m_stream.avail_out};
  }

  std::string Unpack(const std::string& bytes) override {
    z_stream stream{};
    std::string text;
    std::array<char, 1 << 15> piece{};
    bool isGood = bytes.size() <= std::numeric_limits<uInt>::max() &&
                  inflateInit2(&stream, MAX_WBITS + 16) == Z_OK;
    int result = Z_OK;
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    while (isGood && (stream.avail_in > 0 || result != Z_STREAM_END)) {
      stream.next_out = reinterpret_cast<Bytef*>(piece.data());
      stream.avail_out = static_cast<uInt>(piece.size());
      result = inflate(&stream, Z_NO_FLUSH);
      text.append(piece.data(), piece.size() - stream.avail_out);
      // a member ends, and another one follows
      isGood = result == Z_OK || (result == Z_STREAM_END && inflateReset(&stream) == Z_OK);
    }
    inflateEnd(&stream);
    if (!isGood) {
      THROW_ARGOSEXCEPTION("a compressed table cannot be read again");
    }
    return text;
  }

 private:
  static constexpr int kLevel = 1;  // the fastest: higher levels save a tenth of the size

  z_stream m_stream{};
  std::vector<char> m_packed;
};

}  // namespace

REGISTER_TABLE_FORMAT(CCSVFormat, "csv", "Comma-separated values.")
REGISTER_TABLE_FORMAT(CGzipCSVFormat, "csv.gz", "Comma-separated values, compressed.")

}  // namespace argos
