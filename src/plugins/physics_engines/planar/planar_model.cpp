#include <argos3/plugins/simulator/physics_engines/planar/planar_model.h>

#include <argos3/plugins/simulator/physics_engines/planar/planar_body.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_engine.h>

namespace argos {

CPlanarModel::CPlanarModel(CPlanarEngine& engine, CEmbodiedEntity& entity,
                           const CDriveSource& drive)
    : CRobotBodyModel(engine, entity, drive) {}

void CPlanarModel::ManipulatorChanged() {
  static_cast<CPlanarEngine&>(GetEngine()).UpdateManipulator(*this);
}

SBodyPose CPlanarModel::FindPossiblePose(const SBodyPose& pose) const {
  SBodyPose onPlane = pose;
  onPlane.Position.SetZ(static_cast<const CPlanarEngine&>(GetEngine()).GetElevation());
  // the yaw of an upright body keeps all its bits
  if (pose.Orientation.GetX() != 0.0 || pose.Orientation.GetY() != 0.0) {
    const SPlanarPose planar = MakePlanarPose(pose.Position, pose.Orientation);
    onPlane.Orientation = CQuaternion(planar.HalfCos, 0.0, 0.0, planar.HalfSin);
  }
  return onPlane;
}

void CPlanarModel::CalculateBoundingBox() {
  m_sBoundingBox = ComputePlanarBounds(m_cEmbodiedEntity);
}

}  // namespace argos
