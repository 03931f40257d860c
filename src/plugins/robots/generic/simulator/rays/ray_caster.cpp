#include <argos3/plugins/robots/generic/simulator/ray_caster.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/robots/generic/simulator/disc_entries.h>
#include <argos3/plugins/robots/generic/simulator/planar_rays.h>

#include <algorithm>
#include <cmath>

namespace argos {

void CRayCaster::SetRobot(CComposableEntity& robot) {
  m_body = &robot.GetComponent<CEmbodiedEntity>("body");
  m_robot = &robot.GetComponent<CControllableEntity>("controller");
  m_space = &m_robot->GetSpace();
}

void CRayCaster::Cast(const SRayBundle& bundle, Real* fractions) const {
  std::fill_n(fractions, bundle.Count, kNoHit);
  const CQuaternion& orientation = bundle.FirstAnchor.Orientation;
  const bool upright = orientation.GetX() == 0.0 && orientation.GetY() == 0.0;
  if (bundle.Bounds.Planar && upright && !AreBodiesOutsideIndex()) {
    CastUpright(bundle, fractions);
  } else {
    CastOneByOne(bundle, fractions);
  }
}

// horizontal rays, m, world frame; nothing is initialised before Set()
struct CRayCaster::SWorldRays : SPlanarRays<kMaxRays> {
  Real Z[kMaxRays];
  Real MinZ, MaxZ;
  bool HaveLengths;

  void Set(const SRayBundle& bundle, const CVector3& position, Real cosine, Real sine) {
    SetCenter(position.GetX(), position.GetY());
    MinZ = HUGE_VAL;
    MaxZ = -HUGE_VAL;
    HaveLengths = true;
    for (size_t i = 0; i < bundle.Count; ++i) {
      const CVector3& offset = bundle.Rays[i].Offset;
      const CVector3& direction = bundle.Rays[i].Direction;
      SPlanarRays::Set(i, position.GetX() + cosine * offset.GetX() - sine * offset.GetY(),
                       position.GetY() + sine * offset.GetX() + cosine * offset.GetY(),
                       cosine * direction.GetX() - sine * direction.GetY(),
                       sine * direction.GetX() + cosine * direction.GetY());
      Z[i] = position.GetZ() + offset.GetZ();
      MinZ = std::min(MinZ, Z[i]);
      MaxZ = std::max(MaxZ, Z[i]);
      HaveLengths = HaveLengths && SquareLength[i] > 0.0;
    }
  }

  bool ReachHeightOf(const SIndexedShape& shape) const {
    return shape.ZMin <= MaxZ && shape.ZMax >= MinZ;
  }
  // true if CDiscEntries can test the solid
  bool CanEnter(const SIndexedShape& shape) const {
    return shape.Kind == SIndexedShape::EKind::Disc && shape.ZMin <= MinZ && shape.ZMax >= MaxZ &&
           HaveLengths;
  }

  // tests the rays one by one
  void Meet(const SIndexedShape& shape, size_t count, const CBodyIndex& index,
            Real* fractions) const {
    if (!ReachHeightOf(shape)) {
      return;
    }
    float near[kMaxRays];
    ComputeNearness(shape, count, near);
    for (size_t i = 0; i < count; ++i) {
      if (near[i] < 0.0F) {
        continue;
      }
      const Real fraction =
          shape.Kind == SIndexedShape::EKind::Bounds
              ? index.Intersect(shape, CRay3(CVector3(X[i], Y[i], Z[i]),
                                             CVector3(X[i] + DX[i], Y[i] + DY[i], Z[i])))
              : IntersectHorizontalRay(shape, X[i], Y[i], Z[i], DX[i], DY[i]);
      fractions[i] = std::min(fractions[i], fraction);
    }
  }
};

void CRayCaster::CastUpright(const SRayBundle& bundle, Real* fractions) const {
  const SAnchor& anchor = bundle.FirstAnchor;
  const CVector3& position = anchor.Position;
  // cosine and sine of the yaw: the quaternion is (cos(yaw/2), 0, 0, sin(yaw/2))
  const Real w = anchor.Orientation.GetW();
  const Real z = anchor.Orientation.GetZ();
  const Real cosine = w * w - z * z;
  const Real sine = 2.0 * w * z;
  const CBodyIndex& index = m_space->GetBodyIndex();
  const UInt32 ownBody = m_body->GetBodyNumber();
  // computed for the first solid; no std::optional, which g++ 12 fills with zeros
  SWorldRays rays;
  CDiscEntries<kMaxRays> discs(rays);
  bool isSet = false;
  const auto test = [&](const SIndexedShape& shape) {
    if (shape.Body == ownBody) {
      return;
    }
    if (!isSet) {
      rays.Set(bundle, position, cosine, sine);
      discs.Start(bundle.Count);
      isSet = true;
    }
    if (rays.CanEnter(shape)) {
      discs.Enter(shape);
    } else {
      rays.Meet(shape, bundle.Count, index, fractions);
    }
  };
  const SRayBounds& bounds = bundle.Bounds;
  index.ForShapesNear(position.GetX() + cosine * bounds.CenterX - sine * bounds.CenterY,
                      position.GetY() + sine * bounds.CenterX + cosine * bounds.CenterY,
                      bounds.Reach, test);
  if (isSet) {
    discs.Take(fractions);
  }
}

void CRayCaster::CastOneByOne(const SRayBundle& bundle, Real* fractions) const {
  SEmbodiedEntityIntersectionItem hit;
  for (size_t i = 0; i < bundle.Count; ++i) {
    if (GetClosestEmbodiedEntityIntersectedByRay(hit, MakeWorldRay(bundle, i), *m_body)) {
      fractions[i] = hit.TOnRay;
    }
  }
}

bool CRayCaster::FindHit(const CRay3& ray, Real& fraction) const {
  SEmbodiedEntityIntersectionItem hit;
  const bool found = AreBodiesOutsideIndex()
                         ? GetClosestEmbodiedEntityIntersectedByRay(hit, ray, *m_body)
                         : m_space->GetBodyIndex().FindClosestHit(hit, ray, m_body);
  if (found) {
    fraction = hit.TOnRay;
  }
  return found;
}

bool CRayCaster::AreBodiesOutsideIndex() const {
  return m_space->AreBodiesOutsideIndex();
}

void CRayCaster::Show(const SRayBundle& bundle, const Real* fractions) const {
  for (size_t i = 0; i < bundle.Count; ++i) {
    const CRay3 ray = MakeWorldRay(bundle, i);
    const bool hit = fractions[i] <= 1.0;
    m_robot->AddCheckedRay(hit, ray);
    if (hit) {
      m_robot->AddIntersectionPoint(ray, fractions[i]);
    }
  }
}

CRay3 MakeWorldRay(const SRayBundle& bundle, size_t ray) {
  const SAnchor& anchor = *bundle.Anchors[bundle.Rays[ray].Anchor];
  CVector3 start = bundle.Rays[ray].Offset;
  start.Rotate(anchor.Orientation);
  start += anchor.Position;
  CVector3 direction = bundle.Rays[ray].Direction;
  direction.Rotate(anchor.Orientation);
  return CRay3(start, start + direction);
}

}  // namespace argos
