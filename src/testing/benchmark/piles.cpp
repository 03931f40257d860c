#include <argos3/testing/benchmark/piles.h>

#include <argos3/testing/support/experiment.h>

#include <cmath>
#include <sstream>

namespace argos::testing {

namespace {

constexpr UInt32 kHigh = 10;  // boxes of a tower, layers of balls

std::string MakeExperiment(const std::string& arena, UInt32 threads, const std::string& engine,
                           const std::string& attributes) {
  SExperiment experiment;
  experiment.Threads = threads;
  experiment.Engines = "<" + engine + " id='engine' " + attributes + "/>";
  experiment.ArenaSize = "200,200,20";
  experiment.Arena = arena;
  return experiment.ToXml();
}

void AddBox(std::ostringstream& arena, UInt32 number, Real x, Real y, Real z, Real degrees) {
  arena << "<box id='b" << number << "' size='0.2,0.2,0.1' movable='true' mass='0.5'><body "
        << "position='" << x << "," << y << "," << z << "' orientation='" << degrees
        << ",0,0'/></box>";
}

// places in a square
UInt32 SideOf(UInt32 count) {
  return static_cast<UInt32>(std::ceil(std::sqrt(static_cast<Real>(count))));
}

}  // namespace

std::string MakeTowers(UInt32 boxes, UInt32 threads, const std::string& engine,
                       const std::string& attributes) {
  const UInt32 side = SideOf(boxes / kHigh);
  std::ostringstream arena;
  for (UInt32 i = 0; i < boxes; ++i) {
    const UInt32 tower = i / kHigh;
    const UInt32 level = i % kHigh;
    AddBox(arena, i, 0.5 * (tower % side), 0.5 * (tower / side), 0.1 * level, 7.0 * level);
  }
  return MakeExperiment(arena.str(), threads, engine, attributes);
}

std::string MakeStack(UInt32 boxes, UInt32 threads, const std::string& engine,
                      const std::string& attributes) {
  constexpr UInt32 kRows = 20;
  std::ostringstream arena;
  UInt32 number = 0;
  for (UInt32 pyramid = 0; number < boxes; ++pyramid) {
    for (UInt32 row = 0; row < kRows; ++row) {
      for (UInt32 i = 0; i < kRows - row && number < boxes; ++i) {
        AddBox(arena, number++, 0.21 * (i + 0.5 * row), 1.0 * pyramid, 0.1 * row, 0.0);
      }
    }
  }
  return MakeExperiment(arena.str(), threads, engine, attributes);
}

std::string MakePile(UInt32 balls, UInt32 threads, const std::string& engine,
                     const std::string& attributes) {
  constexpr Real kApart = 0.11;  // m
  const UInt32 side = SideOf((balls + kHigh - 1) / kHigh);
  const Real half = 0.5 * kApart * side;
  std::ostringstream arena;
  for (const int sign : {-1, 1}) {
    const Real at = sign * (half + 0.05);
    arena << "<box id='x" << sign << "' size='0.1," << 2.0 * half << ",2' movable='false'><body "
          << "position='" << at << ",0,0'/></box><box id='y" << sign << "' size='"
          << 2.0 * half + 0.2 << ",0.1,2' movable='false'><body position='0," << at
          << ",0'/></box>";
  }
  for (UInt32 i = 0; i < balls; ++i) {
    const UInt32 layer = i / (side * side);
    // a little aside of those below
    const Real x = kApart * (i % side - 0.5 * (side - 1.0)) + 1e-3 * (i * 7 % 5 - 2.0);
    const Real y = kApart * (i / side % side - 0.5 * (side - 1.0)) + 1e-3 * (i * 11 % 7 - 3.0);
    arena << "<prototype id='b" << i << "' movable='true'><body position='" << x << "," << y << ","
          << 0.001 + 0.107 * layer << "'/><links ref='l'><link id='l' geometry='sphere' "
          << "radius='0.05' mass='0.5'/></links></prototype>";
  }
  return MakeExperiment(arena.str(), threads, engine, attributes);
}

}  // namespace argos::testing
