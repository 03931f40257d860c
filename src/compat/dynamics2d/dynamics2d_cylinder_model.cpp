#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_cylinder_model.h>

namespace argos {

CDynamics2DCylinderModel::CDynamics2DCylinderModel(CDynamics2DEngine& engine,
                                                   CCylinderEntity& entity)
    : CDynamics2DStretchableObjectModel(engine, entity) {
  cpSpace* const space = engine.GetPhysicsSpace();
  cpBody* const body =
      entity.GetEmbodiedEntity().IsMovable()
          ? cpSpaceAddBody(
                space, cpBodyNew(entity.GetMass(), cpMomentForCircle(entity.GetMass(), 0.0,
                                                                     entity.GetRadius(), cpvzero)))
          : cpBodyNewStatic();
  cpShape* const shape =
      cpSpaceAddShape(space, cpCircleShapeNew(body, entity.GetRadius(), cpvzero));
  SetBody(body, entity.GetHeight());
  SetLinearFriction(0.0, engine.GetCylinderLinearFriction());
  SetAngularFriction(0.0, engine.GetCylinderAngularFriction());
  SetGrippable(std::make_unique<CDynamics2DGrippable>(entity.GetEmbodiedEntity(), shape).release());
}

}  // namespace argos
