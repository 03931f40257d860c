#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_DYNAMICS2D_MODEL_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_DYNAMICS2D_MODEL_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_handle.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_model.h>

namespace argos {

class CDynamics2DEngine;

/** One body of a dynamics2d engine, for the public API: its state is in the engine's arrays. */
class CDynamics2DModel : public CPlanarModel {
 public:
  /** @param wheels  speeds of the left and the right wheel, m/s, if the body has a drive. */
  CDynamics2DModel(CDynamics2DEngine& engine, CEmbodiedEntity& entity, const Real* wheels);

 private:
  friend class CDynamics2DEngine;

  SPlanarHandle m_handle;  // of the body in the engine's arrays
};

}  // namespace argos

#endif
