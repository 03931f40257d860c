#include <argos3/testing/support/rooms.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace argos::testing {

namespace {

constexpr Real kWallThickness = 0.1;  // m
constexpr Real kWallHeight = 0.5;  // m

class CWalls {
 public:
  explicit CWalls(std::ostringstream& xml) : m_xml(xml) {}

  // adds a wall between two points on a line along x or along y
  void Add(bool alongX, Real from, Real to, Real at) {
    const Real length = to - from;
    const Real middle = 0.5 * (from + to);
    m_xml << "<box id=\"wall_" << m_count++ << "\" movable=\"false\" size=\""
          << (alongX ? length : kWallThickness) << "," << (alongX ? kWallThickness : length) << ","
          << kWallHeight << "\"><body position=\"" << (alongX ? middle : at) << ","
          << (alongX ? at : middle) << ",0\"/></box>\n";
  }

 private:
  std::ostringstream& m_xml;
  UInt32 m_count = 0;
};

void AddRooms(std::ostringstream& xml, Real side, UInt32 rooms, Real doorWidth) {
  CWalls walls(xml);
  const Real half = 0.5 * side;
  const Real room = side / rooms;
  const Real door = std::min(doorWidth, 0.3 * room);
  for (const bool alongX : {true, false}) {
    walls.Add(alongX, -half, half, -half);
    walls.Add(alongX, -half, half, half);
    // every wall between two rooms has a door in its middle
    for (UInt32 line = 1; line < rooms; ++line) {
      for (UInt32 k = 0; k < rooms; ++k) {
        const Real from = -half + k * room;
        const Real middle = from + 0.5 * room;
        walls.Add(alongX, from, middle - 0.5 * door, -half + line * room);
        walls.Add(alongX, middle + 0.5 * door, from + room, -half + line * room);
      }
    }
  }
}

}  // namespace

Real SRoomsWorld::SideAtSameDensity(UInt32 robots) {
  return 40.0 * std::sqrt(robots / 10000.0);
}

UInt32 SRoomsWorld::RoomsAlong(Real side) {
  return std::max(1U, static_cast<UInt32>(std::lround(side / 10.0)));
}

std::string SRoomsWorld::ToXML() const {
  const Real reach = 0.5 * Side - 0.2;
  std::ostringstream xml;
  xml << "<argos-configuration><framework><system threads=\"" << Threads << "\" method=\"" << Method
      << "\"/><experiment length=\"0\" ticks_per_second=\"10\" random_seed=\"" << Seed
      << "\"/></framework>\n<controllers><" << Controller << " id=\"diffusion\">"
      << "<actuators><differential_steering implementation=\"default\"/>" << Actuators
      << "</actuators><sensors><epuck_proximity implementation=\"default\"/>" << Sensors
      << "</sensors><params/>"
      << "</" << Controller << "></controllers>\n<arena size=\"" << Side + 1.0 << "," << Side + 1.0
      << ",1\">\n";
  AddRooms(xml, Side, RoomsPerSide, DoorWidth);
  xml << "<distribute><position method=\"uniform\" min=\"" << -reach << "," << -reach
      << ",0\" max=\"" << reach << "," << reach << ",0\"/>"
      << "<orientation method=\"uniform\" min=\"0,0,0\" max=\"360,0,0\"/>"
      << "<entity quantity=\"" << Robots << "\" max_trials=\"100\"><e-puck id=\"ep\">"
      << "<controller config=\"diffusion\"/></e-puck></entity></distribute>\n</arena>\n"
      << "<physics_engines><" << Engine << " id=\"engine\" " << EngineAttributes << ">"
      << EngineChildren << "</" << Engine << "></physics_engines>\n<media>" << Media
      << "</media></argos-configuration>\n";
  return xml.str();
}

}  // namespace argos::testing
