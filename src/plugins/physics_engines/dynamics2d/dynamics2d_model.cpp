#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_model.h>

#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_engine.h>

namespace argos {

CDynamics2DModel::CDynamics2DModel(CDynamics2DEngine& engine, CEmbodiedEntity& entity,
                                   const Real* wheels)
    : CPlanarModel(engine, entity, wheels) {}

}  // namespace argos
