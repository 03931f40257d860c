#ifndef ARGOS3_TESTING_SUPPORT_ROOMS_H
#define ARGOS3_TESTING_SUPPORT_ROOMS_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>

namespace argos::testing {

/** The world of the benchmark: e-pucks that diffuse in a square arena of rooms with doors. */
struct SRoomsWorld {
  UInt32 Robots = 1000;
  Real Side = 40.0; /**< of the arena, m */
  UInt32 RoomsPerSide = 4; /**< 4 x 4 = 16 rooms */
  Real DoorWidth = 1.0; /**< m; at most 0.3 of a room */
  UInt32 Threads = 0;
  std::string Method = "balance_quantity";
  UInt32 Seed = 1;
  std::string Engine = "dynamics2d";
  std::string EngineAttributes; /**< such as `iterations="4"` */
  std::string EngineChildren; /**< XML elements */
  std::string Controller = "epuck_diffusion_controller"; /**< label */
  std::string Actuators, Sensors; /**< XML elements in addition to wheels and proximity sensors */
  std::string Media; /**< XML elements */

  /** Side at which @p robots have the density of 10,000 in 40 m x 40 m. */
  static Real SideAtSameDensity(UInt32 robots);
  /** Number of rooms along a side (m) for which they are about 10 m wide. */
  static UInt32 RoomsAlong(Real side);
  /** XML of the experiment. */
  std::string ToXML() const;
};

}  // namespace argos::testing

#endif
