#include <argos3/core/simulator/placement/walls.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/testing/support/temporary_folder.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace walls_test {

using namespace argos;
using Catch::Contains;
using Catch::WithinAbs;

namespace {

constexpr Real kRounding = 1e-12;  // m

Real ComputeArea(const std::vector<SWallPiece>& pieces) {
  Real area = 0.0;
  for (const SWallPiece& piece : pieces) {
    area += piece.Size.GetX() * piece.Size.GetY();
  }
  return area;
}

bool Covers(const SWallPiece& piece, const CVector2& point) {
  CVector2 local = point - piece.Center;
  local.Rotate(-piece.Direction);
  return std::abs(local.GetX()) < 0.5 * piece.Size.GetX() + kRounding &&
         std::abs(local.GetY()) < 0.5 * piece.Size.GetY() + kRounding;
}

size_t CountCovering(const std::vector<SWallPiece>& pieces, const CVector2& point) {
  size_t count = 0;
  for (const SWallPiece& piece : pieces) {
    count += Covers(piece, point) ? 1 : 0;
  }
  return count;
}

/* '#' is black; the first row of the text is the upper one. */
SImage MakeImage(const std::vector<std::string>& rows) {
  SImage image;
  image.Height = rows.size();
  image.Width = rows[0].size();
  for (size_t row = rows.size(); row-- > 0;) {
    for (const char c : rows[row]) {
      image.Pixels.insert(image.Pixels.end(), 3, c == '#' ? 0 : c == '+' ? 120 : 255);
    }
  }
  return image;
}

}  // namespace

TEST_CASE("walls: those around the arena cover a frame within its limits, once", "[core][walls]") {
  const auto pieces = MakeWallsAround({CVector3(-1, -2, 0), CVector3(5, 4, 1)}, 0.25);
  CHECK(pieces.size() == 4);
  CHECK_THAT(ComputeArea(pieces), WithinAbs(6.0 * 6.0 - 5.5 * 5.5, kRounding));
  for (const CVector2& corner : {CVector2(-0.99, -1.99), CVector2(4.99, -1.99),
                                 CVector2(4.99, 3.99), CVector2(-0.99, 3.99)}) {
    CHECK(CountCovering(pieces, corner) == 1);
  }
  CHECK(CountCovering(pieces, CVector2(-0.74, -1.74)) == 0);
  CHECK(CountCovering(pieces, CVector2(5.01, 0.0)) == 0);
  CHECK_THROWS_WITH(MakeWallsAround({CVector3(0, 0, 0), CVector3(5, 0.5, 1)}, 0.25),
                    Contains("do not fit into the arena"));
}

TEST_CASE("walls: outer edges of a corner meet, whatever its angle", "[core][walls]") {
  // regular polygons: the outer corner is at (R + t / (2 cos(pi / n)))
  const int n = GENERATE(3, 4, 5, 8, 40);
  const bool isRepeated = GENERATE(false, true);
  CAPTURE(n, isRepeated);
  constexpr Real kRadius = 2.0;
  constexpr Real kThickness = 0.1;
  std::vector<CVector2> points;
  for (int i = 0; i < n + (isRepeated ? 1 : 0); ++i) {
    const Real angle = 2.0 * M_PI * (i % n) / n;
    points.emplace_back(kRadius * std::cos(angle), kRadius * std::sin(angle));
  }
  const auto pieces = MakeWallsAlong(points, true, kThickness);
  REQUIRE(pieces.size() == static_cast<size_t>(n));
  const Real outer = kRadius + 0.5 * kThickness / std::cos(M_PI / n);
  for (int i = 0; i < n; ++i) {
    const Real angle = 2.0 * M_PI * i / n;
    const CVector2 direction(std::cos(angle), std::sin(angle));
    CHECK(CountCovering(pieces, direction * (outer - 1e-6)) == 2);
    CHECK(CountCovering(pieces, direction * (outer + 1e-6)) == 0);
  }
}

TEST_CASE("walls: open lines end where they end, and sharp corners are cut", "[core][walls]") {
  const auto pieces = MakeWallsAlong({{0, 0}, {2, 0}, {0, 0.01}}, false, 0.2);
  REQUIRE(pieces.size() == 2);
  CHECK_THAT(pieces[0].Center.GetX() - 0.5 * pieces[0].Size.GetX(), WithinAbs(0.0, kRounding));
  // by the thickness, not by 0.1 / tan(0.0025)
  CHECK_THAT(pieces[0].Size.GetX(), WithinAbs(2.2, kRounding));
  CHECK_THAT(pieces[1].Size.GetY(), WithinAbs(0.2, kRounding));
  // two points are one wall, closed or not
  CHECK(MakeWallsAlong({{0, 0}, {2, 0}}, true, 0.2).size() == 1);
}

TEST_CASE("walls: those of an image cover its dark pixels, once, in few pieces", "[core][walls]") {
  const std::vector<std::string> rows = {"########",  //
                                         "#.....+#",  //
                                         "#.###.+#",  //
                                         "#.#.#..#",  //
                                         "####..##"};
  const SImage image = MakeImage(rows);
  constexpr Real kSize = 0.5;  // m
  const CVector2 center(10.0, -3.0);
  const Real threshold = GENERATE(0.4, 0.5);
  CAPTURE(threshold);
  const auto pieces = MakeWallsOfImage(image, center, kSize, threshold);
  size_t dark = 0;
  for (size_t row = 0; row < rows.size(); ++row) {
    for (size_t column = 0; column < rows[row].size(); ++column) {
      const bool isWall =
          rows[row][column] == '#' || (rows[row][column] == '+' && threshold == 0.5);
      dark += isWall ? 1 : 0;
      const CVector2 pixel(center.GetX() + (static_cast<Real>(column) + 0.5 - 4.0) * kSize,
                           center.GetY() + (2.5 - static_cast<Real>(row) - 0.5) * kSize);
      CAPTURE(row, column);
      CHECK(CountCovering(pieces, pixel) == (isWall ? 1 : 0));
    }
  }
  CHECK_THAT(ComputeArea(pieces), WithinAbs(static_cast<Real>(dark) * kSize * kSize, kRounding));
  CHECK(pieces.size() < dark / 2);
  CHECK(MakeWallsOfImage(MakeImage({"...", "..."}), center, kSize, threshold).empty());
}

TEST_CASE("walls: lines of a drawing are read, with y upwards", "[core][walls][svg]") {
  const CTemporaryFolder folder;
  const std::string path = folder.Write(
      "plan.svg",
      "<?xml version='1.0'?><svg xmlns='http://www.w3.org/2000/svg'><title>plan</title><g>"
      "<line x1='0' y1='1' x2='2' y2='1'/><rect x='1' y='2' width='3' height='4'/>"
      "<polygon points='0,0 1,0 1 1'/></g>"
      "<path d='M0,0h2 v3L0 3zm5-5 1,0 0,1'/></svg>");
  const auto lines = ReadWallLines(path, 0.5);
  REQUIRE(lines.size() == 5);
  CHECK(lines[0].Points == std::vector<CVector2>{{0, -0.5}, {1, -0.5}});
  CHECK(!lines[0].IsClosed);
  CHECK(lines[1].Points == std::vector<CVector2>{{0.5, -1}, {2, -1}, {2, -3}, {0.5, -3}});
  CHECK(lines[1].IsClosed);
  CHECK(lines[2].Points == std::vector<CVector2>{{0, 0}, {0.5, 0}, {0.5, -0.5}});
  CHECK(lines[3].Points == std::vector<CVector2>{{0, 0}, {1, 0}, {1, -1.5}, {0, -1.5}});
  CHECK(lines[3].IsClosed);
  // relative to the start of the closed line
  CHECK(lines[4].Points == std::vector<CVector2>{{2.5, 2.5}, {3, 2.5}, {3, 2}});
  CHECK(!lines[4].IsClosed);
}

TEST_CASE("walls: points of a drawing that do not differ are no line", "[core][walls][svg]") {
  const CTemporaryFolder folder;
  const std::string path =
      folder.Write("plan.svg",
                   "<svg><line x1='1' y1='2' x2='1' y2='2'/>"
                   "<polyline points='0,0 0,0 1,0 1,0 1,0'/><path d='M3,3 L3,3'/></svg>");
  const auto lines = ReadWallLines(path, 1.0);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].Points == std::vector<CVector2>{{0, 0}, {1, 0}});
}

TEST_CASE("walls: what is no straight line is refused with its place", "[core][walls][svg]") {
  const CTemporaryFolder folder;
  const auto [text, message] = GENERATE(table<std::string, std::string>(
      {{"<svg>\n<path d='M0,0 C 1 2 3 4 5 6'/></svg>",
        "plan.svg:2: <path>: attribute \"d\": the command C is not read"},
       {"<svg><path d='M0,0 L1,1 z 3,4'/></svg>", "the command ? is not read"},
       {"<svg><path d='M0,0 L1'/></svg>", "a number is missing at the end"},
       {"<svg><polyline points='0,0 a,1'/></svg>", "\"a,1\" is no number"},
       {"<svg><line x1='inf'/></svg>", "is no number"},
       {"<svg><circle r='1'/></svg>", "only straight lines can be walls"},
       {"<svg><ellipse rx='1' ry='2'/></svg>", "only straight lines can be walls"},
       {"<svg><g transform='scale(2)'/></svg>", "transformations are not read"},
       {"<html/>", "is no SVG: its root element is <html>"},
       {"<svg>", "plan.svg"}}));
  CAPTURE(text);
  CHECK_THROWS_WITH(ReadWallLines(folder.Write("plan.svg", text), 1.0), Contains(message));
}

}  // namespace walls_test
