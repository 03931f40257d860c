#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CROWD_SOLIDS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CROWD_SOLIDS_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_store.h>
#include <argos3/plugins/simulator/physics_engines/planar/cell_lists.h>
#include <argos3/plugins/simulator/physics_engines/planar/disc_pairs.h>

#include <limits>
#include <vector>

namespace argos {

/**
 * The solids of a tick, movable bodies that are not discs with a drive, and what they can meet.
 *
 * An item is a disc, by its place in CDiscPairs, or a solid: solids are numbered after the discs.
 */
class CCrowdSolids {
 public:
  static constexpr UInt32 kNone = std::numeric_limits<UInt32>::max();

  struct SSolid {
    EPlanarKind Kind = EPlanarKind::Passive;
    UInt32 Slot = 0;
    const SPlanarSolid* Shape = nullptr;
    Real X = 0.0, Y = 0.0;  // the centre of mass at the start of the tick, m
    Real Cos = 1.0, Sin = 0.0;  // of the yaw, then
    UInt32 FirstPart = 0;
    bool IsAwake = false;  // it moves by itself, or may overlap others
  };
  /**
   * Parts of two bodies that can meet in a tick. A disc is A; an obstacle is B, with its number as
   * part.
   */
  struct SPair {
    UInt32 A, B;  // items; B is kNone for an obstacle
    UInt32 PartA, PartB;  // of all parts; kNone for a disc
  };

  void Reserve(size_t solids, size_t pairs);
  /**
   * Lists all solids, and finds what they can meet; after CDiscPairs::Find().
   * @param discReach, solidReach  how far discs and parts of solids move in the tick, m.
   */
  void Find(const CPlanarStore& store, CDiscPairs& discPairs, Real discReach, Real solidReach);
  /** Adds a body that does not move, in this tick, for one solid. @return its number. */
  void AddObstacle(UInt32 item, const SFootprint& obstacle, Real reach);

  UInt32 GetNumDiscs() const { return m_numDiscs; }
  bool IsSolid(UInt32 item) const { return item >= m_numDiscs; }
  const std::vector<SSolid>& GetSolids() const { return m_solids; }
  const SSolid& GetSolid(UInt32 item) const { return m_solids[item - m_numDiscs]; }
  /** The item of a passive body, or of a robot that is no disc, by its slot. */
  UInt32 GetItem(EPlanarKind kind, UInt32 slot) const;
  const std::vector<SPair>& GetPairs() const { return m_pairs; }
  /** The parts of all solids at the start of the tick, world frame. */
  const std::vector<SFootprint>& GetParts() const { return m_parts; }
  /** Numbers of parts from this one on are those of obstacles of this tick only. */
  static constexpr UInt32 kFirstOfTick = UInt32(1) << 31;
  const SFootprint& GetObstacle(UInt32 part) const { return m_obstacles[part - kFirstOfTick]; }
  /** Calls visit(item) for every solid in a circle, perhaps for others. */
  template <typename VISIT>
  void ForNear(Real x, Real y, Real radius, VISIT&& visit) {
    FindPartsNear(x, y, radius);
    UInt32 last = kNone;
    for (const UInt32 part : m_found) {
      if (m_solidOf[part] != last) {
        last = m_solidOf[part];
        visit(m_numDiscs + last);
      }
    }
  }

 private:
  void List(const CPlanarStore& store);
  void Add(EPlanarKind kind, UInt32 slot, const SPlanarSolid& shape, const SPlanarPose& pose,
           bool isAwake);
  void FindPartsNear(Real x, Real y, Real radius);
  void PairWithDiscs(UInt32 solid, CDiscPairs& discPairs, Real discReach, Real solidReach);
  void PairWithSolids(UInt32 solid, Real solidReach);
  void PairWithObstacles(UInt32 solid, const CDiscPairs& discPairs, Real solidReach);

  UInt32 m_numDiscs = 0;
  std::vector<SSolid> m_solids;  // passive bodies, then robots; both by slot
  size_t m_numPassive = 0;
  std::vector<SFootprint> m_parts;
  std::vector<UInt32> m_solidOf;  // by part
  std::vector<SPair> m_pairs;  // with obstacles last
  std::vector<SPair> m_obstaclePairs;  // scratch
  std::vector<SFootprint> m_obstacles;  // of this tick
  SPeriodicity m_period;
  CFramedGrid m_grid;
  CCellLists m_cells;  // of the parts
  std::vector<UInt32> m_found;  // scratch
};

}  // namespace argos

#endif
