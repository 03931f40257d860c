#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CROWD_CLUSTERS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CROWD_CLUSTERS_H

#include <argos3/core/simulator/geometry/periodicity.h>
#include <argos3/core/utility/spatial/counting_sort.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_bodies.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_solids.h>
#include <argos3/plugins/simulator/physics_engines/planar/body_forest.h>
#include <argos3/plugins/simulator/physics_engines/planar/disc_pairs.h>

#include <vector>

namespace argos {

/** A range of an array. */
struct SCrowdRange {
  UInt32 First = 0, End = 0;

  UInt32 GetSize() const { return End - First; }
};

/**
 * Bodies that are solved one after the other: a whole cluster, or a strip of a large one. Ranges of
 * the arrays of CCrowdClusters.
 */
struct SCrowdPatch {
  UInt32 FirstDisc = 0, EndDisc = 0;  // members
  UInt32 FirstPair = 0, EndPair = 0;  // of which both discs are in the patch
  UInt32 FirstBorder = 0, EndBorder = 0;  // of which one disc is in the next patch
  UInt32 FirstWall = 0, EndWall = 0;
  // pairs of bodies of which one is a solid, or a solid and an obstacle
  SCrowdRange Touches, BorderTouches;
  SCrowdRange Grips, BorderGrips;

  bool HasGrips() const { return Grips.GetSize() + BorderGrips.GetSize() > 0; }
  /** Is there anything whose masses may differ by orders of magnitude? */
  bool HasIslands() const { return Touches.GetSize() + BorderTouches.GetSize() > 0 || HasGrips(); }
};

/** A cluster: one patch, or several of which each has pairs with the next one only. */
struct SCrowdCluster {
  UInt32 FirstPatch, EndPatch;
};

/**
 * The bodies that can meet something in a tick, in clusters: those of different clusters cannot
 * meet. A large cluster is cut into strips across its longer side, so wide that only adjoining
 * ones have pairs in common; strips that do not adjoin can be solved at the same time.
 *
 * Discs and solids are items, see CCrowdSolids. Clusters of solids in which nothing moves are left
 * out. Everything depends on the places of the bodies only, not on threads: clusters are in the
 * order of their first items, and members and pairs in the order of items within a patch.
 */
class CCrowdClusters {
 public:
  /** A body in a cluster: an item, and the number of the disc or of the solid. */
  struct SMember {
    UInt32 Item, Number;
  };
  /** Two discs, by their numbers in GetMembers(). */
  struct SPair {
    UInt32 A, B;
  };
  struct SWall {
    UInt32 Disc, Obstacle;
  };
  /** Parts of two bodies, by their numbers in GetMembers(); see CCrowdSolids::SPair. */
  struct STouch {
    UInt32 A, B;
    UInt32 PartA, PartB;
  };

  /** Two members, of which one grips the other, and the number of the grip. */
  struct SGrip {
    UInt32 Holder, Held, Number;
  };

  void Reserve(size_t items);
  void ReserveTouches(size_t touches) { m_touches.reserve(touches); }
  void ReserveGrips(size_t grips) { m_sortedGrips.reserve(grips); }
  /** Unites bodies that can meet; after Find() of both, which must stay valid. */
  void Unite(const CDiscPairs& discPairs, const CCrowdSolids& solids);
  /** Unites what grips connect; between Unite() and Build(), until which they must stay valid. */
  void Unite(const std::vector<SCrowdGrip>& grips);
  /**
   * Lists the clusters.
   * @param pairReach  of centres of pairs, m.
   * @param period     a cluster that may have pairs across a seam has one patch.
   */
  void Build(Real pairReach, const SPeriodicity& period = SPeriodicity());

  const std::vector<SMember>& GetMembers() const { return m_members; }
  const std::vector<SPair>& GetPairs() const { return m_pairs; }
  const std::vector<SWall>& GetWalls() const { return m_walls; }
  const std::vector<STouch>& GetTouches() const { return m_touches; }
  const std::vector<SGrip>& GetGrips() const { return m_sortedGrips; }
  const std::vector<SCrowdPatch>& GetPatches() const { return m_patches; }
  /** Clusters of one patch: the first ones, in this order. */
  size_t GetNumSmall() const { return m_numSmall; }
  /** Clusters of several patches. */
  const std::vector<SCrowdCluster>& GetLarge() const { return m_large; }

 private:
  static constexpr UInt32 kNone = ~UInt32(0);

  struct SExtent {
    UInt32 Size = 0;
    UInt32 FirstPatch = 0;
    UInt32 NumStrips = 1;
    bool AlongX = false;
    Real MinX = 0.0, MinY = 0.0, MaxX = 0.0, MaxY = 0.0;
    Real StripsPerMetre = 0.0;
  };

  UInt32 FindRoot(UInt32 item) { return FindRootOf(m_parent, item); }
  void Unite(UInt32 a, UInt32 b);
  size_t GetNumItems() const { return m_parent.size(); }
  SPlanarVector GetCentre(UInt32 item) const;
  void FindAwake();
  void NumberClusters();
  void CutIntoStrips(Real pairReach, const SPeriodicity& period);
  UInt32 ComputePatch(const SPlanarVector& centre, const SExtent& cluster) const;
  void SortMembers();
  void SortPairs();
  void SortWalls();
  void SortTouches();
  void SortGrips();

  const CDiscPairs* m_discPairs = nullptr;
  const CCrowdSolids* m_solids = nullptr;
  const std::vector<SCrowdGrip>* m_grips = nullptr;
  TBodyForest m_parent;  // by item
  std::vector<UInt8> m_isAwake;  // by item, of the root
  std::vector<UInt32> m_clusterOf;  // by item; kNone: in no cluster
  std::vector<SExtent> m_clusters;
  std::vector<UInt32> m_patchOf;  // by item; kNone: in no cluster
  std::vector<UInt32> m_memberOf;  // by item
  CCountingSort m_sort;

  std::vector<SMember> m_members;
  std::vector<SPair> m_pairs;
  std::vector<SWall> m_walls;
  std::vector<STouch> m_touches;
  std::vector<SGrip> m_sortedGrips;
  std::vector<SCrowdPatch> m_patches;
  std::vector<SCrowdCluster> m_large;
  size_t m_numSmall = 0;
};

}  // namespace argos

#endif
