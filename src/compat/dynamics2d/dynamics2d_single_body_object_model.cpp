#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_single_body_object_model.h>

namespace argos {

CDynamics2DSingleBodyObjectModel::CDynamics2DSingleBodyObjectModel(CDynamics2DEngine& engine,
                                                                   CComposableEntity& entity)
    : CDynamics2DModel(engine, entity.GetComponent<CEmbodiedEntity>("body")), m_cEntity(entity) {}

void CDynamics2DSingleBodyObjectModel::Reset() {
  CDynamics2DModel::Reset();
}

void CDynamics2DSingleBodyObjectModel::SetBody(cpBody* body, Real height) {
  if (m_ptBody != nullptr) {
    THROW_ARGOSEXCEPTION(
        "SetBody() is called twice: a model with several bodies derives from "
        "CDynamics2DMultiBodyObjectModel");
  }
  AddPart(body, cpvzero, 0.0, height);
  m_ptBody = body;
}

}  // namespace argos
