#include <argos3/core/simulator/placement/walls.h>

#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

namespace argos {

namespace {

/* The numbers and letters of an attribute. */
class CSVGText {
 public:
  CSVGText(std::string text, std::string context)
      : m_text(std::move(text)), m_context(std::move(context)) {}

  bool IsAtEnd() {
    while (m_place < m_text.size() &&
           (std::isspace(static_cast<unsigned char>(m_text[m_place])) != 0 ||
            m_text[m_place] == ',')) {
      ++m_place;
    }
    return m_place == m_text.size();
  }
  bool IsAtLetter() {
    return !IsAtEnd() && std::isalpha(static_cast<unsigned char>(m_text[m_place])) != 0;
  }
  char TakeLetter() { return m_text[m_place++]; }
  Real TakeNumber() {
    if (IsAtEnd()) {
      Fail("a number is missing at the end");
    }
    constexpr size_t kShown = 10;  // characters
    const char* const start = m_text.data() + m_place;
    Real number = 0.0;
    const auto [end, error] = std::from_chars(start, m_text.data() + m_text.size(), number);
    if (error != std::errc() || !std::isfinite(number)) {
      Fail(fmt::format("\"{}\" is no number", m_text.substr(m_place, kShown)));
    }
    m_place += static_cast<size_t>(end - start);
    return number;
  }
  CVector2 TakePoint() {
    const Real x = TakeNumber();
    return {x, TakeNumber()};
  }
  [[noreturn]] void Fail(const std::string& reason) const {
    THROW_ARGOSEXCEPTION(m_context << ": " << reason);
  }

 private:
  std::string m_text;
  std::string m_context;
  size_t m_place = 0;
};

std::string GetText(TConfigurationNode& node, const std::string& name,
                    const std::string& otherwise) {
  std::string text = otherwise;
  GetNodeAttributeOrDefault(node, name, text, text);
  return text;
}

/* Reads the lines of a drawing, in its own units. */
class CSVGReader {
 public:
  explicit CSVGReader(std::vector<SWallLine>& lines) : m_lines(lines) {}

  void Read(TConfigurationNode& node) {
    const std::string tag = node.Value();
    const std::string context = fmt::format("{}: <{}>", node.GetLocation(), tag);
    if (!GetText(node, "transform", "").empty()) {
      THROW_ARGOSEXCEPTION(context
                           << ": transformations are not read; apply them in the drawing program");
    }
    const auto number = [&](const char* name) {
      return CSVGText(GetText(node, name, "0"), fmt::format("{}: attribute \"{}\"", context, name))
          .TakeNumber();
    };
    if (tag == "line") {
      Add({{number("x1"), number("y1")}, {number("x2"), number("y2")}}, false);
    } else if (tag == "rect") {
      const CVector2 corner(number("x"), number("y"));
      const CVector2 x(number("width"), 0.0);
      const CVector2 y(0.0, number("height"));
      Add({corner, corner + x, corner + x + y, corner + y}, true);
    } else if (tag == "polyline" || tag == "polygon") {
      ReadPoints(CSVGText(GetText(node, "points", ""), context + ": attribute \"points\""),
                 tag == "polygon");
    } else if (tag == "path") {
      ReadPath(CSVGText(GetText(node, "d", ""), context + ": attribute \"d\""));
    } else if (tag == "circle" || tag == "ellipse") {
      THROW_ARGOSEXCEPTION(context << ": only straight lines can be walls");
    }
    if (tag == "svg" || tag == "g") {
      TConfigurationNodeIterator child;
      for (child = child.begin(&node); child != child.end(); ++child) {
        Read(*child);
      }
    }
  }

 private:
  void Add(const std::vector<CVector2>& points, bool isClosed) {
    // points that do not differ are no line
    std::vector<CVector2> distinct;
    for (const CVector2& point : points) {
      if (distinct.empty() || distinct.back() != point) {
        distinct.push_back(point);
      }
    }
    if (distinct.size() > 1) {
      m_lines.push_back({std::move(distinct), isClosed});
    }
  }

  void ReadPoints(CSVGText text, bool isClosed) {
    std::vector<CVector2> points;
    while (!text.IsAtEnd()) {
      points.push_back(text.TakePoint());
    }
    Add(points, isClosed);
  }

  void ReadPath(CSVGText text) {
    std::vector<CVector2> points;
    CVector2 place;
    char command = 'M';
    while (!text.IsAtEnd()) {
      const bool isNew = text.IsAtLetter();
      command = isNew ? text.TakeLetter() : command;
      const bool isRelative = std::islower(static_cast<unsigned char>(command)) != 0;
      const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
      if (kind == 'Z') {
        const CVector2 start = points.empty() ? place : points.front();
        Add(std::exchange(points, {}), true);
        place = start;
        points = {place};
        command = '?';
        continue;
      }
      const CVector2 origin = isRelative ? place : CVector2();
      if (kind == 'M' || kind == 'L') {
        place = origin + text.TakePoint();
      } else if (kind == 'H') {
        place.SetX(origin.GetX() + text.TakeNumber());
      } else if (kind == 'V') {
        place.SetY(origin.GetY() + text.TakeNumber());
      } else {
        text.Fail(fmt::format(
            "the command {} is not read: only M, L, H, V and Z, straight lines, can be walls",
            command));
      }
      if (kind == 'M') {
        Add(std::exchange(points, {}), false);
        // further points of the command are lines
        command = isRelative ? 'l' : 'L';
      }
      points.push_back(place);
    }
    Add(points, false);
  }

  std::vector<SWallLine>& m_lines;
};

}  // namespace

std::vector<SWallLine> ReadWallLines(const std::string& path, Real metersPerUnit) {
  CConfigurationDocument document;
  document.LoadFile(path);
  if (document.GetRoot().Value() != "svg") {
    THROW_ARGOSEXCEPTION("the map \"" << path << "\" is no SVG: its root element is <"
                                      << document.GetRoot().Value() << ">");
  }
  std::vector<SWallLine> lines;
  CSVGReader(lines).Read(document.GetRoot());
  for (SWallLine& line : lines) {
    for (CVector2& point : line.Points) {
      point.Set(point.GetX() * metersPerUnit, -point.GetY() * metersPerUnit);
    }
  }
  return lines;
}

}  // namespace argos
