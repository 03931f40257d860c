#include <argos3/core/simulator/placement/ground_order.h>

#include <algorithm>

namespace argos {

namespace {

// the bits of a number at the even places of the result
UInt64 SpreadBits(UInt32 number) {
  UInt64 bits = number;
  bits = (bits | bits << 16U) & 0x0000FFFF0000FFFFULL;
  bits = (bits | bits << 8U) & 0x00FF00FF00FF00FFULL;
  bits = (bits | bits << 4U) & 0x0F0F0F0F0F0F0F0FULL;
  bits = (bits | bits << 2U) & 0x3333333333333333ULL;
  return (bits | bits << 1U) & 0x5555555555555555ULL;
}

}  // namespace

std::vector<UInt32> OrderOnGround(const std::vector<CVector3>& positions, Real tile) {
  if (positions.empty()) {
    return {};
  }
  CVector3 min = positions.front();
  CVector3 max = min;
  for (const CVector3& position : positions) {
    min.Set(std::min(min.GetX(), position.GetX()), std::min(min.GetY(), position.GetY()), 0.0);
    max.Set(std::max(max.GetX(), position.GetX()), std::max(max.GetY(), position.GetY()), 0.0);
  }
  constexpr Real kMaxTiles = 1e9;  // along one axis: less than 2^32
  const Real extent = std::max(max.GetX() - min.GetX(), max.GetY() - min.GetY());
  const Real side = std::max(tile, extent / kMaxTiles);
  const auto tileOf = [side](Real distance) {
    return side > 0.0 ? static_cast<UInt32>(distance / side) : 0;
  };

  struct SPlace {
    UInt64 Key;
    UInt32 Number;
  };
  std::vector<SPlace> places;
  places.reserve(positions.size());
  for (const CVector3& position : positions) {
    const UInt64 key = SpreadBits(tileOf(position.GetX() - min.GetX())) |
                       SpreadBits(tileOf(position.GetY() - min.GetY())) << 1U;
    places.push_back({key, static_cast<UInt32>(places.size())});
  }
  std::sort(places.begin(), places.end(), [](const SPlace& a, const SPlace& b) {
    return a.Key != b.Key ? a.Key < b.Key : a.Number < b.Number;
  });
  std::vector<UInt32> order;
  order.reserve(places.size());
  for (const SPlace& place : places) {
    order.push_back(place.Number);
  }
  return order;
}

}  // namespace argos
