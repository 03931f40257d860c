#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_BODY_FOREST_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_BODY_FOREST_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <algorithm>
#include <compare>
#include <span>
#include <vector>

namespace argos {

/** Sets of connected bodies: the parent of each one, of roots themselves. */
using TBodyForest = std::vector<UInt32>;

/** Makes a forest of single bodies. */
inline void ResetForest(TBodyForest& parents, size_t bodies) {
  parents.resize(bodies);
  for (UInt32 i = 0; i < parents.size(); ++i) {
    parents[i] = i;
  }
}

/** @return the body that stands for all that are connected with this one. */
inline UInt32 FindRootOf(TBodyForest& parents, UInt32 body) {
  while (parents[body] != body) {
    parents[body] = parents[parents[body]];
    body = parents[body];
  }
  return body;
}

/** Connects two bodies; the lower number stands for both. */
inline void Connect(TBodyForest& parents, UInt32 a, UInt32 b) {
  a = FindRootOf(parents, a);
  b = FindRootOf(parents, b);
  parents[std::max(a, b)] = std::min(a, b);
}

/** A body, or a contact of one, in a list that is sorted by the roots of bodies. */
struct SForestMember {
  UInt32 Root, Number;
  bool operator<(const SForestMember& other) const {
    return Root != other.Root ? Root < other.Root : Number < other.Number;
  }
};

/** @return the members with that root. @param next  the first of them; then what follows them. */
inline std::span<const SForestMember> TakeTree(const std::vector<SForestMember>& members,
                                               UInt32 root, size_t& next) {
  const size_t first = next;
  while (next < members.size() && members[next].Root == root) {
    ++next;
  }
  return std::span(members).subspan(first, next - first);
}

}  // namespace argos

#endif
