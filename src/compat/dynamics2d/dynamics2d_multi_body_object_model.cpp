#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_multi_body_object_model.h>

namespace argos {

CDynamics2DMultiBodyObjectModel::CDynamics2DMultiBodyObjectModel(CDynamics2DEngine& engine,
                                                                 CComposableEntity& entity)
    : CDynamics2DModel(engine, entity.GetComponent<CEmbodiedEntity>("body")), m_cEntity(entity) {}

void CDynamics2DMultiBodyObjectModel::Reset() {
  CDynamics2DModel::Reset();
}

void CDynamics2DMultiBodyObjectModel::AddBody(cpBody* body, const cpVect& offsetPos,
                                              cpFloat offsetOrient, Real height) {
  AddPart(body, offsetPos, offsetOrient, height);
  m_vecBodies.emplace_back(body, offsetPos, offsetOrient, height);
}

}  // namespace argos
