#include <argos3/campaign/plot/table_file.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/input_file.h>
#include <argos3/core/utility/text/lists.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <fmt/format.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace argos {

namespace {

constexpr const char* kMark = "# argos3 ";
constexpr const char* kArena = "# arena: ";
constexpr const char* kPolygon = "# polygon: ";
constexpr const char* kCircle = "# circle: ";
constexpr const char* kUnits = "# units: ";

// the rest of a line with that beginning
std::optional<std::string> FindRest(const std::string& line, const char* beginning) {
  return line.rfind(beginning, 0) == 0 ? std::optional(line.substr(std::strlen(beginning)))
                                       : std::nullopt;
}

bool IsComplete(const std::string& row) {
  return std::count(row.begin(), row.end(), '"') % 2 == 0;
}

}  // namespace

/** Reads compressed files and others alike. */
struct CTableFile::SStream {
  explicit SStream(const std::string& path) : File(gzopen(path.c_str(), "rb")) {}
  ~SStream() {
    if (File != nullptr) {
      gzclose(File);
    }
  }
  SStream(const SStream&) = delete;
  SStream& operator=(const SStream&) = delete;

  gzFile File;
};

CTableFile::CTableFile(const std::string& path) : m_path(path) {
  const std::string problem = FindInputProblem(path);
  if (!problem.empty()) {
    THROW_ARGOSEXCEPTION("there is no file \"" << path << "\" that can be read: " << problem);
  }
  m_stream = std::make_unique<SStream>(path);
  if (m_stream->File == nullptr) {
    THROW_ARGOSEXCEPTION("the file \"" << path << "\" cannot be opened");
  }
  std::string line;
  if (!ReadLine(line) || !FindRest(line, kMark)) {
    Throw("it is no table of argos3: it must begin with \"# argos3\"");
  }
  while (ReadLine(line)) {
    if (line.rfind('#', 0) == 0) {
      ReadHeaderLine(line);
      continue;
    }
    SplitFields(line);
    m_names = m_fields;
    for (size_t i = 0; i < m_names.size(); ++i) {
      m_columns.emplace(m_names[i], i);
    }
    break;
  }
  if (!HasColumn("run") || !HasColumn("time")) {
    Throw("it is no table of argos3: the line \"run,tick,time,...\" is missing");
  }
}

CTableFile::~CTableFile() = default;

void CTableFile::Throw(const std::string& problem) const {
  THROW_ARGOSEXCEPTION(m_path << ':' << m_line << ": " << problem);
}

size_t CTableFile::FindColumn(const std::string& name) const {
  const auto column = m_columns.find(name);
  if (column == m_columns.end()) {
    const std::string known = JoinItems(m_names);
    Throw("there is no column \"" + name + "\"; columns: " + known);
  }
  return column->second;
}

std::string CTableFile::GetUnit(const std::string& column) const {
  const auto unit = m_units.find(column);
  return unit == m_units.end() ? "" : unit->second;
}

// a line that was not written to its end, as in the table of a run that goes on, is left out
bool CTableFile::ReadLine(std::string& line) {
  line.clear();
  std::array<char, 4096> buffer;
  while (gzgets(m_stream->File, buffer.data(), static_cast<int>(buffer.size())) != nullptr) {
    line += buffer.data();
    if (!line.empty() && line.back() == '\n') {
      ++m_line;
      line.pop_back();
      if (!line.empty() && line.back() == '\r') {
        line.pop_back();
      }
      return true;
    }
  }
  int error = Z_OK;
  const char* const text = gzerror(m_stream->File, &error);
  if (error != Z_OK && error != Z_BUF_ERROR && error != Z_STREAM_END) {
    Throw(std::string("the file is damaged: ") + text);
  }
  return false;
}

void CTableFile::ReadHeaderLine(const std::string& line) {
  if (const auto arena = FindRest(line, kArena)) {
    const TNumberGroups corners = ReadGroups(*arena, 2);
    if (corners.size() != 2 || !(corners[0][0] <= corners[1][0]) ||
        !(corners[0][1] <= corners[1][1])) {
      Throw("an arena is two corners, \"-2,-2 2,2\"; found \"" + *arena + '"');
    }
    m_arena = SPlotArea{corners[0][0], corners[0][1], corners[1][0], corners[1][1]};
  } else if (const auto polygon = FindRest(line, kPolygon)) {
    m_polygons.push_back(ReadGroups(*polygon, 2));
    if (m_polygons.back().size() < 3) {
      Throw("a polygon has three corners or more; found \"" + *polygon + '"');
    }
  } else if (const auto circle = FindRest(line, kCircle)) {
    const TNumberGroups groups = ReadGroups(*circle, 3);
    if (groups.size() != 1 || !(groups[0][2] > 0.0)) {
      Throw("a circle is x, y and a radius above 0; found \"" + *circle + '"');
    }
    m_circles.push_back(groups.front());
  } else if (const auto units = FindRest(line, kUnits)) {
    ReadUnits(*units);
  }
}

// "time [s], food [kg]"
void CTableFile::ReadUnits(const std::string& text) {
  for (size_t start = 0; start < text.size();) {
    const size_t open = text.find(" [", start);
    const size_t close = open == std::string::npos ? open : text.find(']', open);
    if (close == std::string::npos) {
      return;
    }
    m_units[text.substr(start, open - start)] = text.substr(open + 2, close - open - 2);
    start = close + std::strlen("], ");
  }
}

TNumberGroups CTableFile::ReadGroups(const std::string& text, size_t numbers) const {
  TNumberGroups groups;
  std::vector<std::string> words;
  Tokenize(text, words, " ");
  for (const std::string& word : words) {
    std::vector<std::string> parts;
    Tokenize(word, parts, ",");
    std::vector<Real>& group = groups.emplace_back();
    for (const std::string& part : parts) {
      Real& number = group.emplace_back(0.0);
      if (ParseNumber(part, number) != ENumberParsing::Ok) {
        Throw("\"" + part + "\" is no number");
      }
    }
    if (group.size() != numbers) {
      Throw(fmt::format("expected {} numbers, found \"{}\"", numbers, word));
    }
  }
  return groups;
}

void CTableFile::SplitFields(const std::string& line) {
  m_fields.assign(1, "");
  bool isQuoted = false;
  for (size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && isQuoted && i + 1 < line.size() && line[i + 1] == '"') {
      m_fields.back() += c;
      ++i;
    } else if (c == '"') {
      isQuoted = !isQuoted;
    } else if (c == ',' && !isQuoted) {
      m_fields.emplace_back();
    } else {
      m_fields.back() += c;
    }
  }
}

bool CTableFile::ReadRow() {
  std::string line;
  do {
    if (!ReadLine(line)) {
      return false;
    }
  } while (line.empty() || line.front() == '#');
  // a quoted text may have line breaks
  for (std::string next; !IsComplete(line) && ReadLine(next);) {
    line += '\n' + next;
  }
  SplitFields(line);
  return true;
}

const std::string& CTableFile::GetText(size_t column) const {
  static const std::string kEmpty;
  return column < m_fields.size() ? m_fields[column] : kEmpty;
}

Real CTableFile::GetNumber(size_t column) const {
  constexpr Real kNone = std::numeric_limits<Real>::quiet_NaN();
  const std::string& text = GetText(column);
  if (text.empty()) {
    return kNone;
  }
  Real number = 0.0;
  if (ParseNumber(text, number) == ENumberParsing::Ok) {
    return number;
  }
  const std::string lower = StringToLowerCase(text);
  if (lower.find("nan") == std::string::npos && lower.find("inf") == std::string::npos) {
    Throw("column \"" + m_names.at(column) + "\": \"" + text + "\" is no number");
  }
  return kNone;
}

}  // namespace argos
