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

void CPlanarModel::CalculateBoundingBox() {
  m_sBoundingBox = ComputePlanarBounds(m_cEmbodiedEntity);
}

}  // namespace argos
