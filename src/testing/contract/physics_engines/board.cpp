#include <argos3/testing/contract/physics_engines/board.h>

#include <catch2/catch.hpp>

#include <algorithm>

namespace argos {

namespace {

std::string IdAt(int column, int row) {
  return "e" + std::to_string(column) + std::to_string(row);
}

// attribute of the face between a square and its neighbour
std::string FaceTo(const SBoard& board, int column, int row, int toColumn, int toRow) {
  const bool isInside =
      std::min(toColumn, toRow) >= 0 && std::max(toColumn, toRow) < SBoard::kPerSide;
  if (isInside) {
    return "gate='" + IdAt(toColumn, toRow) + "'";
  }
  return board.At(column, row).HasWalls ? "wall='true'" : "";
}

std::string EnginesOf(const SBoard& board, Real side) {
  // the outer faces coincide with the arena's walls
  const auto edge = [side](int i) {
    return (side - 0.1) * (static_cast<Real>(i) / SBoard::kPerSide - 0.5);
  };
  std::string xml;
  for (int row = 0; row < SBoard::kPerSide; ++row) {
    for (int column = 0; column < SBoard::kPerSide; ++column) {
      const auto face = [&](int right, int up) {
        return FaceTo(board, column, row, column + right, row + up);
      };
      xml += RegionXml(board.At(column, row), IdAt(column, row),
                       {{edge(column), edge(row), face(0, -1)},
                        {edge(column + 1), edge(row), face(1, 0)},
                        {edge(column + 1), edge(row + 1), face(0, 1)},
                        {edge(column), edge(row + 1), face(-1, 0)}});
    }
  }
  return xml;
}

}  // namespace

std::vector<SBoard> ListBoards() {
  std::vector<SBoard> boards;
  for (const SSharingEngine& engine : kSharingEngines) {
    boards.push_back({engine.Tag, {engine}});
  }
  boards.push_back({"all types", kSharingEngines});
  return boards;
}

std::string SBoard::ToXml(const testing::SRoomsWorld& rooms) const {
  std::string xml = rooms.ToXML();
  const std::string open = "<physics_engines>";
  const size_t from = xml.find(open) + open.size();
  const size_t to = xml.find("</physics_engines>");
  REQUIRE(to != std::string::npos);
  return xml.replace(from, to - from, EnginesOf(*this, rooms.Side));
}

}  // namespace argos
