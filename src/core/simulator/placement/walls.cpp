#include <argos3/core/simulator/placement/walls.h>

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/nearby_file.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>
#include <map>
#include <utility>

namespace argos {

namespace {

constexpr size_t kMaxPieces = 100000;

// By how much both walls of a corner must be longer, so that their outer edges meet.
Real ComputeExtension(const CVector2& before, const CVector2& corner, const CVector2& after,
                      Real thickness) {
  const CRadians turn = ((after - corner).Angle() - (corner - before).Angle()).SignedNormalize();
  return std::min(thickness, 0.5 * thickness * Tan(0.5 * Abs(turn)));
}

bool IsWall(const SImage& image, size_t column, size_t row, Real threshold) {
  constexpr Real kWhite = 3.0 * 255.0;  // three channels
  const UInt8* const pixel = &image.Pixels[3 * (row * image.Width + column)];
  return pixel[0] + pixel[1] + pixel[2] < threshold * kWhite;
}

struct SPixels {
  size_t FirstRow;
  size_t Begin;  // columns
  size_t End;
};

SWallPiece MakePiece(const SPixels& pixels, size_t endRow, const SImage& image,
                     const CVector2& center, Real metersPerPixel) {
  const CVector2 first(static_cast<Real>(pixels.Begin), static_cast<Real>(pixels.FirstRow));
  const CVector2 last(static_cast<Real>(pixels.End), static_cast<Real>(endRow));
  const CVector2 middle(static_cast<Real>(image.Width), static_cast<Real>(image.Height));
  return {center + (first + last - middle) * (0.5 * metersPerPixel),
          (last - first) * metersPerPixel, CRadians::ZERO};
}

std::vector<CVector2> ReadPoints(TConfigurationNode& element) {
  std::string text;
  GetNodeAttribute(element, "points", text);
  std::vector<std::string> words;
  Tokenize(text, words, " \t\r\n;");
  std::vector<CVector2> points;
  for (const std::string& word : words) {
    points.push_back(FromString<CVector2>(word));
    if (points.size() > 1 && points.back() == points[points.size() - 2]) {
      THROW_ARGOSEXCEPTION("attribute \"points\": the point " << word << " comes twice in a row");
    }
  }
  if (points.size() < 2) {
    THROW_ARGOSEXCEPTION(
        "attribute \"points\" must have at least two points, as in \"0,0 4,0 4,3\"");
  }
  return points;
}

Real ReadPositive(TConfigurationNode& element, const std::string& name) {
  Real value = 0.0;
  GetNodeAttribute(element, name, value);
  if (!(value > 0.0)) {
    THROW_ARGOSEXCEPTION("attribute \"" << name << "\" must be positive, got " << value);
  }
  return value;
}

void AddPieces(CSpace& space, const std::vector<SWallPiece>& pieces, const std::string& id,
               Real base, Real height) {
  if (pieces.size() > kMaxPieces) {
    THROW_ARGOSEXCEPTION("the walls \"" << id << "\" consist of " << pieces.size()
                                        << " boxes; at most " << kMaxPieces << " are possible");
  }
  size_t number = 0;
  for (const SWallPiece& piece : pieces) {
    TConfigurationNode box("box");
    box.SetAttribute("id", id + "_" + ToString(number++));
    box.SetAttribute("size", CVector3(piece.Size.GetX(), piece.Size.GetY(), height));
    box.SetAttribute("movable", "false");
    TConfigurationNode body("body");
    body.SetAttribute("position", CVector3(piece.Center.GetX(), piece.Center.GetY(), base));
    body.SetAttribute("orientation", CVector3(ToDegrees(piece.Direction).GetValue(), 0.0, 0.0));
    box.InsertEndChild(body);
    space.CreateEntity(box);
  }
}

void Append(std::vector<SWallPiece>& pieces, const std::vector<SWallPiece>& more) {
  pieces.insert(pieces.end(), more.begin(), more.end());
}

std::vector<SWallPiece> ReadDrawing(TConfigurationNode& element) {
  std::string path;
  GetNodeAttribute(element, "svg", path);
  CVector2 corner;
  GetNodeAttributeOrDefault(element, "corner", corner, corner);
  const Real thickness = ReadPositive(element, "thickness");
  std::vector<SWallPiece> pieces;
  const Real metersPerUnit = ReadPositive(element, "meters_per_unit");
  const std::string file = FindNearbyFile(path, element.GetFileName(), "map");
  for (SWallLine& line : ReadWallLines(file, metersPerUnit)) {
    for (CVector2& point : line.Points) {
      point += corner;
    }
    Append(pieces, MakeWallsAlong(line.Points, line.IsClosed, thickness));
  }
  return pieces;
}

std::vector<SWallPiece> ReadImageOf(TConfigurationNode& element) {
  std::string path;
  GetNodeAttribute(element, "image", path);
  CVector2 center;
  GetNodeAttributeOrDefault(element, "center", center, center);
  Real threshold = 0.5;
  GetNodeAttributeOrDefault(element, "threshold", threshold, threshold);
  if (!(threshold > 0.0) || threshold > 1.0) {
    THROW_ARGOSEXCEPTION("attribute \"threshold\" must be above 0 and at most 1, got "
                         << threshold);
  }
  const Real metersPerPixel = ReadPositive(element, "meters_per_pixel");
  return MakeWallsOfImage(ReadImage(FindNearbyFile(path, element.GetFileName(), "map"), "map"),
                          center, metersPerPixel, threshold);
}

std::vector<SWallPiece> MakeWallsOfArena(CSpace& space, Real thickness) {
  if (space.GetContext().Arena.Period.IsOn()) {
    THROW_ARGOSEXCEPTION(
        "these walls stand along all sides of the arena, but its \"periodic\" "
        "joins some: draw the others with <walls points=\"...\">");
  }
  return MakeWallsAround(space.GetArenaLimits(), thickness);
}

std::vector<SWallPiece> ReadPieces(CSpace& space, TConfigurationNode& element) {
  std::vector<std::string> sources;
  for (const char* const source : {"points", "image", "svg"}) {
    if (NodeAttributeExists(element, source)) {
      sources.emplace_back(source);
    }
  }
  if (sources.size() > 1) {
    THROW_ARGOSEXCEPTION("attributes \"" << sources[0] << "\" and \"" << sources[1]
                                         << "\" cannot be given together");
  }
  if (sources.empty()) {
    return MakeWallsOfArena(space, ReadPositive(element, "thickness"));
  }
  if (sources[0] == "image") {
    return ReadImageOf(element);
  }
  if (sources[0] == "svg") {
    return ReadDrawing(element);
  }
  bool isClosed = true;
  GetNodeAttributeOrDefault(element, "closed", isClosed, isClosed);
  return MakeWallsAlong(ReadPoints(element), isClosed, ReadPositive(element, "thickness"));
}

}  // namespace

std::vector<SWallPiece> MakeWallsAround(const CRange<CVector3>& limits, Real thickness) {
  const CVector3& min = limits.GetMin();
  const CVector3 size = limits.GetMax() - min;
  if (2.0 * thickness >= std::min(size.GetX(), size.GetY())) {
    THROW_ARGOSEXCEPTION("walls of a thickness of "
                         << thickness << " m do not fit into the arena, whose size is " << size);
  }
  // those along x from side to side, those along y between them
  const CVector2 center(min.GetX() + 0.5 * size.GetX(), min.GetY() + 0.5 * size.GetY());
  const CVector2 offset(0.5 * (size.GetX() - thickness), 0.5 * (size.GetY() - thickness));
  const CVector2 alongX(size.GetX(), thickness);
  const CVector2 alongY(thickness, size.GetY() - 2.0 * thickness);
  const CRadians zero;
  return {{center - CVector2(0.0, offset.GetY()), alongX, zero},
          {center + CVector2(offset.GetX(), 0.0), alongY, zero},
          {center + CVector2(0.0, offset.GetY()), alongX, zero},
          {center - CVector2(offset.GetX(), 0.0), alongY, zero}};
}

std::vector<SWallPiece> MakeWallsAlong(const std::vector<CVector2>& points, bool isClosed,
                                       Real thickness) {
  // two points have no inside
  const bool joins = isClosed && points.size() > 2 && points.front() != points.back();
  const bool returns = points.size() > 3 && points.front() == points.back();
  const size_t corners = returns ? points.size() - 1 : points.size();
  const size_t count = joins || returns ? corners : corners - 1;
  const auto extensionAt = [&](size_t corner) {
    if (!joins && !returns && (corner == 0 || corner == count)) {
      return 0.0;
    }
    return ComputeExtension(points[(corner + corners - 1) % corners], points[corner % corners],
                            points[(corner + 1) % corners], thickness);
  };
  std::vector<SWallPiece> pieces;
  for (size_t i = 0; i < count; ++i) {
    const CVector2& start = points[i];
    const CVector2& end = points[(i + 1) % corners];
    const CVector2 along = (end - start) / (end - start).Length();
    const CVector2 first = start - along * extensionAt(i);
    const CVector2 last = end + along * extensionAt(i + 1);
    pieces.push_back(
        {(first + last) * 0.5, CVector2((last - first).Length(), thickness), along.Angle()});
  }
  return pieces;
}

std::vector<SWallPiece> MakeWallsOfImage(const SImage& image, const CVector2& center,
                                         Real metersPerPixel, Real threshold) {
  std::vector<SWallPiece> pieces;
  // spans of dark pixels that the last row had, too; by their columns
  std::map<std::pair<size_t, size_t>, size_t> open;
  for (size_t row = 0; row <= image.Height; ++row) {
    std::map<std::pair<size_t, size_t>, size_t> spans;
    for (size_t column = 0; row < image.Height && column < image.Width; ++column) {
      const size_t begin = column;
      while (column < image.Width && IsWall(image, column, row, threshold)) {
        ++column;
      }
      if (column > begin) {
        const auto found = open.find({begin, column});
        spans[{begin, column}] = found == open.end() ? row : found->second;
      }
    }
    for (const auto& [columns, firstRow] : open) {
      if (spans.count(columns) == 0) {
        pieces.push_back(MakePiece({firstRow, columns.first, columns.second}, row, image, center,
                                   metersPerPixel));
      }
    }
    open = std::move(spans);
  }
  return pieces;
}

void AddWalls(CSpace& space, TConfigurationNode& element) {
  try {
    std::string id = "walls";
    GetNodeAttributeOrDefault(element, "id", id, id);
    Real base = 0.0;
    GetNodeAttributeOrDefault(element, "base", base, base);
    const Real height = ReadPositive(element, "height");
    AddPieces(space, ReadPieces(space, element), id, base, height);
  } catch (CARGoSException& ex) {
    THROW_ARGOSEXCEPTION_NESTED(element.GetLocation() << ": <walls>", ex);
  }
}

void AddWallsAround(CSpace& space, TConfigurationNode& arena) {
  if (!NodeAttributeExists(arena, "walls")) {
    return;
  }
  CVector2 size;
  GetNodeAttribute(arena, "walls", size);
  if (!(size.GetX() > 0.0) || !(size.GetY() > 0.0)) {
    THROW_ARGOSEXCEPTION(
        arena.GetLocation()
        << ": <arena>: attribute \"walls\" must be thickness and height in m, both "
           "positive, got \""
        << size << '"');
  }
  try {
    AddPieces(space, MakeWallsOfArena(space, size.GetX()), "walls", 0.0, size.GetY());
  } catch (CARGoSException& ex) {
    THROW_ARGOSEXCEPTION_NESTED(arena.GetLocation() << ": <arena walls=...>", ex);
  }
}

}  // namespace argos
