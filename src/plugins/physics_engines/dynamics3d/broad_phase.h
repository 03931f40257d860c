#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_BROAD_PHASE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_BROAD_PHASE_H

#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

#include <array>
#include <vector>

namespace argos {

/** Two bodies whose bounds overlap, at least one of them movable. */
struct SRigidPair {
  SRigidBody* First;
  SRigidBody* Second;
};

/**
 * Finds the pairs of bodies that may touch, by sorting their bounds along x or y.
 *
 * Unlike ODE's, it treats the geoms of a robot as one body and allocates nothing in a settled tick,
 * and the order of its pairs depends on positions and numbers of bodies alone.
 */
class CBroadPhase {
 public:
  /** Allocates for a number of bodies. */
  void Reserve(size_t bodies) {
    constexpr size_t kPairsOfBody = 8;  // in a crowd
    m_entries.reserve(bodies);
    m_pairs.reserve(kPairsOfBody * bodies);
  }
  /** To be called after bodies were added, removed or placed. */
  void MarkChanged() { m_isChanged = true; }

  /**
   * Finds the pairs at the current positions.
   * @param movables, fixed  all bodies with bounds, in the order of their numbers.
   * @param substep  s: balls reach as far as they move in it.
   * @param anticipates  whether all other objects do, too.
   */
  const std::vector<SRigidPair>& FindPairs(const std::vector<SRigidBody*>& movables,
                                           const std::vector<SRigidBody*>& fixed,
                                           Real substep = 0.0, bool anticipates = false);

 private:
  struct SEntry {
    Real Low = 0.0;  // m, along the axis of the sweep
    Real High = 0.0;
    // the bounds along the other horizontal axis and the vertical: read in order, not from bodies
    // all over the memory
    std::array<Real, 2> OtherLow{};
    std::array<Real, 2> OtherHigh{};
    bool IsMovable = false;
    SRigidBody* Body = nullptr;
    UInt32 Number = 0;  // unique: movable bodies first
  };

  void List(const std::vector<SRigidBody*>& movables, const std::vector<SRigidBody*>& fixed);
  bool IsListOf(const std::vector<SRigidBody*>& movables,
                const std::vector<SRigidBody*>& fixed) const;
  void Sort();

  bool m_isChanged = true;
  UInt32 m_axis = 0;  // x or y
  std::vector<SEntry> m_entries;  // in order of Low, then of Number
  std::vector<SRigidPair> m_pairs;
};

/**
 * Computes the bounds of a body from the current positions of its solids.
 * @param path  m: by which they are larger.
 */
void UpdateBounds(SRigidBody& body, Real path = 0.0);

}  // namespace argos

#endif
