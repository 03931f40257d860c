#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_GRIPS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_GRIPS_H

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/physics_engine/described_body_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/active_set.h>

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

  // while it holds a body; not owned
  SPlanarOwner Held;
  SGripPoints Points = {};
  b2Body* Base = nullptr;
  b2Body* TurretBody = nullptr;  // null without a turret
  b2RevoluteJoint* Pivot = nullptr;  // null without a turret
  b2WheelJoint* Hold = nullptr;  // null: it holds nothing

  bool IsHolding() const { return Hold != nullptr; }
  b2Body& GetCarrier() const { return TurretBody != nullptr ? *TurretBody : *Base; }
};

/**
 * The grippers and turrets of the robots of a planar world.
 *
 * While a robot holds nothing, its turret is only an angle. A held body is attached to the turret
 * by a joint: a spring along the arm, of the engine's rigidity, rigid across it, and free to
 * rotate. The turret then has a Box2D body of its own, on a pivot with a motor, and gets half of
 * the mass of its robot: both have their centre on the pivot, so the division of the mass affects
 * only how fast the solver converges.
 */
class CPlanarGrips {
 public:
  CPlanarGrips(CPlanarStore& store, CActiveSet& active) : m_store(store), m_active(active) {}

  /**
   * Gives a robot a gripper and a turret, or removes them (null), as far as the description has
   * them; other bodies have none.
   */
  void SetManipulator(const SPlanarOwner& owner, const SBodyDescription& description,
                      CGripperEquippedEntity* gripper, CTurretEntity* turret);
  /** Releases every grip of a body, and removes its gripper and turret. */
  void Remove(const SPlanarHandle& handle);
  bool HasManipulators() const { return !m_manipulators.empty(); }
  /** Creates the bodies and joints that all grips need, for CPlanarWorld::ReserveForTick(). */
  void CreateSpares(std::vector<b2Body*>& spares);

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
  bool IsHoldingAny() const;
  /** Calls visit(slot, reach in m) for every robot whose gripper seeks a body. */
  template <typename VISIT>
  void ForEachSeeking(VISIT&& visit) const {
    for (const SManipulator& each : m_manipulators) {
      if (IsSeeking(each)) {
        visit(each.Owner.Handle->Slot, ComputeSeekReach(each));
      }
    }
  }
  /** Calls visit(const SManipulator&) for every grip. */
  template <typename VISIT>
  void ForEachHold(VISIT&& visit) const {
    for (const SManipulator& each : m_manipulators) {
      if (each.IsHolding()) {
        visit(each);
      }
    }
  }
  /** Makes grips: locked grippers that hold nothing grip the bodies that they reach. */
  void MakeGrips();

  /** Longest path of a held body in this tick due to a turret's motor, m. */
  Real ComputeLongestSwing() const;
  /** Substeps of a tick in which no held body moves, and no turret turns, too far in one. */
  float ComputeNeededSubsteps() const;
  /** Sets the speed of each turret's motor for a substep. */
  void SetTurretMotors(UInt32 substep, UInt32 substeps);
  /** After positions were corrected: puts each turret at the position of its robot. */
  void AlignTurrets();
  /** Greatest impulse of a grip in the last substep, kg Box2D units / s. */
  float ComputeGreatestImpulse() const;
  /**
   * Writes the rotations of turrets, and breaks the grips whose force in the last substep exceeds
   * the gripper's limit. @param substepDuration s.
   */
  void FinishTick(float substepDuration);

 private:
  SManipulator* Find(const SPlanarHandle& handle);
  bool IsSeeking(const SManipulator& manipulator) const;
  Real ComputeSeekReach(const SManipulator& manipulator) const;
  Real ComputeSwing(const SManipulator& manipulator) const;
  void MakeGrip(SManipulator& manipulator);
  void Attach(SManipulator& manipulator, const SPlanarOwner& held, const SGripPoints& points);
  void CreateTurretBody(SManipulator& manipulator);
  void Release(SManipulator& manipulator);
  void RemoveManipulator(SManipulator& manipulator);

  CPlanarStore& m_store;
  CActiveSet& m_active;
  std::vector<SManipulator> m_manipulators;  // in the order of SetManipulator()
};

}  // namespace argos

#endif
