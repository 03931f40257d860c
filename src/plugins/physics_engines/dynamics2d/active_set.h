#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_ACTIVE_SET_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_ACTIVE_SET_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_store.h>

#include <vector>

namespace argos {

/** The data that a robot has only while it is active. */
struct SActiveBody {
  UInt32 Slot = 0;
  b2Body* Body = nullptr;
  b2MotorJoint* Motor = nullptr;
  float StepX = 0.0F, StepY = 0.0F;  // the step of the tick that its wheels command, Box2D units
  float StepAngle = 0.0F;  // rad in the tick
  float StartAngle = 0.0F;  // of the Box2D body at the tick's start, rad
  Real StartYaw = 0.0;  // rad
  float SpentImpulse = 0.0F;  // of the drive in this tick, Box2D units
  float SpentAngularImpulse = 0.0F;
  b2Vec2 Pull = b2Vec2_zero;  // impulse of the drive in the last tick, Box2D units
  float MostImpulse = 0.0F;  // of the drive in this substep, Box2D units
  float MostAngularImpulse = 0.0F;
  // what the solver has left of the way so far, although the drive could have covered it: Box2D
  // units, rad
  b2Vec2 Behind = b2Vec2_zero;
  float BehindAngle = 0.0F;
};

/**
 * The movable bodies that Box2D moves: those in a cluster that CCrowd leaves to it, with a grip.
 *
 * A robot has a Box2D body only then; that of an object is enabled only then. A motor of bounded
 * force drives the Box2D body of a robot along the chord of its arc. If Box2D has moved a robot to
 * the end of its planned arc, within some roundings, then nothing pushed it, and it gets the exact
 * pose; else it gets Box2D's.
 */
class CActiveSet {
 public:
  explicit CActiveSet(CPlanarStore& store) : m_store(store) {}

  /** Allocates for so many active robots among so many robots. */
  void Reserve(size_t active, size_t robots) {
    m_bodies.reserve(active);
    m_isWanted.reserve(robots);
  }
  const std::vector<SActiveBody>& GetBodies() const { return m_bodies; }

  /** Gives an inactive robot a Box2D body. */
  void Activate(UInt32 slot);
  /** Enables the Box2D body of an object, if it is not, at its present pose. */
  void Activate(SPassiveBody& body);
  /** Removes the Box2D body of an active robot. */
  void Deactivate(UInt32 slot);
  /** Activates the bodies of excluded clusters, and deactivates the others. */
  void Select(const CDiscPairs& discPairs, CCrowd& crowd);
  /** To be called if another robot has got the slot of a removed one. */
  void UpdateSlot(UInt32 slot);
  /** The robot of one of GetBodies(). */
  SDrivenBody& GetRobot(const SActiveBody& active) const {
    SDrivenBody& robot = m_store.GetDriven(active.Slot);
    ARGOS_ASSERT(robot.IsActive() && &At(robot.ActiveNumber) == &active,
                 "the robot in slot " << active.Slot << " is not the one that was active there");
    return robot;
  }
  /** The Box2D body of an active robot or a passive body. */
  b2Body& GetBox2DBody(const SPlanarHandle& handle) const;
  /** Sets the velocity of a movable body, also in Box2D. */
  void SetVelocity(const SPlanarHandle& handle, const SPlanarVelocity& velocity);

  /** Reads the wheels, and plans the steps of this tick. */
  void StartTick();
  /** Sets the target of each motor, and its greatest force, for a substep. */
  void SetMotors(UInt32 substep, UInt32 substeps);
  /** After a substep, and corrections of overlaps: adds up the impulses of the motors. */
  void AccountMotors();
  /** Takes Box2D's result where it differs from the plan. */
  void FinishTick(UInt32 substeps);

  /** Substeps of a tick in which no active robot moves or turns too far in one. */
  float ComputeNeededSubsteps() const;
  /** Smallest product of drive force, radius and mass of the active robots, (N s)^2. */
  Real ComputeWeakestDrive() const;

 private:
  const SActiveBody& At(UInt32 number) const {
    ARGOS_ASSERT(number < m_bodies.size(), "there is no active robot with the number " << number);
    return m_bodies[number];
  }
  void StartTick(SActiveBody& active);
  void SetMotor(SActiveBody& active, UInt32 substep, UInt32 substeps);
  void AccountMotor(SActiveBody& active) const;
  void FinishTick(const SActiveBody& active, UInt32 substeps);
  void SelectPassive(CCrowd& crowd);

  CPlanarStore& m_store;
  std::vector<SActiveBody> m_bodies;
  std::vector<UInt8> m_isWanted;  // by slot; scratch of Select()
};

}  // namespace argos

#endif
