#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_body.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_engine.h>

namespace argos {

CPointMass3DBody::CPointMass3DBody(CPointMass3DEngine& engine, CEmbodiedEntity& entity, EKind kind)
    : CDescribedBodyModel(engine, entity), m_root(entity.GetRootEntity()), m_kind(kind) {}

void CPointMass3DBody::Replace() {
  static_cast<CPointMass3DEngine&>(m_cEngine).Replace(*this);
}

}  // namespace argos
