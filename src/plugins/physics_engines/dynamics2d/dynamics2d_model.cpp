#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_model.h>

#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_engine.h>

namespace argos {

CDynamics2DModel::CDynamics2DModel(CDynamics2DEngine& engine, CEmbodiedEntity& entity,
                                   const Real* wheels)
    : CPlanarModel(engine, entity, wheels) {}

CDynamics2DEngine& CDynamics2DModel::GetDynamics2DEngine() const {
  return static_cast<CDynamics2DEngine&>(m_cEngine);
}

void CDynamics2DModel::Replace() {
  GetDynamics2DEngine().MarkDisplaced(*this);
}

void CDynamics2DModel::ConfirmMove() {
  GetDynamics2DEngine().Replace(*this);
}

}  // namespace argos
