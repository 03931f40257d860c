#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_GRIPS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_GRIPS_H

#include <argos3/core/simulator/physics_engine/body_description.h>
#include <argos3/core/simulator/physics_engine/described_body_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_bodies.h>

#include <box2d/box2d.h>

#include <optional>
#include <vector>

namespace argos {

class CGripperEquippedEntity;
class CTurretEntity;

/**
 * What holds a body: where the gripper's arm, which ends where the held body was touched, is on the
 * turret (or, without one, on the body), and where that point is on the held body; m.
 */
struct SGripPoints {
  Real ArmX, ArmY;
  Real HeldX, HeldY;
};

/**
 * The gripper and the turret of a driven body.
 *
 * While nothing is held, a turret is an angle. What is held hangs on a joint with the turret: a
 * spring along the arm, of the engine's rigidity, rigid across it, and free to swivel. The turret
 * then has a Box2D body of its own, on a pivot with a motor, and takes over half of the mass of its
 * robot: both have their centre on the pivot, so how the mass is divided changes nothing but how
 * fast the solver converges.
 */
struct SManipulator {
  SPlanarOwner Owner;
  CGripperEquippedEntity* Gripper = nullptr;  // null if it has none
  CTurretEntity* Turret = nullptr;  // null if it has none
  SGripperDescription Limits;  // where the gripper is, only the component knows
  std::optional<STurretDescription> TurretLimits;

  Real Rotation = 0.0;  // rad, of the turret on the body
  Real Rate = 0.0;  // rad/s, at which its motor turns it in this tick
  bool IsMotorOn = false;  // in this tick
  Real Target = 0.0;  // rad: where the motor turns it to in this tick

  // while it holds something; not owned
  SPlanarOwner Held;
  SGripPoints Points = {};
  b2Body* Base = nullptr;
  b2Body* TurretBody = nullptr;  // null without a turret
  b2RevoluteJoint* Pivot = nullptr;  // null without a turret
  b2WheelJoint* Hold = nullptr;  // null: it holds nothing

  bool IsHolding() const { return Hold != nullptr; }
  b2Body& GetCarrier() const { return TurretBody != nullptr ? *TurretBody : *Base; }
};

/** A place on a body that a gripper can reach. */
struct SGripPlace {
  b2Body* Body = nullptr;  // null: there is none
  b2Vec2 Point = b2Vec2_zero;  // world frame, Box2D units
};

/**
 * Finds what a gripper reaches: of all bodies in the disc, the one with the point nearest to the
 * centre; of equally near ones, that of the entity with the lowest index. The point is the nearest
 * one of the described solids, or the centre if that is inside one.
 * @param radius     Box2D units.
 * @param grippable  by number of body: whose it is; of those that cannot be gripped, nobody's.
 * @param own        the gripper's own body.
 */
SGripPlace FindGripPlace(const b2World& world, const b2Vec2& centre, float radius,
                         const std::vector<SPlanarOwner>& grippable, const b2Body& own);

}  // namespace argos

#endif
