#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_GRIPS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_GRIPS_H

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/physics_engine/described_body_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_store.h>

#include <optional>
#include <vector>

namespace argos {

class CGripperEquippedEntity;
class CTurretEntity;

/**
 * The two ends of a grip, m: the end of the gripper's arm on the turret (or, without one, on the
 * holder), and the same point on the held body.
 */
struct SGripPoints {
  Real ArmX, ArmY;
  Real HeldX, HeldY;
};

/** The gripper and the turret of a robot, and what it holds. */
struct SManipulator {
  SPlanarOwner Owner;
  CGripperEquippedEntity* Gripper = nullptr;  // null if it has none
  CTurretEntity* Turret = nullptr;  // null if it has none
  SGripperDescription Limits;  // the component has the position of the gripper
  std::optional<STurretDescription> TurretLimits;

  Real Rotation = 0.0;  // rad, of the turret on the body
  Real Rate = 0.0;  // rad/s, of the turret's motor in this tick
  bool IsMotorOn = false;  // in this tick
  Real Target = 0.0;  // rad: target rotation of the motor in this tick

  // while it holds a body
  SPlanarOwner Held;
  SGripPoints Points = {};
  float ArmRate = 0.0F;  // rad/s, of the turret, in the world
  float Along = 0.0F, Across = 0.0F, Torque = 0.0F;  // see SCrowdGrip

  bool IsHolding() const { return Held.Body != nullptr; }
};

/**
 * The grippers and turrets of the robots of a planar world.
 *
 * While a robot holds nothing, its turret is only an angle. A held body is attached to the turret
 * by a grip of the crowd (SCrowdGrip): a spring along the arm, of the engine's rigidity, rigid
 * across it, and free to rotate. The turret then turns with an inertia of its own; its mass is
 * always part of its robot's.
 */
class CPlanarGrips {
 public:
  explicit CPlanarGrips(CPlanarStore& store) : m_store(store) {}

  /**
   * Gives a robot a gripper and a turret, or removes them (null), as far as the description has
   * them; other bodies have none.
   */
  void SetManipulator(const SPlanarOwner& owner, const SBodyDescription& description,
                      CGripperEquippedEntity* gripper, CTurretEntity* turret);
  /** Releases every grip of a body, and removes its gripper and turret. */
  void Remove(const SPlanarHandle& handle);
  bool HasManipulators() const { return !m_manipulators.empty(); }
  size_t GetNumManipulators() const { return m_manipulators.size(); }

  /** @return true if the body takes part in a grip. */
  bool IsInGrip(const SPlanarHandle& handle) const;
  /** Sets @p cluster to all bodies that are connected to a body by grips, itself included. */
  void FindCluster(const CEmbodiedEntity& body, std::vector<CEmbodiedEntity*>& cluster) const;
  /** Sets @p grips to those whose holder is in @p cluster. */
  void CopyGrips(const std::vector<CEmbodiedEntity*>& cluster,
                 std::vector<SGripTransfer>& grips) const;
  /** Restores a grip after both bodies were added. */
  void RestoreGrip(const SGripTransfer& grip, const SPlanarHandle& holder,
                   const SPlanarHandle& held);

  /** Reads the commands of grippers and turrets for this tick, and releases grips. */
  void StartTick();
  /** @return true if a gripper holds a body. */
  bool IsHoldingAny() const { return m_numHolds > 0; }
  /** Calls visit(const SManipulator&) for every grip. */
  template <typename VISIT>
  void ForEachHold(VISIT&& visit) const {
    if (!IsHoldingAny()) {
      return;
    }
    for (const SManipulator& each : m_manipulators) {
      if (each.IsHolding()) {
        visit(each);
      }
    }
  }
  /**
   * Makes grips: locked grippers that hold nothing grip the bodies that they reach.
   * @param solids  of this tick.
   */
  void MakeGrips(const CDiscPairs& discPairs, CCrowdSolids& solids);
  /** Adds all grips to the crowd of this tick. */
  void AddTo(CDiscPairs& discPairs, CCrowd& crowd) const;

  /** Longest path of a body in this tick due to a grip, m. */
  Real ComputeLongestPath() const;
  /**
   * Writes the rotations of turrets, and breaks the grips whose force in the last substep exceeds
   * the gripper's limit. @param grips  those of AddTo(), after the tick.
   */
  void FinishTick(const std::vector<SCrowdGrip>& grips);

 private:
  SManipulator* Find(const SPlanarHandle& handle);
  bool IsSeeking(const SManipulator& manipulator) const;
  Real ComputeReach(const SManipulator& manipulator) const;
  Real ComputeNeededSubsteps(const SManipulator& manipulator, Real rate) const;
  void MakeGrip(SManipulator& manipulator, const CDiscPairs& discPairs, CCrowdSolids& solids);
  UInt32 FindItem(const CDiscPairs& discPairs, const CCrowdSolids& solids,
                  const SPlanarHandle& handle) const;
  SCrowdGrip Describe(const SManipulator& manipulator) const;
  void Attach(SManipulator& manipulator, const SPlanarOwner& held, const SGripPoints& points);
  void Release(SManipulator& manipulator);
  void RemoveManipulator(SManipulator& manipulator);

  CPlanarStore& m_store;
  UInt32 m_numHolds = 0;
  std::vector<SManipulator> m_manipulators;  // in the order of SetManipulator()
};

}  // namespace argos

#endif
