#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_SOLIDS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_SOLIDS_H

#include <argos3/core/simulator/physics_engine/drive_source.h>
#include <argos3/core/simulator/physics_engine/planar_motion.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_handle.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/push_solver.h>
#include <argos3/plugins/simulator/physics_engines/planar/separation.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/substep.h>
#include <argos3/plugins/simulator/physics_engines/planar/cell_lists.h>
#include <argos3/plugins/simulator/physics_engines/planar/footprints.h>
#include <argos3/plugins/simulator/physics_engines/planar/ghost_discs.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_body.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/slot_generations.h>

#include <limits>
#include <span>
#include <tuple>
#include <vector>

namespace argos {

class CDiscSwarm;
struct SBodyDescription;

/** A movable body of any shape: an object that can be pushed, or a robot that is not a disc. */
struct SSolid {
  SKinematicOwner Owner;
  SPlanarPose Pose;
  size_t FirstFootprint = 0, NumFootprints = 0;  // in the lists of all
  Real BoundingRadius = 0.0;  // around the origin, m
  Real NarrowestHalf = 0.0;  // half of its narrowest side, m
  Real SquaredGyration = 0.0;  // moment of inertia over mass, m^2
  SGroundFriction Friction = {0.0, 0.0};
  // of a robot
  CDriveSource Drive;
  Real MaxForce = 0.0;  // N
  SDriveCommand LastCommand;  // of the last tick
  // of a tick
  STwist Twist;
  SPlanarPose Arc;  // the end of the arc that a robot's drive commands
  UInt32 Number = CPushSolver::kNone;  // in the solver
  bool IsFresh = true;  // was placed in an overlap, perhaps, and has not left it yet
  bool HasMoved = false;  // since its pose was last written to the entity

  bool IsPassive() const { return !Drive; }
};

// of a contact's normal about the origin of a body, m
// @param image  displacement of the image of the body that is in contact, m
Real ComputeLever(const SSolid& solid, const SSeparation& contact, const SPlanarVector& image = {});
// no point of the body moves farther, m
Real ComputeLength(const SSolid& solid, const STwist& twist);
// a twist, scaled down to a length (m) if it is longer
STwist Shortened(const SSolid& solid, const STwist& twist, Real longest);

// a pose after a share of a twist
SPlanarPose Moved(const SPlanarPose& pose, const STwist& twist, Real share);
// a footprint in the frame of a body at that pose, in the world frame
SFootprint Transform(const SFootprint& footprint, const SPlanarPose& pose);

/**
 * The movable bodies that are not discs, and movable discs without a drive.
 *
 * Each tick computes which objects robots push, and how these move (CPushSolver). Then each body
 * makes its step as far as there is space, one after the other, before the discs make theirs: so no
 * body ever penetrates another, whatever the result of the solver.
 */
class CSolids {
 public:
  void Reserve(size_t solids);
  size_t GetSize() const { return m_solids.size(); }
  void Add(const SKinematicOwner& owner, const SBodyDescription& description,
           const SPlanarPose& pose, const CDriveSource& drive, const SGroundFriction& friction);
  /** Removes a body; the last one gets its slot. */
  void Remove(const SKinematicHandle& handle);
  void SetPose(const SKinematicHandle& handle, const SPlanarPose& pose);
  /** @return true if the body of the handle is still in its slot. */
  bool IsCurrent(const SKinematicHandle& handle) const {
    return m_generations.IsCurrent(handle.Slot, handle.Generation);
  }

  /** Sets what a robot was told in the last tick. */
  void SetLastCommand(const SKinematicHandle& handle, const SDriveCommand& command) {
    Get(handle).LastCommand = command;
  }
  SDriveCommand GetLastCommand(const SKinematicHandle& handle) { return Get(handle).LastCommand; }

  /** Joins sides of the area: all bodies are to be inside of it before Plan(). */
  void SetPeriod(const SPeriodicity& period) { m_period = period; }
  /** Puts the bodies that have left the area inside. */
  void Wrap();
  /** Computes the steps that drives command. @throws SBadDriveCommand */
  void Plan(const SSubstep& substep);
  /** Sets the walls before the next Step(); they must stay valid. */
  void SetWalls(std::span<const SFootprint> walls);
  /**
   * Sets the robots of other engines before the first Plan() of a tick. Robots of this engine stay
   * on their side of a face half-way to each; passive objects are pushed by them.
   * @param tick  s.
   */
  void SetGhosts(std::span<const SGhostDisc> ghosts, Real tick);
  /** See CKinematicWorld::ComputeGhostReach(). */
  Real ComputeGhostReach(Real tick) const;
  /**
   * After Plan(): moves all bodies, and the robots that objects push back.
   * @param discs  after its Plan(), before its Step().
   */
  void Step(CDiscSwarm& discs);
  /** Of all bodies, world frame, and of their images near the seams. */
  std::span<const SFootprint> ListFootprints();
  /** m, of the circle around the origin of any body. */
  Real ComputeWidest() const;
  /** Changes whenever a footprint does. */
  UInt32 GetGeneration() const { return m_generation; }

  SSolid& Get(UInt32 slot) {
    ARGOS_ASSERT(slot < m_solids.size(), "there is no solid in slot " << slot);
    return m_solids[slot];
  }

 private:
  /** An obstacle near a body, which is fixed while the body moves. */
  struct SObstacle {
    SFootprint Footprint;
    bool IsFace = false;  // half-way to a ghost: applies to the circle around the body
    Real Gap = 0.0;  // m, before the body's step
  };

  /** The face that keeps a robot on its side of the gap to a ghost, in a tick. */
  struct SFace {
    SKinematicHandle Robot;
    SFootprint Footprint;
  };

  /** One side of a contact: a footprint of a solid, a disc in the solver, or what does not move. */
  struct SSide {
    UInt32 Footprint = kNone;
    UInt32 Disc = CPushSolver::kNone;  // its number in the solver
    SPlanarVector Image = {};  // displacement of the solid's image that is in contact, m
    SFootprint Place = {};  // if it is no solid: at the start of the tick
  };
  /** A contact in the solver, of which the gap after the motion must be at least the planned one.
   */
  struct SLink {
    UInt32 Contact;  // number in the solver
    SPlanarVector Point;  // in the frame of the pushed footprint, at the start of the tick, m
    SSide Pushing, Pushed;
    Real Planned;  // gap at the end of the tick, m
    Real Tolerance;  // m
    bool IsCorrected = false;  // by the motion, in this tick
  };
  static constexpr UInt32 kNone = std::numeric_limits<UInt32>::max();

  /** A robot that drives against objects. */
  struct SPusher {
    UInt32 Slot;  // of the disc or solid
    bool IsDisc;
    UInt32 Number;  // in the solver
    STwist Back;  // how far others push it back through the objects
  };

  /** A direct push of a body by a robot. */
  struct SPush {
    UInt32 Slot, Robot;  // the robot's slot, plus kSolidRobot if it is not a disc
    friend bool operator==(const SPush&, const SPush&) = default;
    friend bool operator<(const SPush& a, const SPush& b) {
      return std::tie(a.Slot, a.Robot) < std::tie(b.Slot, b.Robot);
    }
  };
  static constexpr UInt32 kSolidRobot = 1U << 31;
  /** A pushed body. */
  struct SMember {
    UInt32 Island;  // of the solver
    UInt32 Slot;
    SPlanarPose Start;
  };

  void FindPushed(const CDiscSwarm& discs);
  void AddFaces(const SGhostDisc& ghost, Real tick);
  void FindGhostOverlaps(UInt32 slot);
  void BuildGrid();
  void ListAll();
  Real ComputeFarthest(const SSolid& solid) const;
  void AddPushesOfDiscs(UInt32 slot, const CDiscSwarm& discs);
  void AddPushesOfSolids(UInt32 slot);
  void AddPushesOfSolid(UInt32 slot, UInt32 number);
  // displacement of the image of a place that is nearest to a body, m
  SPlanarVector FindImage(Real x, Real y, const SSolid& to) const {
    return FindNearestImage(m_period, x, y, to.Pose.X, to.Pose.Y);
  }
  void FindSolidsNear(Real x, Real y, Real reach);
  void AddPush(UInt32 slot, const SSeparation& contact, Real need, UInt32 robot, Real lever,
               const SSide& pushing, UInt32 pushed);
  UInt32 AddToSolver(UInt32 slot);
  UInt32 AddDiscToSolver(UInt32 disc, const CDiscSwarm& discs);
  UInt32 AddRobotToSolver(UInt32 slot);
  bool IsPush(UInt32 slot, UInt32 robot) const;
  void AddNeighbours(UInt32 slot, const CDiscSwarm& discs);
  void AddSolidNeighbour(SSolid& solid, SSolid& other);
  void AddObstacle(const SSolid& solid, const SFootprint& footprint, Real most);
  void AddFace(const SSolid& solid, const SFootprint& face, Real most);
  void AddLink(const CPushSolver::SContact& contact, const SSeparation& found, const SSide& pushing,
               const SSide& pushed);
  void Solve();
  bool Correct(SLink& link);
  SSeparation FindAt(const SLink& link, const STwist& pushing, const STwist& pushed,
                     Real share) const;
  Real ComputeTurnError(const SLink& link, const STwist& pushing, const STwist& pushed) const;
  STwist ComputeTwist(const SSide& side) const;
  STwist ComputeTwist(const SSolid& solid) const;
  SFootprint ComputePlace(const SSide& side, const STwist& twist, Real share) const;
  Real ComputeLeverAtEnd(const SSide& side, const STwist& twist, const SSeparation& contact) const;
  void TakeTwists(const CDiscSwarm& discs);
  void MoveTogether(const CDiscSwarm& discs);
  void MoveIsland(std::span<const SMember> members, const CDiscSwarm& discs);
  bool MovePushed(CDiscSwarm& discs);
  Real PushBack(const SPusher& pusher, CDiscSwarm& discs);
  Real ComputeFreeShare(UInt32 disc, const SPlanarVector& step, const CDiscSwarm& discs);
  void StepDriven(SSolid& solid, const CDiscSwarm& discs);
  void GatherObstacles(const SSolid& solid, Real margin, const CDiscSwarm& discs);
  Real Move(SSolid& solid, const STwist& twist, const CDiscSwarm& discs);
  bool AreFree(std::span<const SMember> members, bool isOnWay, const CDiscSwarm& discs);
  bool IsFree(const SSolid& solid, const SPlanarPose& pose, Real depth, bool allowsOld) const;
  Real ComputeGapTo(const SSolid& solid, const SPlanarPose& pose, const SObstacle& obstacle) const;
  SSolid& Get(const SKinematicHandle& handle) {
    m_generations.Check(handle);
    return m_solids[handle.Slot];
  }
  std::span<const SFootprint> FootprintsOf(const SSolid& solid) const {
    ARGOS_ASSERT(solid.FirstFootprint + solid.NumFootprints <= m_footprints.size() &&
                     &m_solids[m_slotOf[solid.FirstFootprint]] == &solid,
                 "the footprints from number " << solid.FirstFootprint << " are of another body");
    return {m_footprints.data() + solid.FirstFootprint, solid.NumFootprints};
  }
  void Place(SSolid& solid, const SPlanarPose& pose);

  std::vector<SSolid> m_solids;
  CSlotGenerations m_generations;
  std::vector<SFootprint> m_shapes;  // footprints of all, in the frames of their bodies
  std::vector<SFootprint> m_footprints;  // the same, world frame
  std::vector<UInt32> m_slotOf;  // (footprints): of the body
  SPeriodicity m_period;
  std::vector<SFootprint> m_withImages;  // the footprints and their images; only with a period
  size_t m_numDriven = 0;
  UInt32 m_generation = 0;
  // walls by cells, and solids by all cells that they may reach in this tick
  CFramedGrid m_grid;
  size_t m_solidsOfGrid = 0;  // number of solids when it was built
  std::span<const SFootprint> m_walls;
  bool m_wallsChanged = true;
  CCellLists m_wallCells, m_solidCells;
  std::vector<UInt32> m_found;
  // of a tick
  std::vector<SFootprint> m_ghosts;
  CCellLists m_ghostCells;
  std::vector<SFace> m_faces;
  CPushSolver m_solver;
  Real m_farthest = 0.0;  // m; greatest need of a push
  std::vector<UInt32> m_pushed;  // slots of the bodies in the solver
  std::vector<SLink> m_links;
  std::vector<SMember> m_members;  // by island
  std::vector<SPusher> m_pushers;
  std::vector<SPush> m_pushes;  // sorted
  std::vector<UInt32> m_numberOfDisc;  // (discs): in the solver, or kNone
  std::vector<UInt32> m_nearDiscs;  // slots
  std::vector<SObstacle> m_obstacles;
};

}  // namespace argos

#endif
