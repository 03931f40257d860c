#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_box_model.h>

namespace argos {

CDynamics2DBoxModel::CDynamics2DBoxModel(CDynamics2DEngine& engine, CBoxEntity& entity)
    : CDynamics2DStretchableObjectModel(engine, entity) {
  const CVector3& size = entity.GetSize();
  cpSpace* const space = engine.GetPhysicsSpace();
  cpBody* const body =
      entity.GetEmbodiedEntity().IsMovable()
          ? cpSpaceAddBody(space,
                           cpBodyNew(entity.GetMass(),
                                     cpMomentForBox(entity.GetMass(), size.GetX(), size.GetY())))
          : cpBodyNewStatic();
  cpShape* const shape = cpSpaceAddShape(space, cpBoxShapeNew(body, size.GetX(), size.GetY()));
  SetBody(body, size.GetZ());
  SetLinearFriction(0.0, engine.GetBoxLinearFriction());
  SetAngularFriction(0.0, engine.GetBoxAngularFriction());
  SetGrippable(std::make_unique<CDynamics2DGrippable>(entity.GetEmbodiedEntity(), shape).release());
}

}  // namespace argos
