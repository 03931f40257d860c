#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CROWD_SOLVER_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CROWD_SOLVER_H

#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/contact_memory.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_bodies.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_clusters.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/touch_memory.h>
#include <argos3/plugins/simulator/physics_engines/planar/body_forest.h>
#include <argos3/plugins/simulator/physics_engines/planar/contact_island.h>
#include <argos3/plugins/simulator/physics_engines/planar/separation.h>

#include <limits>
#include <span>
#include <vector>

namespace argos {

/** What was remembered of the contacts of the tick before. */
struct SCrowdMemory {
  CContactMemory Pairs, Walls;
  CTouchMemory Touches;
};

/**
 * Moves the bodies of clusters that touch, or may touch, each other and immovable things.
 *
 * In each substep the velocities are found that drives, contacts and friction allow together, by
 * sweeps over drives and contacts (projected Gauss-Seidel, as in Box2D: E. Catto, Iterative
 * Dynamics with Temporal Coherence, 2005), with the forces of the substep before as a start. A
 * contact limits the speed of approach to what the gap allows (speculative contact), so that discs
 * that move towards each other stop when they touch, in any number of substeps. A cluster is swept
 * until the velocities change no more than a tolerance: so a deep crowd costs more than a pair,
 * and pays for itself only. Where there are solids, whose masses may differ by orders of magnitude,
 * islands of bodies that press each other are solved apart: CContactIsland.
 *
 * The patches of a large cluster are swept on all threads, then the pairs on their borders; patches
 * in which nothing changes any more are left out. The result depends on no thread.
 */
class CCrowdSolver {
 public:
  void Reserve(size_t discs);
  void ReserveForSolids(size_t discs, size_t solids, size_t touches);
  void ReserveGrips(size_t grips) {
    m_grips.reserve(grips);
    m_islandGrips.reserve(grips);
    m_gripOrder.reserve(grips);
  }
  /** Sets the number of discs, all of which are to be filled in. */
  void Start(const SCrowdTick& tick, size_t discs);
  SCrowdDisc& GetDisc(UInt32 member) { return m_discs[member]; }
  SCrowdDrive& GetDrive(UInt32 member) { return m_drives[member]; }
  SCrowdPosition& GetPosition(UInt32 member) { return m_positions[member]; }
  /**
   * Moves all discs by one tick.
   * @param lines  what obstacles from kFirstLine on are.
   * @param grips  what CCrowdClusters united; their state is changed.
   */
  void Solve(CThreadPool& pool, const CCrowdClusters& clusters, const CDiscPairs& discPairs,
             const CCrowdSolids& solids, const std::vector<SCrowdLine>& lines,
             const SCrowdMemory& memory, std::vector<SCrowdGrip>& grips);
  /** After Solve(): has anything pushed the body? */
  bool IsPushed(UInt32 member) const { return m_isPushed[member] != 0; }
  /** After Solve(): stores the forces of the last substep. @param slots  of robots. */
  void Remember(size_t slots, SCrowdMemory& memory) const;
  /** After Solve(): calls visit(A, B) for the members that pressed each other; B may be kNone. */
  template <typename VISIT>
  void ForForces(VISIT&& visit) const;
  /** After Solve(): the deepest overlap that is left, m. */
  Real GetDeepest() const { return m_deepest; }

 private:
  /** In place of the number of something immovable in an island. */
  static constexpr UInt32 kNoPlace = std::numeric_limits<UInt32>::max();

  struct SSubstep {
    float Duration;  // s
    UInt32 Number, Count;
  };
  // as an island has them
  using SBody = SIslandBody<float>;
  using SCopy = SIslandContact<float>;
  using SGrip = SIslandGrip<float>;
  /** A contact of two discs in a substep. */
  struct SContact {
    UInt32 A, B, Pair;
    float NX, NY;  // from A to B
    float Approach;  // greatest speed of approach, m/s; negative: they must part
    float Mass, TangentMass;  // that resist along the normal and along the tangent, kg
    float Normal, Tangent;  // impulses, N s
  };
  /** A contact of a disc with something that does not move. */
  struct SWallContact {
    UInt32 Disc, Wall;
    float NX, NY;  // towards the wall
    float Approach;
    float Friction;
    float Normal, Tangent;
  };
  /** A contact point of a solid with another body, or with something that does not move. */
  struct STouch {
    UInt32 A, B, Point;  // B is kNone for something immovable
    float NX, NY;  // from A to B
    // of the normal and of the tangent about the centres of mass, m
    float NormalLeverA, TangentLeverA, NormalLeverB, TangentLeverB;
    float Approach;
    float Mass, TangentMass;
    float Friction;
    float Normal, Tangent;
  };
  /** Bodies that press each other, and their contacts: ranges of the lists in their order. */
  struct SIsland {
    SCrowdRange Members, Contacts, Touches, Walls, Grips;
  };
  /** The contacts of a patch in a substep, and how far it is solved. */
  struct SPatchState {
    UInt32 NumContacts = 0, NumBorder = 0, NumWalls = 0;
    UInt32 NumTouches = 0, NumBorderTouches = 0;
    float Change = 0.0F;  // greatest change of a velocity in the last sweep, m/s
    float BorderChange = 0.0F;
    float Deepest = 0.0F, BorderDeepest = 0.0F;  // overlap, m
    bool IsDue = false;  // in the next sweep
  };

  void LookUpForces(CThreadPool& pool, const SCrowdMemory& memory);
  void SolveSmall(UInt32 patch);
  template <typename VISIT>
  static void ForPatches(CThreadPool& pool, const SCrowdCluster& cluster, VISIT&& visit);
  template <typename VISIT>
  static void ForBorders(CThreadPool& pool, const SCrowdCluster& cluster, VISIT&& visit);
  void SolveLarge(CThreadPool& pool, const SCrowdCluster& cluster);
  void StartSubstep(CThreadPool& pool, const SCrowdCluster& cluster, const SSubstep& substep);
  bool SweepLarge(CThreadPool& pool, const SCrowdCluster& cluster, UInt32 sweep, float tolerance);
  bool PushLargeApart(CThreadPool& pool, const SCrowdCluster& cluster, bool isFirst);
  UInt32 CountSubsteps(const SCrowdPatch& patch) const;
  void FindContacts(UInt32 patch, const SSubstep& substep);
  UInt32 FindContacts(UInt32 first, UInt32 end, const SSubstep& substep, SPatchState& state);
  void FindWalls(UInt32 patch, const SSubstep& substep);
  SSeparation SeparateFromWall(const CCrowdClusters::SWall& wall, const SPlanarVector& step) const;
  void StartDrives(UInt32 patch, const SSubstep& substep);
  void StartDrive(UInt32 member, const SSubstep& substep);
  void WarmStart(UInt32 first, UInt32 count);
  void WarmStartWalls(UInt32 first, UInt32 count);
  void ApplyImpulse(const SContact& contact, float normal, float tangent);
  void ApplyImpulse(const SWallContact& contact, float normal, float tangent);
  float SweepDrives(UInt32 first, UInt32 end);
  float SweepContacts(UInt32 first, UInt32 count, bool backwards);
  float SweepWalls(UInt32 first, UInt32 count);
  float SolveContact(SContact& contact);
  float SweepPatch(UInt32 patch, UInt32 sweep);
  void TakeForces(UInt32 patch, const SSubstep& substep);
  void Move(UInt32 patch, const SSubstep& substep);
  void PushApart(UInt32 patch);
  float PushContactsApart(UInt32 first, UInt32 count);
  float PushOutOfWalls(UInt32 first, UInt32 count);
  void Push(UInt32 disc, Real x, Real y);
  static void RaiseFlag(UInt8& flag);

  // solids: crowd_touches.cpp
  bool IsSolid(UInt32 member) const {
    return m_solids->IsSolid(m_clusters->GetMembers()[member].Item);
  }
  const CCrowdSolids::SSolid& GetSolid(UInt32 member) const {
    return m_solids->GetSolid(m_clusters->GetMembers()[member].Item);
  }
  void PlaceParts(UInt32 member);
  SFootprint GetPartNear(const CCrowdClusters::STouch& pair) const;
  int FindPoints(const CCrowdClusters::STouch& pair, float duration, SSeparation* points) const;
  SPlanarVector ComputeStep(const CCrowdClusters::STouch& pair, float duration) const;
  UInt32 FindTouches(const SCrowdRange& range, const SSubstep& substep, SPatchState& state);
  bool MakeTouch(const CCrowdClusters::STouch& pair, const SSeparation& point, Real most,
                 STouch& touch, SPatchState& state) const;
  void LookUpTouchForces(CThreadPool& pool, const CTouchMemory& memory);
  void RememberTouches(CTouchMemory& memory) const;
  CTouchMemory::SKey MakeKey(UInt32 touch, UInt32 point) const;
  void WarmStartTouches(UInt32 first, UInt32 count);
  void ApplyImpulse(const STouch& touch, float normal, float tangent);
  float SweepTouches(UInt32 first, UInt32 count, bool backwards);
  float SolveTouch(STouch& touch);
  void TakeTouchForces(UInt32 first, UInt32 count, float perSecond);
  void MoveSolid(UInt32 member, const SSubstep& substep);
  float PushTouchesApart(const SCrowdRange& range);
  void PushPoint(const CCrowdClusters::STouch& pair, const SSeparation& point, Real share);

  // grips: crowd_grips.cpp
  void FindGrips(const SCrowdRange& range, const SSubstep& substep);
  void FindGrip(UInt32 number, const SSubstep& substep);
  static SGripMotion<float> MotionOf(const SCrowdDisc& disc) {
    return {disc.VX, disc.VY, disc.W, disc.InverseMass, disc.InverseInertia};
  }
  void ApplyImpulse(SGrip& grip, const SGripChange<float>& change);
  void WarmStartGrips(const SCrowdRange& range);
  float SweepGrips(const SCrowdRange& range);
  void TakeGrips(UInt32 patch, const SSubstep& substep);

  // islands: crowd_islands.cpp
  // whether a patch of the cluster has the property
  bool HasPatch(const SCrowdCluster& cluster, bool (SCrowdPatch::*property)() const) const;
  template <typename VISIT>
  void ForRanges(const SCrowdCluster& cluster, VISIT&& visit) const;
  UInt32 BuildIslands(const SCrowdCluster& cluster);
  void SortIntoIslands(const SCrowdCluster& cluster, UInt32 first, UInt32 end);
  std::span<SBody> CopyBodies(UInt32 island);
  template <typename VISIT>
  std::span<SCopy> ForContacts(const SIsland& island, VISIT&& visit);
  void CopyContact(const SContact& contact, SCopy& copy) const;
  void CopyContact(const STouch& contact, SCopy& copy) const;
  void CopyContact(const SWallContact& contact, SCopy& copy) const;
  void SolveIsland(UInt32 island, float tolerance);
  void IterateSmall(UInt32 patch, float tolerance);
  void IterateLarge(CThreadPool& pool, const SCrowdCluster& cluster, float tolerance);

  SCrowdTick m_tick;
  float m_tolerance = 0.0F;  // m in a substep
  float m_deepEnough = 0.0F;  // m
  Real m_slop = 0.0;  // m
  const CCrowdClusters* m_clusters = nullptr;
  const CDiscPairs* m_discPairs = nullptr;
  const CCrowdSolids* m_solids = nullptr;
  const std::vector<SCrowdLine>* m_lines = nullptr;
  std::vector<SCrowdGrip>* m_gripStates = nullptr;
  // by member
  std::vector<SCrowdDisc> m_discs;
  std::vector<SCrowdDrive> m_drives;
  std::vector<SCrowdPosition> m_positions;
  std::vector<UInt8> m_isTouching;  // something, in this substep
  std::vector<UInt8> m_isPushed;  // in this tick
  std::vector<UInt8> m_isLoaded;  // by a contact, in this substep
  TBodyForest m_islandParent;
  std::vector<UInt32> m_islandOf;
  // from the number of the first member of a cluster
  std::vector<SIsland> m_islands;
  std::vector<UInt32> m_memberOrder;
  std::vector<UInt32> m_islandPlace;  // number in the island, by member
  std::vector<SBody> m_islandBodies;
  std::vector<SFootprint> m_parts;  // of solids
  // by pair and by wall: N
  std::vector<SContactForce> m_pairForces;
  std::vector<SContactForce> m_wallForces;
  std::vector<SContactForce> m_touchForces;  // two for each touch
  // those of a patch begin at the number of its first pair or wall
  std::vector<SContact> m_contacts;
  std::vector<SWallContact> m_wallContacts;
  std::vector<STouch> m_touches;  // from twice the number of the first touch
  std::vector<SGrip> m_grips;  // as the clusters have them
  // in the order of islands
  std::vector<UInt32> m_contactOrder, m_wallOrder, m_touchOrder, m_gripOrder;
  std::vector<SCopy> m_islandContacts;
  std::vector<SGrip> m_islandGrips;
  std::vector<SPatchState> m_states;  // by patch
  Real m_deepest = 0.0;  // m
};

template <typename VISIT>
void CCrowdSolver::ForForces(VISIT&& visit) const {
  for (size_t i = 0; i < m_pairForces.size(); ++i) {
    if (m_pairForces[i].Normal > 0.0F) {
      visit(m_clusters->GetPairs()[i].A, m_clusters->GetPairs()[i].B);
    }
  }
  for (size_t i = 0; i < m_wallForces.size(); ++i) {
    if (m_wallForces[i].Normal > 0.0F) {
      visit(m_clusters->GetWalls()[i].Disc, CCrowdSolids::kNone);
    }
  }
  for (size_t i = 0; i < m_touchForces.size(); ++i) {
    if (m_touchForces[i].Normal > 0.0F) {
      visit(m_clusters->GetTouches()[i / 2].A, m_clusters->GetTouches()[i / 2].B);
    }
  }
}

// Calls visit(patch) for the patches of a cluster, on all threads.
template <typename VISIT>
void CCrowdSolver::ForPatches(CThreadPool& pool, const SCrowdCluster& cluster, VISIT&& visit) {
  pool.ParallelFor(cluster.EndPatch - cluster.FirstPatch, 1, [&](size_t begin, size_t end, UInt32) {
    for (size_t i = begin; i < end; ++i) {
      visit(cluster.FirstPatch + static_cast<UInt32>(i));
    }
  });
}

// Calls visit(patch) for the borders after patches 0, 2, ..., then after 1, 3, ...: no two have a
// patch in common.
template <typename VISIT>
void CCrowdSolver::ForBorders(CThreadPool& pool, const SCrowdCluster& cluster, VISIT&& visit) {
  const UInt32 numPatches = cluster.EndPatch - cluster.FirstPatch;
  for (UInt32 parity = 0; parity < 2; ++parity) {
    pool.ParallelFor((numPatches - parity) / 2, 1, [&](size_t begin, size_t end, UInt32) {
      for (size_t i = begin; i < end; ++i) {
        visit(cluster.FirstPatch + parity + 2 * static_cast<UInt32>(i));
      }
    });
  }
}

}  // namespace argos

#endif
