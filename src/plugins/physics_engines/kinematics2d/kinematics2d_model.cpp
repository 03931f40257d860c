#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematics2d_model.h>

#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematics2d_engine.h>

namespace argos {

CKinematics2DModel::CKinematics2DModel(CKinematics2DEngine& engine, CEmbodiedEntity& entity,
                                       const CDriveSource& drive)
    : CPlanarModel(engine, entity, drive) {}

}  // namespace argos
