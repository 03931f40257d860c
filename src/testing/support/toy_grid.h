#ifndef ARGOS3_TESTING_SUPPORT_TOY_GRID_H
#define ARGOS3_TESTING_SUPPORT_TOY_GRID_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>

namespace argos {

/** XML of toy robots (toy_world.h) with the controller "c" in a square. @param side  robots. */
inline std::string ToyRobotGrid(UInt32 side) {
  return "<distribute><position method='grid' center='0,0,0' distances='0.2,0.2,1' layout='" +
         std::to_string(side) + "," + std::to_string(side) +
         ",1'/><orientation method='constant' values='0,0,0'/><entity quantity='" +
         std::to_string(side * side) +
         "' max_trials='1'><toy-robot id='r'><controller config='c'/></toy-robot></entity>"
         "</distribute>";
}

}  // namespace argos

#endif
