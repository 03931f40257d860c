#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATICS2D_MODEL_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATICS2D_MODEL_H

#include <argos3/core/utility/memory/object_slabs.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_handle.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_model.h>

namespace argos {

class CKinematics2DEngine;

/** One body of a kinematics2d engine, for the public API: its state is in the engine's arrays. */
class CKinematics2DModel : public CPlanarModel, public CSlabObject {
 public:
  CKinematics2DModel(CKinematics2DEngine& engine, CEmbodiedEntity& entity,
                     const CDriveSource& drive);

 private:
  friend class CKinematics2DEngine;

  SKinematicHandle m_handle;  // of the body in the engine's arrays
  bool m_isManipulator = false;  // in the engine's list of models with a manipulator
};

}  // namespace argos

#endif
