#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_flight.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/simulator/entities/quadrotor_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/body_builder.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/flight_loop.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

constexpr size_t kYaw = 3;

Real ComputeYaw(const CQuaternion& q) {
  return std::atan2(2.0 * (q.GetW() * q.GetZ() + q.GetX() * q.GetY()),
                    1.0 - 2.0 * (q.GetY() * q.GetY() + q.GetZ() * q.GetZ()));
}

Real WrapAngle(Real angle) {
  return CRadians(angle).SignedNormalize().GetValue();
}

// A spring and damper about the horizontal axes, towards upright.
CVector3 ComputeRightingTorque(const SRigidBody& body, const CQuaternion& orientation,
                               const CVector3& turn) {
  const CVector3 up = Rotated(CVector3::Z, orientation);
  CVector3 axis = Cross(up, CVector3::Z);
  const Real sine = axis.Length();
  CVector3 tilt;
  if (sine > 1e-12) {
    tilt = axis * (std::atan2(sine, up.GetZ()) / sine);
  } else if (up.GetZ() < 0.0) {
    // upside down: turn over one side
    tilt = Rotated(CVector3::X, orientation) * ARGOS_PI;
  }
  const CVector3 sideways(turn.GetX(), turn.GetY(), 0.0);
  CVector3 torque = tilt * body.TiltGains.GetX() - sideways * body.TiltGains.GetY();
  const Real length = torque.Length();
  const Real most = body.TiltGains.GetZ();
  return length > most ? torque * (most / length) : torque;
}

// A kinematic body keeps its velocity whatever pushes it.
void Hold(SRigidBody& body) {
  dBodySetKinematic(body.Body);
  dBodySetLinearVel(body.Body, 0.0, 0.0, 0.0);
  dBodySetAngularVel(body.Body, 0.0, 0.0, 0.0);
}

}  // namespace

void PushFlyingBody(SRigidBody& body, const CVector3& gravity, Real substep,
                    const CVector3& origin) {
  const SBodyDescription& description = *body.Source.Description;
  const SPropellersDescription& propellers = *description.Propellers;
  const CQuadRotorEntity& quadrotor = *body.Source.Quadrotor;
  if (quadrotor.IsAttached()) {
    Hold(body);
    return;
  }
  if (dBodyIsKinematic(body.Body) != 0) {
    dBodySetDynamic(body.Body);
  }
  const SRigidPose pose = GetRigidPose(body);
  const CVector3 velocity = FromODE(dBodyGetLinearVel(body.Body));
  const CVector3 turn = FromODE(dBodyGetAngularVel(body.Body));
  const Real mass = description.Mass;
  const Real inertia = description.GetPlanarInertia();
  const bool onPlace = quadrotor.GetControlMethod() == CQuadRotorEntity::POSITION_CONTROL;

  std::array<Real, 4> wanted{};
  if (onPlace) {
    const auto& target = quadrotor.GetPositionControlData();
    const SSubstepGains gains = ComputePositionGains(propellers.Position, mass, substep);
    for (UInt32 i = 0; i < kYaw; ++i) {
      const Real place = target.Position[i] - origin[i];
      wanted[i] = gains.Error * (place - pose.Position[i]) - gains.Speed * velocity[i];
    }
    const SSubstepGains yawGains = ComputePositionGains(propellers.Yaw, inertia, substep);
    const Real yaw = WrapAngle(target.Yaw.GetValue() - ComputeYaw(pose.Orientation));
    wanted[kYaw] = yawGains.Error * yaw - yawGains.Speed * turn.GetZ();
  } else {
    const auto& target = quadrotor.GetSpeedControlData();
    const SSubstepGains gains = ComputeSpeedGains(propellers.Velocity, mass, substep);
    for (UInt32 i = 0; i < kYaw; ++i) {
      wanted[i] = gains.Error * (target.Velocity[i] - velocity[i]);
    }
    wanted[kYaw] = ComputeSpeedGains(propellers.YawRate, inertia, substep).Error *
                   (target.RotSpeed.GetValue() - turn.GetZ());
  }

  std::array<Real, 4> thrust{};
  for (UInt32 i = 0; i < kYaw; ++i) {
    thrust[i] = ComputeThrust(wanted[i], mass * gravity[i], propellers.MaxForce);
  }
  thrust[kYaw] = ComputeThrust(wanted[kYaw], 0.0, propellers.MaxTorque);
  const CVector3 righting = ComputeRightingTorque(body, pose.Orientation, turn);
  dBodyAddForce(body.Body, thrust[0], thrust[1], thrust[2]);
  dBodyAddTorque(body.Body, righting.GetX(), righting.GetY(), thrust[kYaw]);
}

}  // namespace argos
