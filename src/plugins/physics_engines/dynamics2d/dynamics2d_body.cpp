#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_body.h>

#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_engine.h>

namespace argos {

CDynamics2DBody::CDynamics2DBody(CDynamics2DEngine& engine, CEmbodiedEntity& entity,
                                 const CDriveSource& drive)
    : CPlanarModel(engine, entity, drive) {}

}  // namespace argos
