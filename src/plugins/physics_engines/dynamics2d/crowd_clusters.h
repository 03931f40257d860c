#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CROWD_CLUSTERS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CROWD_CLUSTERS_H

#include <argos3/core/utility/spatial/counting_sort.h>
#include <argos3/plugins/simulator/physics_engines/planar/disc_pairs.h>

#include <vector>

namespace argos {

/**
 * Discs that are solved one after the other: a whole cluster, or a strip of a large one. Ranges of
 * the arrays of CCrowdClusters.
 */
struct SCrowdPatch {
  UInt32 FirstDisc = 0, EndDisc = 0;
  UInt32 FirstPair = 0, EndPair = 0;  // of which both discs are in the patch
  UInt32 FirstBorder = 0, EndBorder = 0;  // of which one disc is in the next patch
  UInt32 FirstWall = 0, EndWall = 0;
};

/** A cluster: one patch, or several of which each has pairs with the next one only. */
struct SCrowdCluster {
  UInt32 FirstPatch, EndPatch;
};

/**
 * The discs that can meet something in a tick, in clusters: discs of different clusters cannot
 * meet. A large cluster is cut into strips across its longer side, so wide that only adjoining
 * ones have pairs in common; strips that do not adjoin can be solved at the same time.
 *
 * Everything depends on the places of the discs only, not on threads: clusters are in the order of
 * their first places, and discs and pairs in the order of places within a patch.
 */
class CCrowdClusters {
 public:
  /** A disc in a cluster. */
  struct SMember {
    UInt32 Place, Number;
  };
  /** Two discs, by their numbers in GetMembers(). */
  struct SPair {
    UInt32 A, B;
  };
  struct SWall {
    UInt32 Disc, Obstacle;
  };

  void Reserve(size_t discs);
  /** Unites discs that can meet; after CDiscPairs::Find(). */
  void Unite(const CDiscPairs& discPairs);
  /** Leaves out the cluster of a disc; between Unite() and Build(). */
  void Exclude(UInt32 place) {
    m_isExcluded[FindRoot(place)] = 1;
    m_hasExcluded = true;
  }
  bool HasExcluded() const { return m_hasExcluded; }
  /** Is the disc in an excluded cluster? */
  bool IsExcluded(UInt32 place) { return m_isExcluded[FindRoot(place)] != 0; }
  /** Lists the clusters that are not excluded. */
  void Build(const CDiscPairs& discPairs, Real reach);

  const std::vector<SMember>& GetMembers() const { return m_members; }
  const std::vector<SPair>& GetPairs() const { return m_pairs; }
  const std::vector<SWall>& GetWalls() const { return m_walls; }
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

  UInt32 FindRoot(UInt32 place) {
    while (m_parent[place] != place) {
      m_parent[place] = m_parent[m_parent[place]];
      place = m_parent[place];
    }
    return place;
  }
  void NumberClusters(const CDiscPairs& discPairs);
  void CutIntoStrips(Real pairReach);
  UInt32 ComputePatch(const CDiscPairs::SDisc& disc, const SExtent& cluster) const;
  void SortMembers(const CDiscPairs& discPairs);
  void SortPairs(const CDiscPairs& discPairs);
  void SortWalls(const CDiscPairs& discPairs);

  std::vector<UInt32> m_parent;  // by place
  std::vector<UInt8> m_isExcluded;  // by place of the root
  bool m_hasExcluded = false;
  std::vector<UInt32> m_clusterOf;  // by place; kNone: in no cluster
  std::vector<SExtent> m_clusters;
  std::vector<UInt32> m_patchOf;  // by place; kNone: in no cluster
  std::vector<UInt32> m_memberOf;  // by place
  CCountingSort m_sort;

  std::vector<SMember> m_members;
  std::vector<SPair> m_pairs;
  std::vector<SWall> m_walls;
  std::vector<SCrowdPatch> m_patches;
  std::vector<SCrowdCluster> m_large;
  size_t m_numSmall = 0;
};

}  // namespace argos

#endif
