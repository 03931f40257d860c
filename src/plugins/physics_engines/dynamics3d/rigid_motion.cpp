#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_motion.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_mass.h>

#include <cmath>

namespace argos {

namespace {

SSymmetric3 InertiaOf(const dMass& mass) {
  return {mass.I[0], mass.I[5], mass.I[10], mass.I[1], mass.I[2], mass.I[6]};
}

// A sphere that spins about one axis with its own speed: its moment about the other two.
SSymmetric3 InertiaOfRotor(Real inertia, const CVector3& axis) {
  SSymmetric3 sum{inertia, inertia, inertia};
  sum.AddDyad(axis, -inertia);
  return sum;
}

CVector3 InBody(const dReal* r, const CVector3& v) {
  return CVector3(r[0] * v.GetX() + r[4] * v.GetY() + r[8] * v.GetZ(),
                  r[1] * v.GetX() + r[5] * v.GetY() + r[9] * v.GetZ(),
                  r[2] * v.GetX() + r[6] * v.GetY() + r[10] * v.GetZ());
}

}  // namespace

SJointMass AddUpParts(const SRigidBody& body) {
  dMass main;
  dBodyGetMass(body.Body, &main);
  SJointMass sum{main.mass, CVector3(), InertiaOf(main)};
  if (body.TurretBody != nullptr) {
    dMass turret;
    dBodyGetMass(body.TurretBody, &turret);
    sum.Mass += turret.mass;
    sum.Inertia += InertiaOfRotor(turret.I[0], CVector3::Z);
  }
  if (body.HasWheels()) {
    dMass wheel;
    dBodyGetMass(body.Wheels[0], &wheel);
    const Real others = sum.Mass;
    sum.Mass += 2.0 * wheel.mass;
    sum.Offset = (body.Rollers[0].Offset + body.Rollers[1].Offset) * (wheel.mass / sum.Mass);
    sum.Inertia.AddPoint(sum.Offset, others);
    for (size_t i = 0; i < body.Wheels.size(); ++i) {
      sum.Inertia.AddPoint(body.Rollers[i].Offset - sum.Offset, wheel.mass);
      sum.Inertia += InertiaOfRotor(wheel.I[0], CVector3::Y);
    }
  }
  return sum;
}

CVector3 InWorld(const dReal* r, const CVector3& v) {
  return CVector3(r[0] * v.GetX() + r[1] * v.GetY() + r[2] * v.GetZ(),
                  r[4] * v.GetX() + r[5] * v.GetY() + r[6] * v.GetZ(),
                  r[8] * v.GetX() + r[9] * v.GetY() + r[10] * v.GetZ());
}

SSymmetric3 InWorld(const dReal* rotation, const SSymmetric3& matrix) {
  // R M R^T, by columns of M R^T
  const auto column = [&](UInt32 row) {
    return InWorld(rotation, matrix * CVector3(rotation[4 * row], rotation[4 * row + 1],
                                               rotation[4 * row + 2]));
  };
  const CVector3 x = column(0);
  const CVector3 y = column(1);
  const CVector3 z = column(2);
  return {x.GetX(), y.GetY(), z.GetZ(), x.GetY(), x.GetZ(), y.GetZ()};
}

CVector3 TurnFreely(const CVector3& turn, const dReal* rotation, const SSymmetric3& inertia,
                    Real duration) {
  const CVector3 w = InBody(rotation, turn);
  const CVector3 momentum = inertia * w;
  const CVector3 error = Cross(w, momentum) * duration;
  if (error.SquareLength() == 0.0) {
    return turn;
  }
  // columns of I + h ([w] I - [I w])
  const auto column = [&](const CVector3& axis) {
    const CVector3 own = inertia * axis;
    return own + (Cross(w, own) - Cross(momentum, axis)) * duration;
  };
  const CVector3 x = column(CVector3::X);
  const CVector3 y = column(CVector3::Y);
  const CVector3 z = column(CVector3::Z);
  const CVector3 yz = Cross(y, z);
  const Real determinant = x.DotProduct(yz);
  // Cramer's rule
  const CVector3 change(error.DotProduct(yz), x.DotProduct(Cross(error, z)),
                        x.DotProduct(Cross(y, error)));
  return InWorld(rotation, w - change / determinant);
}

CQuaternion Rotate(const CQuaternion& orientation, const CVector3& angle) {
  const Real length = angle.Length();
  if (length == 0.0) {
    return orientation;
  }
  const CVector3 axis = angle * (std::sin(0.5 * length) / length);
  return CQuaternion(std::cos(0.5 * length), axis.GetX(), axis.GetY(), axis.GetZ()) * orientation;
}

void PutOrientation(dBodyID part, const CQuaternion& orientation) {
  const dQuaternion quaternion = {orientation.GetW(), orientation.GetX(), orientation.GetY(),
                                  orientation.GetZ()};
  dBodySetQuaternion(part, quaternion);
}

void PutMotion(dBodyID part, const CVector3& position, const CVector3& velocity,
               const CVector3& turn) {
  dBodySetPosition(part, position.GetX(), position.GetY(), position.GetZ());
  dBodySetLinearVel(part, velocity.GetX(), velocity.GetY(), velocity.GetZ());
  dBodySetAngularVel(part, turn.GetX(), turn.GetY(), turn.GetZ());
  dBodySetForce(part, 0.0, 0.0, 0.0);
  dBodySetTorque(part, 0.0, 0.0, 0.0);
}

}  // namespace argos
