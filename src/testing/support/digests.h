#ifndef ARGOS3_TESTING_SUPPORT_DIGESTS_H
#define ARGOS3_TESTING_SUPPORT_DIGESTS_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <vector>

namespace argos {

/** Runs ticks of a world. @return its digest before the first one, and after each. */
template <typename WORLD>
std::vector<UInt64> RecordDigests(WORLD& world, UInt32 ticks) {
  std::vector<UInt64> digests = {world.ComputeDigest()};
  for (UInt32 tick = 0; tick < ticks; ++tick) {
    world.Step();
    digests.push_back(world.ComputeDigest());
  }
  return digests;
}

}  // namespace argos

#endif
