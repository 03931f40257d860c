#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_model.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/body_description.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_engine.h>
#include <argos3/core/simulator/physics_engine/planar_motion.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// half the size of the box, with sides along the world's axes, around a solid that is turned, m
CVector2 ComputeHalfExtents(const SShapeDescription& shape, const SPlanarPose& pose) {
  const CQuaternion& turn = shape.Orientation;
  if (turn.GetX() != 0.0 || turn.GetY() != 0.0) {
    // it does not stand upright: no point of it is farther from its base's centre
    const Real reach = shape.Size.Length();
    return CVector2(reach, reach);
  }
  if (shape.Kind != SShapeDescription::EKind::Box) {
    return CVector2(shape.Radius, shape.Radius);
  }
  const Real yaw = pose.ComputeYaw() + 2.0 * std::atan2(turn.GetZ(), turn.GetW());
  const Real cosine = std::abs(std::cos(yaw));
  const Real sine = std::abs(std::sin(yaw));
  return CVector2(0.5 * (cosine * shape.Size.GetX() + sine * shape.Size.GetY()),
                  0.5 * (sine * shape.Size.GetX() + cosine * shape.Size.GetY()));
}

}  // namespace

CDynamics2DModel::CDynamics2DModel(CDynamics2DEngine& engine, CEmbodiedEntity& entity,
                                   const Real* wheels)
    : CDescribedBodyModel(engine, entity), m_root(entity.GetRootEntity()), m_wheels(wheels) {
  // those that are made on demand, later, are told of
  if (const auto* const robot = dynamic_cast<CComposableEntity*>(&m_root)) {
    for (CEntity* component : robot->GetExistingComponents()) {
      SetComponent(*component, true);
    }
  }
}

CDynamics2DEngine& CDynamics2DModel::GetDynamics2DEngine() const {
  return static_cast<CDynamics2DEngine&>(m_cEngine);
}

void CDynamics2DModel::Replace() {
  GetDynamics2DEngine().MarkDisplaced(*this);
}

void CDynamics2DModel::ConfirmMove() {
  GetDynamics2DEngine().Replace(*this);
}

void CDynamics2DModel::ComponentAdded(CEntity& component) {
  SetComponent(component, true);
  GetDynamics2DEngine().UpdateManipulator(*this);
}

void CDynamics2DModel::ComponentRemoved(CEntity& component) {
  SetComponent(component, false);
  GetDynamics2DEngine().UpdateManipulator(*this);
}

void CDynamics2DModel::SetComponent(CEntity& component, bool isThere) {
  if (auto* const gripper = dynamic_cast<CGripperEquippedEntity*>(&component)) {
    m_gripper = isThere ? gripper : nullptr;
  } else if (auto* const turret = dynamic_cast<CTurretEntity*>(&component)) {
    m_turret = isThere ? turret : nullptr;
  }
}

void CDynamics2DModel::CalculateBoundingBox() {
  const SAnchor& origin = m_cEmbodiedEntity.GetOriginAnchor();
  const SPlanarPose pose = MakePlanarPose(origin.Position, origin.Orientation);
  const Real cosine = pose.HalfCos * pose.HalfCos - pose.HalfSin * pose.HalfSin;
  const Real sine = 2.0 * pose.HalfSin * pose.HalfCos;
  bool first = true;
  for (const SShapeDescription& shape : m_cEmbodiedEntity.GetBodyDescription()->Shapes) {
    const CVector2 half = ComputeHalfExtents(shape, pose);
    const CVector3 base(
        origin.Position.GetX() + cosine * shape.Offset.GetX() - sine * shape.Offset.GetY(),
        origin.Position.GetY() + sine * shape.Offset.GetX() + cosine * shape.Offset.GetY(),
        origin.Position.GetZ() + shape.Offset.GetZ());
    const CVector3 low = base - CVector3(half.GetX(), half.GetY(), 0.0);
    const CVector3 high = base + CVector3(half.GetX(), half.GetY(), shape.Size.GetZ());
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

}  // namespace argos
