#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_GHOSTS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_GHOSTS_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/active_set.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/ghost_filter.h>
#include <argos3/plugins/simulator/physics_engines/planar/ghost_discs.h>

#include <optional>
#include <vector>

namespace argos {

/**
 * Robots of other engines near the border, in a tick of a planar world.
 *
 * A robot of this world and one of another must not both use the gap between them. So for each
 * robot that may touch a ghost, a face is placed half-way between the two, with which only this
 * robot collides: a line, where the crowd solves it. Passive bodies, which other worlds do not see,
 * collide with the ghost itself.
 */
class CPlanarGhosts {
 public:
  CPlanarGhosts(CPlanarStore& store, CActiveSet& active)
      : m_store(store), m_active(active), m_filter(store) {}

  /** Allocates memory for so many Box2D bodies. */
  void Reserve(size_t bodies) {
    m_filter.Reserve(bodies);
    // at most all of them are ghosts' in a tick
    m_bodies.reserve(bodies);
    m_nearGhost.reserve(bodies);
  }
  /** Sets the ghosts of the next tick. */
  void Set(const std::vector<SGhostDisc>& ghosts) { m_ghosts.assign(ghosts.begin(), ghosts.end()); }

  /**
   * After the active robots are selected: adds faces and ghosts to the Box2D world, and lines to
   * the crowd.
   * @param reach        of discs in the tick, m.
   * @param longestPath  of any movable body in the tick, m.
   */
  void Place(CDiscPairs& discPairs, CCrowd& crowd, Real reach, Real longestPath);
  /** After the tick: removes them. */
  void Remove();

 private:
  void PlaceLine(const SGhostDisc& ghost, UInt32 place, CDiscPairs& discPairs, CCrowd& crowd);
  void PlaceForSolids(const SGhostDisc& ghost, CCrowdSolids& solids, Real reach, Real longestPath);
  static std::optional<SFootprint> MakeFace(const SGhostDisc& ghost, const SDrivenBody& body,
                                            Real longestPath);
  void PlaceFace(const SGhostDisc& ghost, const SDrivenBody& body, Real longestPath);
  void PlaceDisc(const SGhostDisc& ghost, Real longestPath);
  b2Body& CreateGhostBody(const SPlanarPose& pose, UInt32 partner);

  CPlanarStore& m_store;
  CActiveSet& m_active;
  CGhostFilter m_filter;
  std::vector<SGhostDisc> m_ghosts;  // of this tick
  std::vector<b2Body*> m_bodies;  // between Place() and Remove()
  std::vector<UInt32> m_nearGhost;  // places; scratch of Place()
};

}  // namespace argos

#endif
