#include <argos3/plugins/simulator/physics_engines/dynamics3d/impulse_blocks.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// steps of Newton's method: it converges quadratically from below
constexpr int kMaxSteps = 20;
constexpr Real kRounding = 1e-9;  // the square of it is left after a step
// share by which both directions may differ where friction is opposite to what it must stop: balls
constexpr Real kAlike = 1e-9;

}  // namespace

SSymmetric3& SSymmetric3::operator+=(const SSymmetric3& other) {
  XX += other.XX;
  YY += other.YY;
  ZZ += other.ZZ;
  XY += other.XY;
  XZ += other.XZ;
  YZ += other.YZ;
  return *this;
}

void SSymmetric3::AddDyad(const CVector3& v, Real scale) {
  XX += scale * v.GetX() * v.GetX();
  YY += scale * v.GetY() * v.GetY();
  ZZ += scale * v.GetZ() * v.GetZ();
  XY += scale * v.GetX() * v.GetY();
  XZ += scale * v.GetX() * v.GetZ();
  YZ += scale * v.GetY() * v.GetZ();
}

void SSymmetric3::AddPoint(const CVector3& arm, Real mass) {
  const Real square = mass * arm.SquareLength();
  XX += square;
  YY += square;
  ZZ += square;
  AddDyad(arm, -mass);
}

SSymmetric3 SSymmetric3::Inverted() const {
  SSymmetric3 adjugate;
  adjugate.XX = YY * ZZ - YZ * YZ;
  adjugate.YY = XX * ZZ - XZ * XZ;
  adjugate.ZZ = XX * YY - XY * XY;
  adjugate.XY = XZ * YZ - XY * ZZ;
  adjugate.XZ = XY * YZ - XZ * YY;
  adjugate.YZ = XY * XZ - XX * YZ;
  const Real scale = 1.0 / (XX * adjugate.XX + XY * adjugate.XY + XZ * adjugate.XZ);
  for (Real* element :
       {&adjugate.XX, &adjugate.YY, &adjugate.ZZ, &adjugate.XY, &adjugate.XZ, &adjugate.YZ}) {
    *element *= scale;
  }
  return adjugate;
}

SPair2 SolveFriction(Real kxx, Real kxy, Real kyy, const SPair2& b, Real limit) {
  if (!(limit > 0.0)) {
    return {};
  }
  const auto solve = [&](Real shift) {
    const Real xx = kxx + shift;
    const Real yy = kyy + shift;
    const Real scale = 1.0 / (xx * yy - kxy * kxy);
    return SPair2{scale * (yy * b.X - kxy * b.Y), scale * (xx * b.Y - kxy * b.X)};
  };
  SPair2 p = solve(0.0);
  const Real square = p.X * p.X + p.Y * p.Y;
  if (square <= limit * limit) {
    return p;
  }
  Real length = std::sqrt(square);
  if (std::abs(kxx - kyy) + std::abs(kxy) < kAlike * kxx) {
    return {p.X * limit / length, p.Y * limit / length};
  }
  // Newton's method for 1 / |p(s)| = 1 / limit, which is nearly linear in s
  Real shift = 0.0;
  for (int i = 0; i < kMaxSteps && length > limit * (1.0 + kRounding); ++i) {
    const Real xx = kxx + shift;
    const Real yy = kyy + shift;
    const Real scale = 1.0 / (xx * yy - kxy * kxy);
    // p^T (K + s)^-1 p = -|p| d|p| / ds
    const Real bent = scale * (yy * p.X * p.X - 2.0 * kxy * p.X * p.Y + xx * p.Y * p.Y);
    shift += (length * length / bent) * (length - limit) / limit;
    p = solve(shift);
    length = std::sqrt(p.X * p.X + p.Y * p.Y);
  }
  const Real rest = limit / length;
  return {p.X * rest, p.Y * rest};
}

}  // namespace argos
