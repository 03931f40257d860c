#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_body.h>

#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_engine.h>

namespace argos {

CPointMass3DBody::CPointMass3DBody(CPointMass3DEngine& engine, CEmbodiedEntity& entity, EKind kind,
                                   const CDriveSource& drive)
    : CRobotBodyModel(engine, entity, drive), m_kind(kind) {}

}  // namespace argos
