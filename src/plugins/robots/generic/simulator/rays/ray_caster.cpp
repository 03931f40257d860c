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
#include <array>
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

// Casts the rays of one robot, whose anchor stands upright.
class CRayCaster::CUprightCast {
 public:
  CUprightCast(const SRayBundle& bundle, const CBodyIndex& index, UInt32 ownBody, Real* fractions)
      : m_bundle(bundle), m_index(index), m_ownBody(ownBody), m_fractions(fractions) {
    const SAnchor& anchor = bundle.FirstAnchor;
    // the quaternion is (cos(yaw/2), 0, 0, sin(yaw/2))
    const Real w = anchor.Orientation.GetW();
    const Real z = anchor.Orientation.GetZ();
    m_pose = {anchor.Position.GetX(), anchor.Position.GetY(), w * w - z * z, 2.0 * w * z};
    m_z = anchor.Position.GetZ();
    m_minZ = m_z + bundle.Bounds.MinZ;
    m_maxZ = m_z + bundle.Bounds.MaxZ;
  }

  void Run() {
    const SRayBounds& bounds = m_bundle.Bounds;
    const Real x = m_pose.X + m_pose.Cos * bounds.CenterX - m_pose.Sin * bounds.CenterY;
    const Real y = m_pose.Y + m_pose.Sin * bounds.CenterX + m_pose.Cos * bounds.CenterY;
    const Real reach = bounds.Reach;
    const auto meet = [this, x, y, reach](const SIndexedShape& shape) {
      const Real dx = shape.X - x;
      const Real dy = shape.Y - y;
      const Real far = reach + shape.Radius;
      if (dx * dx + dy * dy <= far * far && shape.Body != m_ownBody) {
        Meet(shape);
      }
    };
    if (bounds.HaveLengths) {
      m_index.ListDiscsNear(
          {x, y, reach, m_minZ, m_maxZ, m_ownBody}, m_discs, [this] { EnterListedDiscs(); }, meet);
      EnterListedDiscs();
    } else {
      m_index.ForShapesNear(x, y, reach, meet);
    }
  }

 private:
  void EnterListedDiscs() {
    if (m_discs.Size > 0) {
      const SRayBlock* block = m_bundle.Blocks;
      size_t first = 0;
      for (; first + SRayBlock::kSize <= m_bundle.Count; first += SRayBlock::kSize) {
        EnterDiscs(*block++, m_pose, m_discs, m_fractions + first);
      }
      if (first < m_bundle.Count) {
        Real last[SRayBlock::kSize] = {};
        std::copy(m_fractions + first, m_fractions + m_bundle.Count, last);
        EnterDiscs(*block, m_pose, m_discs, last);
        std::copy_n(last, m_bundle.Count - first, m_fractions + first);
      }
      m_discs.Size = 0;
    }
  }

  // tests the rays one by one
  void Meet(const SIndexedShape& shape) {
    if (shape.ZMin > m_maxZ || shape.ZMax < m_minZ) {
      return;
    }
    if (!m_areRaysSet) {
      SetRays();
    }
    const SPlanarRays<kMaxRays>& rays = m_rays;
    float near[kMaxRays];
    rays.ComputeNearness(shape, m_bundle.Count, near);
    for (size_t i = 0; i < m_bundle.Count; ++i) {
      if (near[i] < 0.0F) {
        continue;
      }
      const Real z = m_z + m_bundle.Rays[i].Offset.GetZ();
      const Real fraction =
          shape.Kind == SIndexedShape::EKind::Bounds
              ? m_index.Intersect(
                    shape, CRay3(CVector3(rays.X[i], rays.Y[i], z),
                                 CVector3(rays.X[i] + rays.DX[i], rays.Y[i] + rays.DY[i], z)))
              : IntersectHorizontalRay(shape, rays.X[i], rays.Y[i], z, rays.DX[i], rays.DY[i]);
      m_fractions[i] = std::min(m_fractions[i], fraction);
    }
  }

  void SetRays() {
    m_rays.SetCenter(m_pose.X, m_pose.Y);
    for (size_t i = 0; i < m_bundle.Count; ++i) {
      const CVector3& offset = m_bundle.Rays[i].Offset;
      const CVector3& direction = m_bundle.Rays[i].Direction;
      m_rays.Set(i, m_pose.X + m_pose.Cos * offset.GetX() - m_pose.Sin * offset.GetY(),
                 m_pose.Y + m_pose.Sin * offset.GetX() + m_pose.Cos * offset.GetY(),
                 m_pose.Cos * direction.GetX() - m_pose.Sin * direction.GetY(),
                 m_pose.Sin * direction.GetX() + m_pose.Cos * direction.GetY());
    }
    m_areRaysSet = true;
  }

  const SRayBundle& m_bundle;
  const CBodyIndex& m_index;
  UInt32 m_ownBody;
  Real* m_fractions;
  SUprightPose m_pose;  // pose of the anchor
  Real m_z;  // m, of the anchor
  Real m_minZ, m_maxZ;  // m, world frame, of the rays
  SDiscList m_discs;  // discs to test
  // tests solids of other kinds
  SPlanarRays<kMaxRays> m_rays;
  bool m_areRaysSet = false;
};

void CRayCaster::CastUpright(const SRayBundle& bundle, Real* fractions) const {
  CUprightCast(bundle, m_space->GetBodyIndex(), m_body->GetBodyNumber(), fractions).Run();
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

bool CRayCaster::IsBlocked(const CRay3& ray) const {
  if (AreBodiesOutsideIndex()) {
    Real fraction = 1.0;
    return FindHit(ray, fraction);
  }
  const CBodyIndex& index = m_space->GetBodyIndex();
  const UInt32 ownBody = m_body->GetBodyNumber();
  const CVector3& start = ray.GetStart();
  const CVector3 way = ray.GetEnd() - start;
  const Real squareLength = way.GetX() * way.GetX() + way.GetY() * way.GetY();
  bool isBlocked = false;
  index.ForShapesAlongRays(
      std::array{ray}, SRayReach(),
      [&](const SIndexedShape& shape) {
        // rejects most solids, with a margin for rounding: the exact test decides
        const bool isNear =
            IsCircleOnLine(shape.X - start.GetX(), shape.Y - start.GetY(), way.GetX(), way.GetY(),
                           shape.Radius * shape.Radius, squareLength * (1.0 + 1e-6));
        isBlocked =
            isBlocked || (isNear && shape.Body != ownBody && index.Intersect(shape, ray) <= 1.0);
      },
      [&isBlocked] { return isBlocked; });
  return isBlocked;
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
