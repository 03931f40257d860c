#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_NUMBER_SORT_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_NUMBER_SORT_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <vector>

namespace argos {

/**
 * Sorts different numbers. Of up to about a hundred it compares all with all, in vectors: unlike
 * in std::sort(), no branch depends on the numbers, whose order cannot be predicted.
 */
void SortNumbers(std::vector<UInt64>& numbers);

}  // namespace argos

#endif
