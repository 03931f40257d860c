#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_GRIPS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_GRIPS_H

#include <argos3/core/simulator/physics_engine/described_body_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

#include <memory>
#include <vector>

namespace argos {

/**
 * The grippers and turrets of the robots of a world.
 *
 * While a robot holds nothing, its turret is only an angle. A held body is attached to the end of
 * the arm by a ball joint. The turret is then a body of its own, on a hinge with a motor, at the
 * centre of mass of its robot, whose mass it shares.
 */
class CRigidGrips {
 public:
  /** The joints of a grip. */
  struct SHold {
    SRigidBody* Robot = nullptr;
    SRigidBody* Held = nullptr;  // null: the rest is unset
    dJointID Pivot = nullptr;  // null without a turret
    dJointID Hold = nullptr;
    dJointFeedback Pull{};  // force of the arm in the last substep
    CVector3 Force;  // N, of the joint on the robot; torque of the motor, N m: in the last substep
    Real Torque = 0.0;
  };

  explicit CRigidGrips(dWorldID world);
  ~CRigidGrips();
  CRigidGrips(const CRigidGrips&) = delete;
  CRigidGrips& operator=(const CRigidGrips&) = delete;

  /** Reads the body's present Gripper and Turret; a body without either is no longer tracked. */
  void SetManipulator(SRigidBody& body);
  /** Releases every grip in which the body takes part. */
  void ReleaseAllOf(const SRigidBody& body);

  /**
   * Reads the commands of grippers and turrets for this tick, releases and makes grips.
   * @param movables  in a deterministic order. @param tick s.
   */
  void StartTick(const std::vector<SRigidBody*>& movables, Real tick);
  /** After a substep: releases the grips whose force exceeds the gripper's limit. */
  void BreakOverloadedGrips();
  /** Writes the present rotation of turrets. @param tick s. */
  void EndTick(Real tick);

  /** Calls visit(SRigidBody& holder, SRigidBody& held) for every grip. */
  template <typename VISIT>
  void ForEachGrip(VISIT&& visit) const {
    for (const auto& each : m_manipulators) {
      if (each->Held != nullptr) {
        visit(*each->Robot, *each->Held);
      }
    }
  }
  /** Calls visit(SHold&) for every grip. */
  template <typename VISIT>
  void ForEachHold(VISIT&& visit) {
    for (const auto& each : m_manipulators) {
      if (each->Held != nullptr) {
        visit(static_cast<SHold&>(*each));
      }
    }
  }
  /** Sets @p cluster to all bodies that are connected to a body by grips, itself included. */
  void FindCluster(CEmbodiedEntity& body, std::vector<CEmbodiedEntity*>& cluster) const;
  /** Sets @p grips to those whose holder is in @p cluster. */
  void CopyGrips(const std::vector<CEmbodiedEntity*>& cluster,
                 std::vector<SGripTransfer>& grips) const;
  /**
   * Makes a robot hold a body, if it holds nothing and has a gripper.
   * @param arm  end of the robot's arm, where it is attached to the body: frame of the turret or,
   * without one, of the origin, m.
   */
  void Grip(SRigidBody& holder, SRigidBody& held, const CVector3& arm);

 private:
  struct SManipulator : SHold {
    Real Rate = 0.0;  // rad/s, of the turret's motor in this tick
    // while it holds a body
    CVector3 Arm;  // see Grip()
    Real RotationAtGrip = 0.0;  // rad
    dMass Mass{};  // of the robot's body, without a turret of its own
  };

  SManipulator* Find(const SRigidBody& body) const;
  static void Detach(SManipulator& manipulator);
  static void Release(SManipulator& manipulator);
  void Seek(SManipulator& manipulator, const std::vector<SRigidBody*>& movables);
  void MakeTurret(SManipulator& manipulator);
  static CQuaternion GetArmOrientation(const SManipulator& manipulator, const SRigidPose& pose);

  dWorldID m_world;
  dGeomID m_probe;  // a sphere, moved to one sensing disc after the other
  std::vector<std::unique_ptr<SManipulator>> m_manipulators;
};

}  // namespace argos

#endif
