#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_GHOST_FILTER_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_GHOST_FILTER_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <box2d/box2d.h>

#include <limits>
#include <vector>

namespace argos {

class CPlanarStore;

/** Makes each body that represents a ghost collide with its partner only. */
class CGhostFilter : public b2ContactFilter {
 public:
  static constexpr UInt32 kNoGhost = std::numeric_limits<UInt32>::max();
  /** The partners are all bodies without a drive. */
  static constexpr UInt32 kPassive = kNoGhost - 1;

  explicit CGhostFilter(const CPlanarStore& store) : m_store(store) {}

  /** Sets the number of a ghost body's partner; kNoGhost if the body is no longer a ghost's. */
  void SetPartner(UInt32 body, UInt32 partner);
  /** Allocates memory for so many bodies. */
  void Reserve(size_t bodies) { m_partners.reserve(bodies); }

  bool ShouldCollide(b2Fixture* a, b2Fixture* b) override;

 private:
  UInt32 GetPartner(UInt32 body) const {
    return body < m_partners.size() ? m_partners[body] : kNoGhost;
  }
  bool IsPartner(UInt32 ghost, UInt32 body) const;

  const CPlanarStore& m_store;
  std::vector<UInt32> m_partners;  // by number of body
};

}  // namespace argos

#endif
