#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CROWD_SOLVER_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CROWD_SOLVER_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/contact_memory.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_clusters.h>
#include <argos3/plugins/simulator/physics_engines/planar/separation.h>

#include <vector>

namespace argos {

class CThreadPool;

/** A disc of a crowd, as the solver moves it. */
struct SCrowdDisc {
  float VX = 0.0F, VY = 0.0F;  // m/s
  float W = 0.0F;  // rad/s
  float InverseMass = 0.0F;  // 1/kg
  float InverseInertia = 0.0F;  // 1/(kg m^2)
  float Radius = 0.0F;  // m

  /** @param x,y  impulse, N s. @param turn  impulse along the rim, anticlockwise, N s. */
  void ApplyImpulse(float x, float y, float turn) {
    VX += InverseMass * x;
    VY += InverseMass * y;
    W += InverseInertia * Radius * turn;
  }
};

/** The drive of a disc: what it aims at, and the bounds of its impulses. */
struct SCrowdDrive {
  float TargetX = 0.0F, TargetY = 0.0F, TargetW = 0.0F;  // m/s, rad/s
  float InTick = 0.0F, AngularInTick = 0.0F;  // greatest impulses in a tick, N s and N m s
  float Spent = 0.0F, AngularSpent = 0.0F;  // in this tick
  float Most = 0.0F, AngularMost = 0.0F;  // in this substep
  float X = 0.0F, Y = 0.0F, Angular = 0.0F;  // impulses of this substep
};

struct SCrowdPosition {
  Real X = 0.0, Y = 0.0;  // m
  Real Turn = 0.0;  // rad, since the start of the tick
};

/** A straight line that a disc does not cross: that half-way to a robot of another engine. */
struct SCrowdLine {
  Real NormalX, NormalY;  // towards the line, of unit length
  Real X, Y;  // a point on it, m
};

/** Numbers of obstacles from this one on are those of lines. */
constexpr UInt32 kFirstLine = UInt32(1) << 31;

/** Constants of a tick. */
struct SCrowdTick {
  Real Duration = 0.1;  // s
  UInt32 LeastSubsteps = 1;
  bool RefineInCrowds = true;  // more substeps where forces add up
  Real SmallestRadius = 0.0;  // m
  /** No disc moves farther in the tick, m: those farther apart than twice this cannot meet. */
  Real LongestPath = 0.0;
};

/**
 * Moves the discs of clusters that touch, or may touch, each other and immovable things.
 *
 * In each substep the velocities are found that drives, contacts and friction allow together, by
 * sweeps over drives and contacts (projected Gauss-Seidel, as in Box2D: E. Catto, Iterative
 * Dynamics with Temporal Coherence, 2005), with the forces of the substep before as a start. A
 * contact limits the speed of approach to what the gap allows (speculative contact), so that discs
 * that move towards each other stop when they touch, in any number of substeps. A cluster is swept
 * until the velocities change no more than a tolerance: so a deep crowd costs more than a pair,
 * and pays for itself only.
 *
 * The patches of a large cluster are swept on all threads, then the pairs on their borders; patches
 * in which nothing changes any more are left out. The result depends on no thread.
 */
class CCrowdSolver {
 public:
  void Reserve(size_t discs);
  /** Sets the number of discs, all of which are to be filled in. */
  void Start(const SCrowdTick& tick, size_t discs);
  SCrowdDisc& GetDisc(UInt32 member) { return m_discs[member]; }
  SCrowdDrive& GetDrive(UInt32 member) { return m_drives[member]; }
  SCrowdPosition& GetPosition(UInt32 member) { return m_positions[member]; }
  /**
   * Moves all discs by one tick.
   * @param lines  what obstacles from kFirstLine on are.
   */
  void Solve(CThreadPool& pool, const CCrowdClusters& clusters, const CDiscPairs& discPairs,
             const std::vector<SCrowdLine>& lines, const CContactMemory& pairMemory,
             const CContactMemory& wallMemory);
  /** After Solve(): has anything pushed the disc? */
  bool IsPushed(UInt32 member) const { return m_isPushed[member] != 0; }
  /** After Solve(): stores the forces of the last substep. */
  void Remember(const CCrowdClusters& clusters, size_t slots, CContactMemory& pairMemory,
                CContactMemory& wallMemory) const;
  /** After Solve(): the deepest overlap that is left, m. */
  Real GetDeepest() const { return m_deepest; }

 private:
  struct SSubstep {
    float Duration;  // s
    UInt32 Number, Count;
  };
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
  /** The contacts of a patch in a substep, and how far it is solved. */
  struct SPatchState {
    UInt32 NumContacts = 0, NumBorder = 0, NumWalls = 0;
    float Change = 0.0F;  // greatest change of a velocity in the last sweep, m/s
    float BorderChange = 0.0F;
    float Deepest = 0.0F, BorderDeepest = 0.0F;  // overlap, m
    bool IsDue = false;  // in the next sweep
  };

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
  SSeparation SeparateFromWall(const CCrowdClusters::SWall& wall, const SStep& step) const;
  void StartDrives(UInt32 patch, const SSubstep& substep);
  void WarmStart(UInt32 first, UInt32 count);
  void WarmStartWalls(UInt32 first, UInt32 count);
  void ApplyImpulse(const SContact& contact, float normal, float tangent);
  void ApplyImpulse(const SWallContact& contact, float normal, float tangent);
  float SweepDrives(UInt32 first, UInt32 end);
  float SweepContacts(UInt32 first, UInt32 count, bool backwards);
  float SweepWalls(UInt32 first, UInt32 count);
  float SolveContact(SContact& contact);
  float SweepPatch(UInt32 patch, UInt32 sweep);
  void Finish(UInt32 patch, const SSubstep& substep);
  void PushApart(UInt32 patch);
  float PushContactsApart(UInt32 first, UInt32 count);
  float PushOutOfWalls(UInt32 first, UInt32 count);
  void Push(UInt32 disc, Real x, Real y);
  static void RaiseFlag(UInt8& flag);

  SCrowdTick m_tick;
  float m_tolerance = 0.0F;  // m in a substep
  float m_deepEnough = 0.0F;  // m
  Real m_slop = 0.0;  // m
  const CCrowdClusters* m_clusters = nullptr;
  const CDiscPairs* m_discPairs = nullptr;
  const std::vector<SCrowdLine>* m_lines = nullptr;
  // by member
  std::vector<SCrowdDisc> m_discs;
  std::vector<SCrowdDrive> m_drives;
  std::vector<SCrowdPosition> m_positions;
  std::vector<UInt8> m_isTouching;  // something, in this substep
  std::vector<UInt8> m_isPushed;  // in this tick
  // by pair and by wall: N
  std::vector<SContactForce> m_pairForces;
  std::vector<SContactForce> m_wallForces;
  // those of a patch begin at the number of its first pair or wall
  std::vector<SContact> m_contacts;
  std::vector<SWallContact> m_wallContacts;
  std::vector<SPatchState> m_states;  // by patch
  Real m_deepest = 0.0;  // m
};

}  // namespace argos

#endif
