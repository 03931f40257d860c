#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_GHOSTS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_GHOSTS_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd.h>
#include <argos3/plugins/simulator/physics_engines/planar/ghost_discs.h>

#include <optional>
#include <vector>

namespace argos {

/**
 * Robots of other engines near the border, in a tick of a planar world.
 *
 * A robot of this world and one of another must not both use the gap between them. So for each
 * robot that may touch a ghost, a face is placed half-way between the two, with which only this
 * robot collides: a line, if it is a disc. Passive bodies, which other worlds do not see,
 * collide with the ghost itself.
 */
class CPlanarGhosts {
 public:
  explicit CPlanarGhosts(const CPlanarStore& store) : m_store(store) {}

  /** Allocates memory for so many bodies. */
  void Reserve(size_t bodies) { m_nearGhost.reserve(bodies); }
  /** Sets the ghosts of the next tick. */
  void Set(const std::vector<SGhostDisc>& ghosts) { m_ghosts.assign(ghosts.begin(), ghosts.end()); }

  /**
   * After CCrowd::Start(): adds faces, lines and ghosts to the crowd.
   * @param reach        of discs in the tick, m.
   * @param longestPath  of any movable body in the tick, m.
   */
  void Place(CDiscPairs& discPairs, CCrowd& crowd, Real reach, Real longestPath);

 private:
  static void PlaceLine(const SGhostDisc& ghost, UInt32 place, CDiscPairs& discPairs,
                        CCrowd& crowd);
  void PlaceForSolids(const SGhostDisc& ghost, CCrowdSolids& solids, Real reach, Real longestPath);
  static std::optional<SFootprint> MakeFace(const SGhostDisc& ghost, const SDrivenBody& body,
                                            Real longestPath);

  const CPlanarStore& m_store;
  std::vector<SGhostDisc> m_ghosts;  // of this tick
  std::vector<UInt32> m_nearGhost;  // places; scratch of Place()
};

}  // namespace argos

#endif
