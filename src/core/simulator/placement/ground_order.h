#ifndef ARGOS3_CORE_SIMULATOR_PLACEMENT_GROUND_ORDER_H
#define ARGOS3_CORE_SIMULATOR_PLACEMENT_GROUND_ORDER_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/vector3.h>

#include <vector>

namespace argos {

/**
 * An order in which places that are near on the ground are mostly near: that of the Z-order curve
 * over square tiles (G. M. Morton, "A computer oriented geodetic data base", IBM, 1966). Places on
 * one tile keep their order.
 *
 * @param positions  m; heights are ignored.
 * @param tile       side of a tile, m; at least a billionth of the extent of the positions is used.
 * @return the numbers of all positions.
 */
std::vector<UInt32> OrderOnGround(const std::vector<CVector3>& positions, Real tile);

}  // namespace argos

#endif
