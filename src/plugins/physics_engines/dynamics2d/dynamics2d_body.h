#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_DYNAMICS2D_BODY_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_DYNAMICS2D_BODY_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_handle.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_model.h>

namespace argos {

class CDynamics2DEngine;

/** One body of a dynamics2d engine, for the public API: its state is in the engine's arrays. */
class CDynamics2DBody : public CPlanarModel {
 public:
  CDynamics2DBody(CDynamics2DEngine& engine, CEmbodiedEntity& entity, const CDriveSource& drive);

 private:
  friend class CDynamics2DEngine;

  SPlanarHandle m_handle;  // of the body in the engine's arrays
};

}  // namespace argos

#endif
