#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_IMPULSE_BLOCKS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_IMPULSE_BLOCKS_H

#include <argos3/core/utility/math/vector3.h>

#include <array>

namespace argos {

/** A symmetric 3 x 3 matrix: XX, XY, ... are its elements. */
struct SSymmetric3 {
  Real XX = 0.0, YY = 0.0, ZZ = 0.0;
  Real XY = 0.0, XZ = 0.0, YZ = 0.0;

  CVector3 operator*(const CVector3& v) const {
    return CVector3(XX * v.GetX() + XY * v.GetY() + XZ * v.GetZ(),
                    XY * v.GetX() + YY * v.GetY() + YZ * v.GetZ(),
                    XZ * v.GetX() + YZ * v.GetY() + ZZ * v.GetZ());
  }
  SSymmetric3& operator+=(const SSymmetric3& other);
  /** Adds scale v v^T. */
  void AddDyad(const CVector3& v, Real scale);
  /** Adds the moment of inertia of a point. @param arm  from the centre to the point, m. */
  void AddPoint(const CVector3& arm, Real mass);
  /** @return the inverse of a positive definite matrix. */
  SSymmetric3 Inverted() const;
};

/** Two impulses, or speeds, along directions at a right angle. */
struct SPair2 {
  Real X = 0.0, Y = 0.0;
};

/**
 * The friction of one contact: finds the impulse p with |p| <= limit for which the contact sticks,
 * K p = b, or slides against it, K p - b = -s p with s >= 0.
 *
 * K is symmetric and positive definite. It is a trust-region problem: p = (K + s)^-1 b.
 */
SPair2 SolveFriction(Real kxx, Real kxy, Real kyy, const SPair2& b, Real limit);

}  // namespace argos

#endif
