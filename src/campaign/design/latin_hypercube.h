#ifndef ARGOS3_CAMPAIGN_DESIGN_LATIN_HYPERCUBE_H
#define ARGOS3_CAMPAIGN_DESIGN_LATIN_HYPERCUBE_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <vector>

namespace argos {

class CRandomStream;

/** The numbers 0, ..., count - 1 in random order, each order with equal probability. */
std::vector<UInt32> DrawPermutation(UInt32 count, CRandomStream& random);

/**
 * One dimension of a Latin hypercube sample over levels: each level occurs samples / levels times,
 * rounded down or up, in random order.
 * @return (samples) indices of levels.
 */
std::vector<UInt32> DrawBalancedLevels(UInt32 samples, UInt32 levels, CRandomStream& random);

/**
 * One dimension of a Latin hypercube sample over [0,1): stratum i, [i / samples, (i + 1) /
 * samples), has one place, uniformly distributed in it.
 * @return (samples) places, ascending.
 *
 * Source: McKay, Beckman, Conover, "A comparison of three methods for selecting values of input
 * variables in the analysis of output from a computer code", Technometrics 21 (1979).
 */
std::vector<Real> DrawPlacesInStrata(UInt32 samples, CRandomStream& random);

}  // namespace argos

#endif
