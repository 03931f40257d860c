#ifndef ARGOS3_TESTING_SUPPORT_CROWD_H
#define ARGOS3_TESTING_SUPPORT_CROWD_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>

namespace argos::testing {

/**
 * Arena text of e-pucks that drive at a wall, 20 deep, between two side walls, almost as dense as
 * they can be: all of them touch their neighbours or can do so within a tick. Their controller is
 * "driver", a contract_driver.
 */
std::string PressingCrowdText(UInt32 robots);

/** Width of that crowd, along y, m; it is centred at y = 0. */
Real ComputeCrowdWidth(UInt32 robots);

}  // namespace argos::testing

#endif
