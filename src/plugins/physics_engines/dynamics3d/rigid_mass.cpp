#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_mass.h>

#include <argos3/core/simulator/geometry/body_description.h>

#include <vector>

namespace argos {

namespace {

using EKind = SShapeDescription::EKind;

// in the frame of the solid's centroid
dMass MakeMass(const SShapeDescription& shape, Real mass) {
  dMass result;
  switch (shape.Kind) {
    case EKind::Box:
      dMassSetBoxTotal(&result, mass, shape.Size.GetX(), shape.Size.GetY(), shape.Size.GetZ());
      break;
    case EKind::Cylinder:
      dMassSetCylinderTotal(&result, mass, 3, shape.Radius, shape.Size.GetZ());
      break;
    case EKind::Sphere:
      dMassSetSphereTotal(&result, mass, shape.Radius);
      break;
    case EKind::Prism:
    case EKind::Hull: {
      const SUnitInertia unit = ComputeUnitInertia(shape);
      dMassSetParameters(&result, mass, 0.0, 0.0, 0.0, mass * unit.XX, mass * unit.YY,
                         mass * unit.ZZ, -mass * unit.XY, -mass * unit.XZ, -mass * unit.YZ);
      break;
    }
  }
  return result;
}

}  // namespace

void ToODE(const CQuaternion& quaternion, dQuaternion result) {
  const Real length = quaternion.Length();
  result[0] = quaternion.GetW() / length;
  result[1] = quaternion.GetX() / length;
  result[2] = quaternion.GetY() / length;
  result[3] = quaternion.GetZ() / length;
}

dMass AddUpSolids(const SBodyDescription& description, Real mass, UInt32 link) {
  const std::vector<Real> weights = description.ComputeWeights();
  Real total = 0.0;
  for (const Real weight : weights) {
    total += weight;
  }
  dMass sum;
  dMassSetZero(&sum);
  for (size_t i = 0; i < weights.size(); ++i) {
    const SShapeDescription& shape = description.Shapes[i];
    if (shape.Link != link) {
      continue;
    }
    dMass part = MakeMass(shape, mass * weights[i] / total);
    dQuaternion orientation;
    dMatrix3 rotation;
    ToODE(shape.Orientation, orientation);
    dRfromQ(rotation, orientation);
    dMassRotate(&part, rotation);
    const CVector3 centre = shape.ComputeCentroid();
    dMassTranslate(&part, centre.GetX(), centre.GetY(), centre.GetZ());
    dMassAdd(&sum, &part);
  }
  return sum;
}

CVector3 CentreMass(dMass& mass) {
  const CVector3 centre(mass.c[0], mass.c[1], mass.c[2]);
  dMassTranslate(&mass, -mass.c[0], -mass.c[1], -mass.c[2]);
  // rounding errors of zero
  mass.c[0] = mass.c[1] = mass.c[2] = 0.0;
  return centre;
}

}  // namespace argos
