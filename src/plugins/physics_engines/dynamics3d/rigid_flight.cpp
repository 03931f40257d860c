#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_flight.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/physics_engine/flight_loop.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/simulator/entities/quadrotor_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/body_builder.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

constexpr size_t kYaw = 3;

// The inputs of the controllers of an axis in a substep.
struct SOrder {
  Real Error = 0.0;  // of the position (m or rad) or of the speed
  SControlGains Gains;  // the derivative for a change of the error in a substep
};

SOrder OrderPlace(Real error, const SControlGains& gains, Real substep) {
  return {error, {gains.Proportional, gains.Derivative / substep}};
}

SOrder OrderSpeed(Real error, const SControlGains& gains, Real inertia) {
  return {error, {ComputeSpeedGain(gains, inertia), 0.0}};
}

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
  body.FlightErrors = {};
}

}  // namespace

void PushFlyingBody(SRigidBody& body, const CVector3& gravity, Real substep) {
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
  const Real inertia = description.GetPlanarInertia();
  const bool onPlace = quadrotor.GetControlMethod() == CQuadRotorEntity::POSITION_CONTROL;

  std::array<SOrder, 4> orders;
  if (onPlace) {
    const auto& target = quadrotor.GetPositionControlData();
    for (UInt32 i = 0; i < kYaw; ++i) {
      orders[i] = OrderPlace(target.Position[i] - pose.Position[i], propellers.Position, substep);
    }
    const Real yaw = WrapAngle(target.Yaw.GetValue() - ComputeYaw(pose.Orientation));
    orders[kYaw] = OrderPlace(yaw, propellers.Yaw, substep);
  } else {
    const auto& target = quadrotor.GetSpeedControlData();
    for (UInt32 i = 0; i < kYaw; ++i) {
      orders[i] =
          OrderSpeed(target.Velocity[i] - velocity[i], propellers.Velocity, description.Mass);
    }
    orders[kYaw] =
        OrderSpeed(target.RotSpeed.GetValue() - turn.GetZ(), propellers.YawRate, inertia);
  }

  std::array<Real, 4> thrust{};
  for (UInt32 i = 0; i < orders.size(); ++i) {
    const SOrder& order = orders[i];
    Real change = order.Error - body.FlightErrors[i];
    change = i == kYaw ? WrapAngle(change) : change;
    thrust[i] = ComputeThrust(order.Gains.Proportional, order.Gains.Derivative, order.Error, change,
                              i == kYaw ? 0.0 : description.Mass * gravity[i],
                              i == kYaw ? propellers.MaxTorque : propellers.MaxForce);
    body.FlightErrors[i] = onPlace ? order.Error : 0.0;
  }
  const CVector3 righting = ComputeRightingTorque(body, pose.Orientation, turn);
  dBodyAddForce(body.Body, thrust[0], thrust[1], thrust[2]);
  dBodyAddTorque(body.Body, righting.GetX(), righting.GetY(), thrust[kYaw]);
}

}  // namespace argos
