#include <argos3/plugins/robots/generic/simulator/proximity_rays.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/body_index.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

namespace argos {

namespace {

constexpr Real kMiss = 2.0;  // any fraction above 1

}  // namespace

void CProximityRays::SetRobot(CComposableEntity& robot) {
  m_sensors = &robot.GetComponent<CProximitySensorEquippedEntity>("proximity_sensors");
  m_body = &robot.GetComponent<CEmbodiedEntity>("body");
  m_robot = &robot.GetComponent<CControllableEntity>("controller");
  m_space = &m_robot->GetSpace();
  m_sensors->Enable();
}

void CProximityRays::Init(TConfigurationNode& tree) {
  GetNodeAttributeOrDefault(tree, "show_rays", m_showRays, false);
  GetNodeAttributeOrDefault(tree, "noise_level", m_noiseLevel, 0.0);
  RequireNotNegative(m_noiseLevel, OwnerOf(tree), "attribute \"noise_level\"");
  MakeNoise();
}

void CProximityRays::Reset() {
  MakeNoise();
}

void CProximityRays::MakeNoise() {
  if (m_noiseLevel > 0.0) {
    m_noise = std::make_unique<CRandomStream>(m_robot->GetSimulator().GetRandomSeed(), "argos",
                                              m_robot->GetRootEntity().GetId(), "proximity noise");
  }
}

void CProximityRays::RequireNumRays(size_t num, const std::string& device) const {
  if (GetNumRays() != num) {
    THROW_ARGOSEXCEPTION(
        "sensor \"" << device << "\" needs a robot with " << num << " proximity sensors; robot \""
                    << m_robot->GetRootEntity().GetId() << "\" has " << GetNumRays());
  }
}

void CProximityRays::Cast(size_t first, size_t count, Real* distances) {
  const TLayout& layout = m_sensors->GetLayout();
  if (&layout != m_layout) {
    m_layout = &layout;
    m_anchor = &m_sensors->GetAnchor(layout.Rays.front().Anchor);
  }
  std::fill_n(distances, count, kMiss);
  const CQuaternion& orientation = m_anchor->Orientation;
  const bool upright = orientation.GetX() == 0.0 && orientation.GetY() == 0.0;
  if (layout.Planar && upright && !AreBodiesOutsideIndex()) {
    CastUpright(layout, first, count, distances);
  } else {
    CastOneByOne(layout, first, count, distances);
  }
  if (m_showRays) {
    Show(layout, first, count, distances);
  }
  for (size_t i = 0; i < count; ++i) {
    distances[i] =
        distances[i] <= 1.0 ? distances[i] * layout.Rays[first + i].Direction.Length() : -1.0;
  }
}

void CProximityRays::CastUpright(const TLayout& layout, size_t first, size_t count,
                                 Real* fractions) const {
  const CVector3& position = m_anchor->Position;
  // of the yaw: the quaternion is (cos(yaw/2), 0, 0, sin(yaw/2))
  const Real w = m_anchor->Orientation.GetW();
  const Real z = m_anchor->Orientation.GetZ();
  const Real cosine = w * w - z * z;
  const Real sine = 2.0 * w * z;
  const CBodyIndex& index = m_space->GetBodyIndex();
  const UInt32 ownBody = m_body->GetBodyNumber();

  // world frame, m; computed when the first solid shows up
  struct SWorldRay {
    Real X, Y, Z, DX, DY;
  };
  SWorldRay rays[kBatch];
  bool raysAreReady = false;
  const auto makeRays = [&] {
    for (size_t i = 0; i < count; ++i) {
      const CVector3& offset = layout.Rays[first + i].Offset;
      const CVector3& direction = layout.Rays[first + i].Direction;
      rays[i].X = position.GetX() + cosine * offset.GetX() - sine * offset.GetY();
      rays[i].Y = position.GetY() + sine * offset.GetX() + cosine * offset.GetY();
      rays[i].Z = position.GetZ() + offset.GetZ();
      rays[i].DX = cosine * direction.GetX() - sine * direction.GetY();
      rays[i].DY = sine * direction.GetX() + cosine * direction.GetY();
    }
    raysAreReady = true;
  };
  const auto test = [&](const SIndexedShape& shape) {
    if (shape.Body == ownBody) {
      return;
    }
    if (!raysAreReady) {
      makeRays();
    }
    for (size_t i = 0; i < count; ++i) {
      const SWorldRay& ray = rays[i];
      const Real fraction =
          shape.Kind == SIndexedShape::EKind::Tilted
              ? index.Intersect(shape, CRay3(CVector3(ray.X, ray.Y, ray.Z),
                                             CVector3(ray.X + ray.DX, ray.Y + ray.DY, ray.Z)))
              : IntersectHorizontalRay(shape, ray.X, ray.Y, ray.Z, ray.DX, ray.DY);
      fractions[i] = std::min(fractions[i], fraction);
    }
  };
  index.ForShapesNear(position.GetX() + cosine * layout.CenterX - sine * layout.CenterY,
                      position.GetY() + sine * layout.CenterX + cosine * layout.CenterY,
                      layout.Reach, test);
}

void CProximityRays::CastOneByOne(const TLayout& layout, size_t first, size_t count,
                                  Real* fractions) const {
  SEmbodiedEntityIntersectionItem hit;
  for (size_t i = 0; i < count; ++i) {
    if (GetClosestEmbodiedEntityIntersectedByRay(hit, MakeRay(layout, first + i), *m_body)) {
      fractions[i] = hit.TOnRay;
    }
  }
}

bool CProximityRays::AreBodiesOutsideIndex() const {
  for (const CPhysicsEngine* engine : m_space->GetSimulator().GetPhysicsEngines()) {
    if (engine->HasBodiesOutsideIndex()) {
      return true;
    }
  }
  return false;
}

CRay3 CProximityRays::MakeRay(const TLayout& layout, size_t ray) const {
  const SAnchor& anchor = m_sensors->GetAnchor(layout.Rays[ray].Anchor);
  CVector3 start = layout.Rays[ray].Offset;
  start.Rotate(anchor.Orientation);
  start += anchor.Position;
  CVector3 direction = layout.Rays[ray].Direction;
  direction.Rotate(anchor.Orientation);
  return CRay3(start, start + direction);
}

void CProximityRays::Show(const TLayout& layout, size_t first, size_t count,
                          const Real* fractions) {
  for (size_t i = 0; i < count; ++i) {
    const CRay3 ray = MakeRay(layout, first + i);
    const bool hit = fractions[i] <= 1.0;
    m_robot->AddCheckedRay(hit, ray);
    if (hit) {
      m_robot->AddIntersectionPoint(ray, fractions[i]);
    }
  }
}

}  // namespace argos
