#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_GRIPS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_GRIPS_H

#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

#include <memory>
#include <vector>

namespace argos {

/** A grip, to be made again in another world. */
struct SRigidGripToMove {
  CDynamics3DModel* Holder;
  CDynamics3DModel* Held;
  CVector3 Arm;  // see CRigidGrips::Grip()
};

/**
 * The grippers and turrets of the robots of a world.
 *
 * While nothing is held, a turret is an angle. What is held hangs on the arm's end by a ball joint.
 * The turret then is a body of its own, on a hinge with a motor, at the centre of mass of its
 * robot, whose mass it shares.
 */
class CRigidGrips {
 public:
  explicit CRigidGrips(dWorldID world);
  ~CRigidGrips();
  CRigidGrips(const CRigidGrips&) = delete;
  CRigidGrips& operator=(const CRigidGrips&) = delete;

  /** Takes over the body's Gripper and Turret, as they are now; without either, forgets it. */
  void SetManipulator(SRigidBody& body);
  /** Lets go of a body, and lets it let go. */
  void ReleaseAllOf(const SRigidBody& body);

  /**
   * Reads what grippers and turrets are to do in this tick, lets go, and takes hold.
   * @param movables  in any order that repeats itself. @param tick s.
   */
  void StartTick(const std::vector<SRigidBody*>& movables, Real tick);
  /** After a substep: lets go what was pulled too hard. */
  void LetSlip();
  /** Tells turrets where they point now. @param tick s. */
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
  bool IsInGrip(const SRigidBody& body) const;
  /** Sets @p cluster to all that hangs together with a body, itself included. */
  void FindCluster(SRigidBody& body, std::vector<SRigidBody*>& cluster) const;
  /** Sets @p grips to those among these bodies. */
  void CopyGrips(const std::vector<SRigidBody*>& cluster,
                 std::vector<SRigidGripToMove>& grips) const;
  /**
   * Lets a robot hold a body, if it holds nothing and has a gripper.
   * @param arm  where its arm ends, and holds whatever is there: frame of the turret or, without
   * one, of the origin, m.
   */
  void Grip(SRigidBody& holder, SRigidBody& held, const CVector3& arm);

 private:
  struct SManipulator {
    SRigidBody* Robot = nullptr;
    Real Rate = 0.0;  // rad/s, at which the motor turns the turret in this tick
    // while it holds something
    SRigidBody* Held = nullptr;
    CVector3 Arm;  // see Grip()
    dJointID Pivot = nullptr;  // null without a turret
    dJointID Hold = nullptr;
    Real RotationAtGrip = 0.0;  // rad
    dJointFeedback Pull{};  // by the arm, in the last substep
    dMass Mass{};  // of the robot's body, without a turret of its own
  };

  SManipulator* Find(const SRigidBody& body) const;
  static void Detach(SManipulator& manipulator);
  static void Release(SManipulator& manipulator);
  void Seek(SManipulator& manipulator, const std::vector<SRigidBody*>& movables);
  void MakeTurret(SManipulator& manipulator);
  static CQuaternion GetArmOrientation(const SManipulator& manipulator, const SRigidPose& pose);

  dWorldID m_world;
  dGeomID m_probe;  // a sphere, in the place of one sensing disc after the other
  std::vector<std::unique_ptr<SManipulator>> m_manipulators;
};

}  // namespace argos

#endif
