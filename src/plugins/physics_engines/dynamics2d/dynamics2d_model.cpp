#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_model.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/body_description.h>
#include <argos3/core/simulator/space/body_index.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_bodies.h>

#include <cmath>

namespace argos {

CDynamics2DModel::CDynamics2DModel(CDynamics2DEngine& engine, CEmbodiedEntity& entity)
    : CPhysicsModel(engine, entity), m_engine(engine) {
  CalculateBoundingBox();
}

void CDynamics2DModel::MoveTo(const CVector3&, const CQuaternion&) {
  // the origin anchor has the new pose already
  m_engine.Replace(*this);
  CalculateAnchors();
  CalculateBoundingBox();
}

void CDynamics2DModel::CalculateBoundingBox() {
  const SAnchor& origin = m_cEmbodiedEntity.GetOriginAnchor();
  const SBodyDescription& description = *m_cEmbodiedEntity.GetBodyDescription();
  const Real w = origin.Orientation.GetW();
  const Real z = origin.Orientation.GetZ();
  const Real cosine = w * w - z * z;
  const Real sine = 2.0 * w * z;
  bool first = true;
  for (const SShapeDescription& shape : description.Shapes) {
    Real reachX = shape.Radius;
    Real reachY = shape.Radius;
    if (shape.Kind == SShapeDescription::EKind::Box) {
      const Real c = std::abs(cosine);
      const Real s = std::abs(sine);
      reachX = 0.5 * (c * shape.Size.GetX() + s * shape.Size.GetY());
      reachY = 0.5 * (s * shape.Size.GetX() + c * shape.Size.GetY());
    }
    const CVector3 base(cosine * shape.Offset.GetX() - sine * shape.Offset.GetY(),
                        sine * shape.Offset.GetX() + cosine * shape.Offset.GetY(),
                        shape.Offset.GetZ());
    const CVector3 low = origin.Position + base - CVector3(reachX, reachY, 0.0);
    const CVector3 high = origin.Position + base + CVector3(reachX, reachY, shape.Size.GetZ());
    if (first) {
      m_sBoundingBox.MinCorner = low;
      m_sBoundingBox.MaxCorner = high;
      first = false;
      continue;
    }
    for (UInt32 axis = 0; axis < 3; ++axis) {
      m_sBoundingBox.MinCorner[axis] = std::min(m_sBoundingBox.MinCorner[axis], low[axis]);
      m_sBoundingBox.MaxCorner[axis] = std::max(m_sBoundingBox.MaxCorner[axis], high[axis]);
    }
  }
}

bool CDynamics2DModel::IsCollidingWithSomething() const {
  const SAnchor& origin = m_cEmbodiedEntity.GetOriginAnchor();
  return m_engine.GetSpace().GetBodyIndex().FindOverlap(
             *m_cEmbodiedEntity.GetBodyDescription(), origin.Position, origin.Orientation,
             m_cEmbodiedEntity.GetBodyNumber()) != CBodyIndex::kNoBody;
}

}  // namespace argos
